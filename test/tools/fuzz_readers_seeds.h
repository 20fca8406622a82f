// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

// Small valid files of each format that use all features of the readers.

namespace fuzz {

template <class Number>
void append_bytes(std::string& bytes, Number number, bool reversed = false)
{
  char copy[sizeof(Number)];
  std::memcpy(copy, &number, sizeof(Number));
  for (std::size_t i = 0; i < sizeof(Number); ++i)
    bytes += copy[reversed ? sizeof(Number) - 1 - i : i];
}

inline std::vector<std::string> off_seeds()
{
  return {
      "OFF\n# a tetrahedron\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 "
      "3\n",
      "STCNOFF 4 2 0\n0 0 0 0 0 1 255 0 0 255 0 0\n1 0 0 0 0 1 0 255 0 255 1 0\n"
      "1 1 0 0 0 1 0 0 255 255 1 1\n0 1 0 0 0 1 9 9 9 255 0 1\n3 0 1 2 0.5 0.25 1\n3 0 2 3 1\n",
      "  OFF\n5 1 5\n0 0 0 1 2 3\n1 0 0 1 2 3\n2 1 0 1 2 3\n1 2 0 1 2 3\n0 1 1e-3 1 2 3\n"
      "5\n0\n1\n2\n3\n4\n"};
}

inline std::vector<std::string> obj_seeds()
{
  return {
      "# a square\nmtllib a.mtl\no square\nv 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 1 1 0 0 0 1\nv 0 1 0 "
      "nan 0 0\n"
      "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\nusemtl red\ns 1\nf 1/1/1 2/2/1 3/3/1\ng two\nf "
      "1/1/1 3/3/1 4/4/1\n",
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 0 0 1\nf 1 \\\n2 \\\n4\nf 1// 4// 3//\nl 1 2\np "
      "1\n",
      "v 0 0 0 1\r\nv 1 0 0 1\r\nv 0 1 0 1\r\nvt 0.5\r\nvt 0.5 0.25 0\r\nvn 1 2 3\r\nf 1//1 2//1 "
      "3//1\r\nf 3/1 2/2 1/2\r\n",
      "v 0 0 0 1 0 0\nv 1 0 0 0.5\nv 0 1 0 x\nvt 0 0 0 1\nvt\nvn 1 2\nt crease 1/1/0 1 2\nvw 0 0 "
      "1\n"
      "f 1/1/1 2/9/9 3/2/-7\nf 1/0 3///4 2/x\n"};
}

inline std::string binary_ply(bool big)
{
  std::string text =
      std::string("ply\nformat binary_") + (big ? "big" : "little") +
      "_endian 1.0\ncomment TextureFile a.png\nelement vertex 4\nproperty float x\n"
      "property float y\nproperty double z\nproperty uchar red\nproperty uchar green\n"
      "property uchar blue\nelement face 2\nproperty list uchar int vertex_indices\n"
      "property list uchar float texcoord\nelement edge 1\nproperty int vertex1\n"
      "property ushort vertex2\nend_header\n";
  for (int v = 0; v < 4; ++v) {
    append_bytes(text, static_cast<float>(v % 2), big);
    append_bytes(text, static_cast<float>(v / 2), big);
    append_bytes(text, 0.25 * v, big);
    for (int i = 0; i < 3; ++i) text += static_cast<char>(50 * i);
  }
  const int faces[2][3] = {{0, 1, 3}, {0, 3, 2}};
  for (const auto& face : faces) {
    text += '\3';
    for (const int corner : face) append_bytes(text, corner, big);
    text += '\6';
    for (int i = 0; i < 6; ++i) append_bytes(text, 0.125f * static_cast<float>(i), big);
  }
  append_bytes(text, 1, big);
  append_bytes(text, std::uint16_t{2}, big);
  return text;
}

inline std::vector<std::string> ply_seeds()
{
  return {
      "ply\nformat ascii 1.0\ncomment TextureFile a.png\nobj_info made by hand\nelement vertex 4\n"
      "property float x\nproperty float y\nproperty float z\nproperty float quality\n"
      "property float texture_u\nproperty float texture_v\nelement face 2\n"
      "property list uchar int vertex_indices\nproperty list uchar float texcoord\nproperty int "
      "label\n"
      "end_header\n0 0 0 0.5 0 0\n1 0 0 nan 1 0\n1 1 0 1 1 1\n0 1 0 2 0 1\n"
      "3 0 1 2 6 0 0 1 0 1 1 7\n3 0 2 3 0 -7\n",
      binary_ply(false), binary_ply(true),
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\n"
      "property double z\nelement tristrips 1\nproperty list int int vertex_indices\nend_header\n"
      "0 0 0\n1 0 0\n0 1 0\n1 1 0\n8 0 1 2 3 -1 0 2 1\n"};
}

inline std::string binary_stl()
{
  std::string text(80, ' ');
  append_bytes(text, std::uint32_t{4});
  const int points[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const int faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  for (const auto& face : faces) {
    for (int i = 0; i < 3; ++i) append_bytes(text, 0.0f);
    for (const int corner : face)
      for (const int x : points[corner]) append_bytes(text, static_cast<float>(x));
    append_bytes(text, std::uint16_t{5});
  }
  return text;
}

inline std::vector<std::string> stl_seeds()
{
  return {
      "solid two\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
      "0\nendloop\n"
      "endfacet\nfacet normal nan nan nan\nouter loop\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\n"
      "endloop\nendfacet\nendsolid two\n",
      binary_stl()};
}

/// a square as bytes, the most significant one first
inline std::string binary_vtk()
{
  std::string text =
      "# vtk DataFile Version 3.0\na square\nBINARY\nDATASET POLYDATA\nPOINTS 4 double\n";
  for (const double x : {0., 0., 0., 1., 0., 0., 1., 1., 0., 0., 1., 0.})
    append_bytes(text, x, true);
  text += "\nPOLYGONS 2 8\n";
  for (const int i : {3, 0, 1, 2, 3, 0, 2, 3}) append_bytes(text, i, true);
  text += "\nPOINT_DATA 4\nSCALARS rho float\nLOOKUP_TABLE default\n";
  for (const float x : {0.f, .5f, 1.f, 2.f}) append_bytes(text, x, true);
  return text + "\n";
}

/// as texts of the versions 3 and 5, and as bytes
inline std::vector<std::string> vtk_seeds()
{
  return {
      "# vtk DataFile Version 3.0\na square\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n0 0 0 1 0 0\n"
      "1 1 0 0 1 0\nLINES 1 3\n2 0 1\nPOLYGONS 2 8\n3 0 1 2\n3 0 2 3\nPOINT_DATA 4\n"
      "SCALARS rho double 1\nLOOKUP_TABLE default\n0 .5 1 2\nVECTORS wind float\n1 0 0 0 1 0 0 0 "
      "1 1 1 1\nTEXTURE_COORDINATES t 2 float\n0 0 1 0 1 1 0 1\nCOLOR_SCALARS c 3\n1 0 0 0 1 0 "
      "0 0 1 .5 .5 .5\nCELL_DATA 3\nFIELD FieldData 1\nan%20id 1 3 int\n-1 7 8\n",
      "# vtk DataFile Version 5.1\na square\nASCII\nDATASET POLYDATA\nPOINTS 4 double\n0 0 0 1 0 "
      "0\n"
      "1 1 0 0 1 0\nMETADATA\nINFORMATION 0\n\nPOLYGONS 3 7\nOFFSETS vtktypeint64\n0 3 7\n"
      "CONNECTIVITY vtktypeint64\n0 1 2 0 1 2 3\nPOINT_DATA 4\nNORMALS n double\n0 0 1 0 0 1 0 0 1 "
      "0 0 1\nFIELD FieldData 1\nid 1 4 vtktypeint64\n1 2 3 4\nMETADATA\nINFORMATION 0\n\n",
      binary_vtk()};
}

/// with arrays as text, appended bytes, and these compressed by zlib
inline std::vector<std::string> vtp_seeds()
{
  const std::string raw("\x10\0\0\0\0\0\0\x3f\0\0\x80\x3f\0\0\0\x40\0\0\x40\x40", 20);
  const std::string begin =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" byte_order=\"LittleEndian\">\n<PolyData>"
      "<Piece NumberOfPoints=\"4\" NumberOfVerts=\"1\" NumberOfPolys=\"2\">\n";
  const std::string end =
      "<Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0\n"
      "1 1 0 0 1 0</DataArray></Points>\n<Polys><DataArray type=\"Int64\" Name=\"connectivity\">0 "
      "1 "
      "2 0 2 3</DataArray><DataArray type=\"Int64\" Name=\"offsets\">3 6</DataArray></Polys>\n"
      "</Piece></PolyData>";
  const std::string rho =
      "<PointData><DataArray type=\"Float32\" Name=\"rho\" format=\"appended\" offset=\"0\"/>"
      "</PointData>";
  const std::string packed = "AQAAAACAAAAQAAAAFQAAAA==eJxjYGCwZ2BoAGIGByByAAAMegG/";
  std::string compressed = begin + rho + end;
  compressed.insert(compressed.find(" byte_order"), " compressor=\"vtkZLibDataCompressor\"");
  return {
      begin +
          "<PointData TCoords=\"st\"><DataArray type=\"Float32\" Name=\"st\" "
          "NumberOfComponents=\"2\">0 0 1 0 1 1 0 1</DataArray></PointData><CellData><DataArray "
          "type=\"UInt8\" Name=\"a&amp;b\">9 1 2</DataArray></CellData>" +
          end + "</VTKFile>",
      begin + rho + end + "<AppendedData encoding=\"raw\">\n_" + raw + "</AppendedData></VTKFile>",
      compressed + "<AppendedData encoding=\"base64\">\n_" + packed + "</AppendedData></VTKFile>"};
}

/// a file of two chunks, each padded to a multiple of four bytes
inline std::string glb(std::string json, std::string binary)
{
  while (json.size() % 4 != 0) json += ' ';
  while (binary.size() % 4 != 0) binary += '\0';
  std::string text = "glTF";
  append_bytes(text, std::uint32_t{2});
  append_bytes(text, static_cast<std::uint32_t>(28 + json.size() + binary.size()));
  append_bytes(text, static_cast<std::uint32_t>(json.size()));
  text += "JSON" + json;
  append_bytes(text, static_cast<std::uint32_t>(binary.size()));
  return text + std::string("BIN\0", 4) + binary;
}

/// a square: four positions, then, if wanted, four texture coordinates and six indices
inline std::string glb_buffer(bool has_indices)
{
  std::string bytes;
  const int corners[6] = {0, 1, 2, 0, 2, 3}, points[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const auto append_point = [&](int v) {
    for (const int x : {points[v][0], points[v][1], 0}) append_bytes(bytes, static_cast<float>(x));
  };
  if (!has_indices) {
    for (const int v : corners) append_point(v);
    return bytes;
  }
  for (int v = 0; v < 4; ++v) append_point(v);
  for (const auto& p : points)
    for (const int x : p) append_bytes(bytes, static_cast<float>(x));
  for (const int v : corners) append_bytes(bytes, static_cast<std::uint16_t>(v));
  return bytes;
}

inline std::vector<std::string> glb_seeds()
{
  return {
      glb(R"({ "asset": { "version": "2.0" }, "scene": 0, "scenes": [ { "nodes": [ 0 ] } ], )"
          R"("nodes": [ { "children": [ 1 ], "scale": [ 2, 2, 2 ] }, )"
          R"({ "mesh": 0, "translation": [ 1, 0, 0 ], "rotation": [ 0, 0, 0, 1 ] } ], )"
          R"("meshes": [ { "primitives": [ { "attributes": { "POSITION": 0, "TEXCOORD_0": 1 }, )"
          R"("indices": 2, "mode": 4 } ] } ], "accessors": [ )"
          R"({ "bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", )"
          R"("min": [ 0, 0, 0 ], "max": [ 1, 1, 0 ] }, )"
          R"({ "bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC2" }, )"
          R"({ "bufferView": 2, "componentType": 5123, "count": 6, "type": "SCALAR" } ], )"
          R"("bufferViews": [ { "buffer": 0, "byteOffset": 0, "byteLength": 48 }, )"
          R"({ "buffer": 0, "byteOffset": 48, "byteLength": 32 }, )"
          R"({ "buffer": 0, "byteOffset": 80, "byteLength": 12 } ], )"
          R"("buffers": [ { "byteLength": 92 } ] })",
          glb_buffer(true)),
      glb(R"({ "asset": { "version": "2.0" }, "scenes": [ { "nodes": [ 0 ] } ], )"
          R"("nodes": [ { "mesh": 0, "matrix": [ 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1 ] )"
          R"(} ], "meshes": [ { "primitives": [ { "attributes": { "POSITION": 0 } } ] } ], )"
          R"("accessors": [ { "bufferView": 0, "componentType": 5126, "count": 6, )"
          R"("type": "VEC3" } ], "bufferViews": [ { "buffer": 0, "byteLength": 72 } ], )"
          R"("buffers": [ { "byteLength": 72 } ] })",
          glb_buffer(false)),
      glb(R"({ "asset": { "version": "2.0" }, "extensionsUsed": [ "X" ], "animations": [ {} ], )"
          R"("scenes": [ { "nodes": [ 0, 1 ] }, {} ], "nodes": [ { "name": "a", "skin": 0, )"
          R"("mesh": 0, "scale": [ 1, 1, -1 ] }, { "mesh": 1 } ], "meshes": [ { "primitives": [ )"
          R"({ "attributes": { "POSITION": 0, "COLOR_0": 1, "_RHO": 2, "JOINTS_0": 1 }, )"
          R"("mode": 5, "material": 0, "targets": [ {} ] } ] }, { "primitives": [ )"
          R"({ "attributes": { "POSITION": 0, "_RHO": 2 }, "mode": 0 } ] } ], )"
          R"("materials": [ { "name": "red", "alphaMode": "BLEND" } ], "accessors": [ )"
          R"({ "bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "sparse": { )"
          R"("count": 1, "indices": { "bufferView": 1, "byteOffset": 32, )"
          R"("componentType": 5125 }, "values": { "bufferView": 1, "byteOffset": 36 } } }, )"
          R"({ "bufferView": 1, "componentType": 5121, "count": 4, "type": "VEC4", )"
          R"("normalized": true }, { "bufferView": 1, "byteOffset": 16, "componentType": 5126, )"
          R"("count": 4, "type": "SCALAR" } ], "bufferViews": [ )"
          R"({ "buffer": 0, "byteLength": 48 }, { "buffer": 1, "byteLength": 48 } ], )"
          R"("buffers": [ { "byteLength": 48 }, { "byteLength": 48, "uri": )"
          R"("data:application/octet-stream;base64,)"
          "/wAA/wD/AIAAAP//CQkJ/wAAAD8AAIC/AAAAQAAAAAADAAAAAACAPwAAgD8AAIA/"
          R"(" } ] })",
          glb_buffer(true))};
}

