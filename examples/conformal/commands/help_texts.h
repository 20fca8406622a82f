// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_COMMANDS_HELP_TEXTS_H
#define CONFORMAL_COMMANDS_HELP_TEXTS_H

namespace conformal {

inline constexpr const char* about =
    "Edits, compares and describes surfaces by their curvature, without shearing them.\n"
    "Reads OFF, OBJ, PLY and STL; writes PLY, OFF, OBJ or GLB, by the extension of the output.\n"
    "Vertices and faces keep their order and their properties; numbers in messages count from 0.\n"
    "Example: conformal spin bear.off --rho-expression '1.5*sin(5*y)' -o bear_spin.ply\n"
    "Exit codes: 0 done, 1 failed or not verified, 2 usage, 3 cannot read, 4 input unsuitable,\n"
    "5 cannot write, 6 out of memory, 130 interrupted, 143 terminated.";

inline constexpr const char* about_info =
    "Tells what a mesh is: counts, topology, orientation, shape of its triangles, energies, and\n"
    "all that keeps it from being transformed.\n"
    "Example: conformal info bear.off --json bear.json";

inline constexpr const char* about_spin =
    "Deforms a surface conformally so that its mean curvature changes by rho.\n"
    "rho is in 1/length of the normalised frame (the middle of the bounding box at 0, its "
    "diagonal\n"
    "2), positive rho bulges outward, constants have no effect. The output has the vertex\n"
    "properties quality (quasi-conformal error, 1 is perfect) and rho; normals are left out.\n"
    "On surfaces with handles (genus > 0) or several boundary loops the part of rho is left out\n"
    "with which they would not close up, and the rest is reached in as many steps as it takes; "
    "the\n"
    "table tells how much. A boundary is free, unless --boundary says what it keeps.\n"
    "--filter keeps the large features of rho, the small ones, or lifts these out.\n"
    "--mollify takes faces as thin as they may be, also of area zero, which are refused "
    "otherwise;\n"
    "it is tried, and told, where a result does not verify without.\n"
    "A result that does not verify is not written, and the exit code is 1.\n"
    "Example: conformal spin bear.off --rho-expression '1.5*sin(5*y)' -o bear_spin.ply\n"
    "Example: conformal spin bear.obj --paint fur.png --filter unsharp --amplitude 8 -o bear.ply";

inline constexpr const char* about_flow =
    "Smooths a surface by the conformal Willmore flow: as smooth as its conformal class allows, a\n"
    "sphere where there are no handles. With a boundary that is free, or keeps its tangents, it\n"
    "becomes a minimal surface; with its binormals kept, one of constant mean curvature.\n"
    "Area, centroid and triangle quality stay. The\n"
    "output has the vertex property quality (quasi-conformal error against the input, 1 is\n"
    "perfect). The flow stops early where the energy has settled, or no step lowers it.\n"
    "When interrupted (Ctrl-C, SIGTERM), it writes the surface after the last complete step (with\n"
    "--each-component nothing), and ends with exit code 130 or 143; a second signal ends it at "
    "once.\n"
    "A result that does not verify is not written, and the exit code is 1.\n"
    "Example: conformal flow bear.off -o bear_flow.ply --html bear.html";

inline constexpr const char* about_boundary =
    "Deforms a surface with boundary conformally so that the boundary gets other tangents, "
    "binormals\n"
    "or positions, in one step. The mean curvature half-density stays as it is (a flat surface "
    "becomes\n"
    "a minimal one), or changes by rho as with conformal spin. Directions are absolute, sizes are "
    "not\n"
    "prescribed: area and centroid stay, unless positions are given.\n"
    "Any binormals can be realised, up to a constant gamma that is added to rho; so can the "
    "tangents\n"
    "of plane curves, but of others only those that fulfil one condition, which the program "
    "checks:\n"
    "the exit code is 1, and nothing is written, where gamma times the radius stays away from 0.\n"
    "A loop begins at its vertex of smallest number, and has the surface on its left.\n"
    "Example: conformal boundary disk.off --binormal-tilt '40*cos(6*pi*s)' -o flower.ply";

inline constexpr const char* about_fit =
    "Deforms a surface conformally, as nearly as it can in the way another program has deformed\n"
    "it. SOURCE and TARGET have the same faces. The curvature of the target is kept, and at a\n"
    "boundary its tangents (or binormals); its shear is not, so what only shears and stretches\n"
    "is undone. The result is placed to lie near the target. It has the vertex property quality\n"
    "(quasi-conformal error against the source, 1 is perfect) and the face property rho.\n"
    "A result that does not verify is not written, and the exit code is 1.\n"
    "Example: conformal fit bear.off bear_posed.off -o bear_fit.ply";

inline constexpr const char* about_blend =
    "Goes from A towards B, or beyond: adds t times the difference of their mean curvature\n"
    "half-densities. A and B have the same faces and are conformally equivalent, as results of\n"
    "conformal spin and flow are to their inputs; so is every surface on the way. Area and\n"
    "centroid are those of A; at a boundary the binormals turn evenly. --onto adds the\n"
    "difference to a third surface. The output has the vertex properties quality\n"
    "(quasi-conformal error, 1 is perfect) and rho.\n"
    "What does not verify is not written, and the exit code is 1.\n"
    "Example: conformal blend bear.off bear_spin.ply --t 1.5 -o bear_more.ply";

inline constexpr const char* about_flatten =
    "Maps a surface with boundary to the plane with little distortion of angles, and writes the\n"
    "map as texture coordinates in the unit square, beside the mesh as it was, or the flat mesh\n"
    "itself, as large as the surface. Holes are taken as they come. The property quality is the\n"
    "quasi-conformal error.\n"
    "--planar has the surface unbend by curvature: its mean curvature becomes zero, and the\n"
    "tangents of its boundary, which must be one loop, those of a plane curve that turns as it\n"
    "did.\n"
    "Example: conformal flatten face.off -o face.glb --json face.json";

inline constexpr const char* about_curve =
    "Smooths curves in the plane without stretching them: every edge keeps its length, and every\n"
    "closed curve its turning number. Those that turn k times become circles run through k times,\n"
    "those that do not turn a figure eight, open ones straight.\n"
    "Reads SVG (path, polygon, polyline), CSV (x,y per line, an empty line between), OBJ (l);\n"
    "writes them too, by the extension of the output. Ends early where the energy has settled.\n"
    "When interrupted (Ctrl-C, SIGTERM), it writes the curves after the last complete step, and\n"
    "ends with exit code 130 or 143; a second signal ends it at once.\n"
    "Example: conformal curve star.svg --steps 60 --time-step 0.05 --animate -o star_flow.svg";

inline constexpr const char* about_harmonic =
    "Finds the harmonic 1-forms of a closed surface with handles, two for each, and their tangent\n"
    "fields; of a torus also the conformal modulus. -o writes a PLY file with the fields as\n"
    "face properties harmonic_0_x, harmonic_0_y, harmonic_0_z, ..., in 1/length.\n"
    "Example: conformal harmonic torus.obj -o torus_fields.ply --json torus.json";

inline constexpr const char* about_compare =
    "Measures the map between two meshes with the same faces: angles, lengths, flips, energies.\n"
    "-o writes the second one with the vertex property quality (quasi-conformal error).\n"
    "Example: conformal compare bear.off bear_spin.ply --json map.json";

}  // namespace conformal

#endif
