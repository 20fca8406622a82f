/* Copyright (c) 2026 The Conformal Geometry Processing authors
   SPDX-License-Identifier: LGPL-3.0-or-later */

// Both shapes on one canvas, seen by the same camera.

const vertexShader = `
  in float quality, scale, rho, level;
  in vec2 square;
  in vec3 corner;
  out float vQuality, vScale, vRho, vLevel;
  out vec2 vSquare;
  out vec3 vCorner, vNormal;
  void main() {
    vQuality = quality; vScale = scale; vRho = rho; vLevel = level; vSquare = square; vCorner = corner;
    vNormal = normalMatrix * normal;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  }`;

const fragmentShader = `
  uniform int mode;
  uniform bool edges;
  uniform float frequency, highest, widest, deepest;
  uniform vec3 heat[5], cold[5];
  in float vQuality, vScale, vRho, vLevel;
  in vec2 vSquare;
  in vec3 vCorner, vNormal;
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
    colour = vec4(lit, 1.0);
  }`;

/** The same array for every corner of the faces, from one for every vertex. */
function atCorners(values, scale = 1, middle = [0, 0, 0]) {
  const result = new Float32Array(9 * faceCount);
  for (let c = 0; c < faces.length; ++c)
    for (let k = 0; k < 3; ++k) result[3 * c + k] = (values[3 * faces[c] + k] - middle[k]) * scale;
  return result;
}

const ofFaces = values => Float32Array.from({length: 3 * faceCount}, (_, c) => values[Math.floor(c / 3)]);

/** Sums of the vector areas of the faces around the vertices; the shader makes them unit. */
function normalsOf(vectors, count) {
  const normals = new Float32Array(3 * count);
  for (let c = 0; c < faces.length; ++c)
    for (let k = 0; k < 3; ++k) normals[3 * faces[c] + k] += vectors[3 * Math.floor(c / 3) + k];
  for (let v = 0; v < normals.length; v += 3) {
    const length = Math.hypot(normals[v], normals[v + 1], normals[v + 2]) || 1;
    for (let k = v; k < v + 3; ++k) normals[k] /= length;
  }
  return normals;
}

/** A shape about its centroid, with area 1; `radius` is of the ball around it. */
function shape(THREE, points, {vectors, areas, total}, shared) {
  const middle = [0, 1, 2].map(k => areas.reduce((sum, area, f) => sum + area / 3 *
      (points[3 * faces[3 * f] + k] + points[3 * faces[3 * f + 1] + k] + points[3 * faces[3 * f + 2] + k]), 0) / total);
  const geometry = new THREE.BufferGeometry();
  const positions = atCorners(points, 1 / Math.sqrt(total), middle);
  geometry.setAttribute('position', new THREE.BufferAttribute(positions, 3));
  geometry.setAttribute('normal', new THREE.BufferAttribute(atCorners(normalsOf(vectors, points.length / 3)), 3));
  for (const [name, attribute] of Object.entries(shared)) geometry.setAttribute(name, attribute);
  let radius = 0;
  for (let i = 0; i < positions.length; i += 3)
    radius = Math.max(radius, Math.hypot(positions[i], positions[i + 1], positions[i + 2]));
  return {geometry, radius};
}

function makeViewer(THREE, canvas, {highest, widest, deepest}) {
  const renderer = new THREE.WebGLRenderer({canvas, antialias: true});
  renderer.setClearColor(0xeef1f5);
  renderer.setScissorTest(true);
  const {frequency, levels} = squareSizes();
  const attribute = (values, size) => new THREE.BufferAttribute(values, size);
  const shared = {
    quality: attribute(ofFaces(quality), 1), scale: attribute(ofFaces(scales.map(Math.log2)), 1),
    rho: attribute(ofFaces(rho.length ? rho : new Float32Array(faceCount)), 1),
    level: attribute(levels, 1), square: attribute(squares, 2),
    corner: attribute(Float32Array.from({length: 9 * faceCount}, (_, i) => +(i % 9 % 4 === 0)), 3)
  };
  const vectorsOf = stops => stops.map(stop =>
      new THREE.Vector3(...[1, 3, 5].map(k => parseInt(stop.slice(k, k + 2), 16) / 255)));
  const uniforms = {
    mode: {value: 0}, edges: {value: false}, frequency: {value: frequency}, highest: {value: highest},
    widest: {value: Math.log2(widest)}, deepest: {value: deepest},
    heat: {value: vectorsOf(heat)}, cold: {value: vectorsOf(cold)}
  };
  const material = new THREE.ShaderMaterial({
    glslVersion: THREE.GLSL3, vertexShader, fragmentShader, uniforms, side: THREE.DoubleSide
  });
  const shapes = [[before, areasBefore], [after, areasAfter]]
      .map(([points, areas]) => shape(THREE, points, areas, shared));
  const scenes = shapes.map(({geometry}) => {
    const scene = new THREE.Scene(), mesh = new THREE.Mesh(geometry, material);
    mesh.frustumCulled = false;
    return {scene: scene.add(mesh), mesh};
  });
  const radius = Math.max(...shapes.map(s => s.radius));
  const camera = new THREE.PerspectiveCamera(28, 1, .01, 100);
  const isFlat = after.every((z, i) => i % 3 !== 2 || Math.abs(z) < 1e-6);
  const start = new THREE.Quaternion();
  if (!isFlat) start.setFromEuler(new THREE.Euler(.28, -.5, 0)); // what is flat is seen from above
  const pose = {turn: start.clone(), start, x: 0, y: 0, zoom: 1};

  let size = '';
  function fit(width, height) {
    const wanted = [width, height, window.devicePixelRatio].join(' ');
    if (size === wanted) return;
    size = wanted;
    renderer.setPixelRatio(window.devicePixelRatio);
    renderer.setSize(width, height, false);
  }

  function draw() {
    const width = canvas.clientWidth / 2, height = canvas.clientHeight;
    fit(2 * width, height);
    camera.aspect = width / height;
    const slope = Math.tan(camera.fov * Math.PI / 360);
    const distance = 1.06 * radius / Math.sin(Math.atan(slope * Math.min(1, camera.aspect)));
    camera.position.set(0, 0, distance);
    camera.zoom = pose.zoom;
    camera.near = distance / 20;
    camera.far = distance + 4 * radius;
    camera.setViewOffset(width, height, -pose.x * height, pose.y * height, width, height);
    scenes.forEach(({scene, mesh}, side) => {
      mesh.quaternion.copy(pose.turn);
      renderer.setViewport(side * width, 0, width, height);
      renderer.setScissor(side * width, 0, width, height);
      renderer.render(scene, camera);
    });
  }

  let isWaiting = false;
  const redraw = () => {
    if (isWaiting) return;
    isWaiting = true;
    requestAnimationFrame(() => {
      isWaiting = false;
      draw();
    });
  };
  control(canvas, THREE, pose, redraw);
  new ResizeObserver(draw).observe(canvas);
  return {uniforms, redraw, draw};
}
