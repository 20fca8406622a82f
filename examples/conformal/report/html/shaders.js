/* Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later */

// How both shapes are drawn: what each mode shows, lamps, edges, and the ring of a brush.

const vertexShader = `
  in float quality, scale, rho, level;
  in vec2 square;
  in vec3 corner, home;
  out float vQuality, vScale, vRho, vLevel;
  out vec2 vSquare;
  out vec3 vCorner, vHome, vNormal;
  void main() {
    vQuality = quality; vScale = scale; vRho = rho; vLevel = level; vSquare = square; vCorner = corner;
    vHome = home;
    vNormal = normalMatrix * normal;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  }`;

const fragmentShader = `
  uniform int mode;
  uniform bool edges;
  uniform float frequency, highest, widest, deepest, lost;
  uniform vec3 heat[5], cold[5], gone;
  uniform vec4 brush; // place on the first shape and radius; 0: none
  in float vQuality, vScale, vRho, vLevel;
  in vec2 vSquare;
  in vec3 vCorner, vHome, vNormal;
  out vec4 colour;

  vec3 between(vec3 stops[5], float share) {
    float place = clamp(share, 0.0, 1.0) * 4.0;
    vec3 result = stops[0];
    for (int i = 0; i < 4; ++i) result = mix(result, stops[i + 1], clamp(place - float(i), 0.0, 1.0));
    return result;
  }

  // 0 and 1 by turns, of length 1 each; blurred over a pixel, and gray where it is finer than one
  float turns(float x, float width) {
    float sharp = clamp((abs(fract(x / 2.0) - 0.5) - 0.25) * 2.0 / max(width, 1e-6) + 0.5, 0.0, 1.0);
    return mix(sharp, 0.5, smoothstep(0.5, 1.2, width));
  }

  vec3 checkerboard() {
    float zoom = frequency * exp2(-2.0 * floor(0.5 * vLevel + 0.5));
    vec2 place = vSquare * zoom, width = fwidth(vSquare) * zoom;
    float a = turns(place.x, width.x), b = turns(place.y, width.y);
    return mix(vec3(0.965, 0.955, 0.93), vec3(0.24, 0.42, 0.63), a * b + (1.0 - a) * (1.0 - b));
  }

  vec3 surface() {
    if (mode == 0) return checkerboard();
    if (mode == 1) return between(heat, (vQuality - 1.0) / (highest - 1.0));
    if (vScale < lost && mode != 4) return gone;
    if (mode == 2) return between(cold, 0.5 + 0.5 * vScale / widest);
    if (mode == 3) return between(cold, 0.5 + 0.5 * vRho / deepest);
    return vec3(0.80, 0.83, 0.87);
  }

  void main() {
    vec3 n = normalize(vNormal) * (gl_FrontFacing ? 1.0 : -1.0);
    float key = max(dot(n, normalize(vec3(0.35, 0.55, 0.8))), 0.0);
    float fill = max(dot(n, normalize(vec3(-0.7, -0.1, 0.4))), 0.0);
    float shine = pow(max(dot(n, normalize(vec3(0.18, 0.3, 1.0))), 0.0), 40.0);
    vec3 lit = surface() * (0.38 + 0.58 * key + 0.16 * fill) + 0.06 * shine;
    if (!gl_FrontFacing) lit *= 0.8;
    if (edges) {
      vec3 width = 1.1 * fwidth(vCorner), near = smoothstep(vec3(0.0), width, vCorner);
      lit = mix(lit, vec3(0.12, 0.16, 0.21), 0.55 * (1.0 - min(near.x, min(near.y, near.z))));
    }
    float from = distance(vHome, brush.xyz), away = abs(from - brush.w) / max(fwidth(from), 1e-9);
    if (brush.w > 0.0) lit = mix(vec3(0.1, 0.14, 0.2), lit, smoothstep(0.5, 1.6, away));
    colour = vec4(lit, 1.0);
  }`;