inline std::vector<std::string> svg_seeds()
{
  return {
      "<?xml version=\"1.0\"?>\n<!-- curves -->\n<svg viewBox=\"0 0 9 9\">\n<g "
      "transform=\"translate(1 "
      "2) rotate(30, 1, 1) scale(2)\"><path id=\"a\" d=\"M0,0 L1 0 1,1z m 3 3 h1 v1 H2 V0 Z\"/>\n"
      "<polygon points=\"0,0 1,0 1 1\"/></g>\n<defs><path d=\"M0 0L1 1\"/></defs>\n<circle "
      "r=\"1\"/>"
      "</svg>\n",
      "<svg><path transform='matrix(1 0 0 1 0 0) skewX(5)' d='M 0 0 C 1 0 1 1 0 1 S -1 2 0 3 q 1 1 "
      "2 "
      "0 t 2 0 A 1 2 30 1 0 5 5 a1 1 0 01-1-1'/><polyline points='0 0,1e1-1.5.5,2'/><![CDATA[<g>]]>"
      "<text>&lt;&#65;</text></svg>"};
}

/// of `conformal deform`, on a surface of some forty vertices
inline std::vector<std::string> targets_seeds()
{
  return {R"({"targets": [{"vertex": 12, "to": [0, 1.5, 0]}, {"vertex": 40, "move": [0, 0, 0]}]})",
          R"({"targets": [{"box": [[-1, -1, -1], [1, 1, 0]], "move": [0, 0.1, 0], )"
          R"("turn": [0, 0, 1, 30]}, {"vertices": [1, 2, 3], "move": [0, 0, 0]}]})"};
}

inline std::vector<std::string> curve_seeds()
{
  return {"x,y\n0,0\n1,0\n1,1\n0,1\n\n3 3\n4 3\n4 4\n", "# a curve\n0;0\n1e-3;2\n-1;+2\n0;0\n"};
}

}  // namespace fuzz
