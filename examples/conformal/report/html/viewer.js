/* Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later */

// Both shapes on one canvas, seen by the same camera. An exhibit has `faces`, the points `before` and
// `after`, `squares` (2 numbers a corner), and of each face `quality` and `scales`; `rho` of each
// face or vertex.

/** The numbers of the vertices at every corner of the faces; `into` is reused if given. */
function atCorners(faces, values, size, into) {
  const result = into ?? new Float32Array(size * faces.length);
  for (let c = 0; c < faces.length; ++c)
    for (let k = 0; k < size; ++k) result[size * c + k] = values[size * faces[c] + k];
  return result;
}

/** The number of each face at its corners. */
function ofFaces(values, into) {
  const result = into ?? new Float32Array(3 * values.length);
  for (let c = 0; c < result.length; ++c) result[c] = values[Math.floor(c / 3)];
  return result;
}

/** Unit normals: sums of the vector areas of the faces around the vertices. */
function normalsOf(faces, vectors, count) {
  const normals = new Float32Array(3 * count);
  for (let c = 0; c < faces.length; ++c)
    for (let k = 0; k < 3; ++k) normals[3 * faces[c] + k] += vectors[3 * Math.floor(c / 3) + k];
  for (let v = 0; v < normals.length; v += 3) {
    const length = Math.hypot(normals[v], normals[v + 1], normals[v + 2]) || 1;
    for (let k = v; k < v + 3; ++k) normals[k] /= length;
  }
  return normals;
}

/** The centroid, and the root of the area: coordinates relative to them are those of the viewer. */
function frameOf(faces, points, {areas, total}) {
  const middle = [0, 0, 0];
  for (let c = 0; c < faces.length; ++c)
    for (let k = 0; k < 3; ++k)
      middle[k] += areas[Math.floor(c / 3)] / 3 * points[3 * faces[c] + k] / total;
  return {middle, size: Math.sqrt(total)};
}

function radiusOf(points) {
  let radius = 0;
  for (let i = 0; i < points.length; i += 3)
    radius = Math.max(radius, Math.hypot(points[i], points[i + 1], points[i + 2]));
  return radius;
}

function makeUniforms(THREE, {highest, widest, deepest}) {
  const vectorsOf = stops => stops.map(stop =>
      new THREE.Vector3(...[1, 3, 5].map(k => parseInt(stop.slice(k, k + 2), 16) / 255)));
  return {
    lost: {value: Math.log2(collapsed.below)}, gone: {value: vectorsOf([collapsed.colour])[0]},
    mode: {value: 0}, edges: {value: false}, frequency: {value: 1}, highest: {value: highest},
    widest: {value: Math.log2(widest)}, deepest: {value: deepest},
    brush: {value: new THREE.Vector4(0, 0, 0, 0)},
    heat: {value: vectorsOf(heat)}, cold: {value: vectorsOf(cold)}
  };
}

const nameHeight = 30; // pixels above views that are one above the other

/** `isTaken(event)`: whether a pointer that goes down is not for the camera. `modes`: what is shown
    on each side, a number of the shader. */
function makeViewer(THREE, canvas, ranges, isTaken = () => false) {
  const renderer = new THREE.WebGLRenderer({canvas, antialias: true});
  renderer.setClearColor(0xeef1f5);
  renderer.setScissorTest(true);
  const uniforms = makeUniforms(THREE, ranges);
  const material = new THREE.ShaderMaterial({
    glslVersion: THREE.GLSL3, vertexShader, fragmentShader, uniforms, side: THREE.DoubleSide
  });
  const sides = [0, 1].map(() => {
    const mesh = new THREE.Mesh(new THREE.BufferGeometry(), material);
    mesh.frustumCulled = false;
    return {scene: new THREE.Scene().add(mesh), mesh};
  });
  const camera = new THREE.PerspectiveCamera(28, 1, .01, 100);
  const start = new THREE.Quaternion();
  const pose = {turn: start.clone(), start, x: 0, y: 0, zoom: 1};
  const viewer = {uniforms, pose, modes: [0, 0], home: new Float32Array(),
                  ring: {side: -1, radius: 0}}; // of the brush, drawn on the surface but on this side
  const radii = [0, 0], frames = [];
  let exhibit = null, radius = 1, areasBefore = null;

  const attribute = (side, name, size, fill) => {
    const geometry = sides[side].mesh.geometry, old = geometry.getAttribute(name);
    const values = fill(old?.array);
    if (old) old.needsUpdate = true;
    else geometry.setAttribute(name, new THREE.BufferAttribute(values, size));
  };
  const both = (...rest) => [0, 1].forEach(side => attribute(side, ...rest));

  function place(side, points, areas, frame) {
    const {faces} = exhibit, {middle, size} = frames[side] = frame ?? frameOf(faces, points, areas);
    const own = Float32Array.from(points, (x, i) => (x - middle[i % 3]) / size);
    const normals = normalsOf(faces, areas.vectors, points.length / 3);
    attribute(side, 'position', 3, into => atCorners(faces, own, 3, into));
    attribute(side, 'normal', 3, into => atCorners(faces, normals, 3, into));
    radii[side] = radiusOf(own);
    radius = Math.max(radius, radii[side]);
    return own;
  }

  /** Sees both shapes as large as they can be; until then, the camera only draws back. */
  viewer.fit = () => {
    radius = Math.max(...radii);
    viewer.redraw();
  };

  /** Shows another exhibit, as it was seen last. */
  viewer.show = shown => {
    exhibit = shown;
    radius = 0;
    for (const {mesh} of sides) {
      mesh.geometry.dispose();
      mesh.geometry = new THREE.BufferGeometry();
    }
    const {faces, before, squares} = exhibit;
    areasBefore = areasOf(faces, before);
    const {frequency, levels} = squareSizes(exhibit, areasBefore);
    uniforms.frequency.value = frequency;
    viewer.home = place(0, before, areasBefore);
    both('home', 3, into => atCorners(faces, viewer.home, 3, into));
    both('level', 1, () => levels);
    both('square', 2, () => squares);
    both('corner', 3, () => Float32Array.from({length: 3 * faces.length}, (_, i) => +(i % 9 % 4 === 0)));
    viewer.change(exhibit);
    const isFlat = exhibit.after.every((z, i) => i % 3 !== 2 || Math.abs(z) < 1e-6);
    if (isFlat) start.identity(); // what is flat is seen from above
    else start.setFromEuler(new THREE.Euler(.28, -.5, 0));
    pose.turn.copy(start);
  };

  /** Shows other points after, with what belongs to them; or another rho alone. What `isInPlace` is
      seen beside the points before as it is, and not about its own centroid. */
  viewer.change = changed => {
    const {faces} = exhibit, {after, quality, scales, rho, isInPlace} = changed;
    if (after) place(1, after, areasOf(faces, after), isInPlace ? frames[0] : null);
    if (quality) both('quality', 1, into => ofFaces(quality, into));
    if (scales) both('scale', 1, into => ofFaces(scales.map(Math.log2), into));
    if (rho) both('rho', 1, into => rho.length === faces.length / 3 ? ofFaces(rho, into)
                                                                    : atCorners(faces, rho, 1, into));
    viewer.redraw();
  };

  const isTall = () => canvas.clientHeight > 1.1 * canvas.clientWidth;

  /** Where the two sides are: beside each other, or one above the other, below their names. */
  viewer.rectangles = () => {
    const {clientWidth: width, clientHeight: height} = canvas;
    return isTall()
        ? [0, 1].map(side => ({left: 0, top: side * height / 2 + nameHeight, width, height: height / 2 - nameHeight}))
        : [0, 1].map(side => ({left: side * width / 2, top: 0, width: width / 2, height}));
  };

  let size = '';
  function fit() {
    const wanted = [canvas.clientWidth, canvas.clientHeight, window.devicePixelRatio].join(' ');
    if (size === wanted) return;
    size = wanted;
    canvas.parentElement.classList.toggle('tall', isTall());
    renderer.setPixelRatio(window.devicePixelRatio);
    renderer.setSize(canvas.clientWidth, canvas.clientHeight, false);
  }

  function aim({width, height}) {
    camera.aspect = width / height;
    const slope = Math.tan(camera.fov * Math.PI / 360);
    const distance = 1.06 * radius / Math.sin(Math.atan(slope * Math.min(1, camera.aspect)));
    camera.position.set(0, 0, distance);
    camera.zoom = pose.zoom;
    camera.near = distance / 20;
    camera.far = distance + 4 * radius;
    camera.setViewOffset(width, height, -pose.x * height, pose.y * height, width, height);
    camera.updateMatrixWorld();
  }

  viewer.draw = () => {
    if (!exhibit) return;
    fit();
    viewer.rectangles().forEach((rectangle, side) => {
      const {left, top, width, height} = rectangle, bottom = canvas.clientHeight - top - height;
      aim(rectangle);
      uniforms.mode.value = viewer.modes[side];
      uniforms.brush.value.w = viewer.ring.side === side ? 0 : viewer.ring.radius;
      material.uniformsNeedUpdate = true;
      sides[side].mesh.quaternion.copy(pose.turn);
      renderer.setViewport(left, bottom, width, height);
      renderer.setScissor(left, bottom, width, isTall() ? height + nameHeight : height);
      renderer.render(sides[side].scene, camera);
    });
    viewer.onDraw?.();
  };

  let isWaiting = false;
  viewer.redraw = () => {
    if (isWaiting) return;
    isWaiting = true;
    requestAnimationFrame(() => {
      isWaiting = false;
      viewer.draw();
    });
  };

  /** The side, and the ray from the camera through a point of the canvas, about the shape. */
  viewer.ray = (x, y) => {
    const side = viewer.rectangles().findIndex(r =>
        x >= r.left && x < r.left + r.width && y >= r.top && y < r.top + r.height);
    if (side < 0) return null;
    const {left, top, width, height} = viewer.rectangles()[side];
    aim({width, height});
    const caster = new THREE.Raycaster();
    caster.setFromCamera(new THREE.Vector2(2 * (x - left) / width - 1, 1 - 2 * (y - top) / height), camera);
    const back = pose.turn.clone().invert();
    return {side, origin: caster.ray.origin.applyQuaternion(back).toArray(),
            direction: caster.ray.direction.applyQuaternion(back).toArray(),
            corners: sides[side].mesh.geometry.getAttribute('position').array};
  };

  /** How many pixels of the canvas a unit of the viewer has at a distance from the camera. */
  viewer.pixels = (side, distance) =>
      viewer.rectangles()[side].height * pose.zoom / (2 * Math.tan(camera.fov * Math.PI / 360) * distance);

  /** Turned as it is seen, a point of the shape after. */
  const seen = point => {
    const {middle, size} = frames[1];
    return new THREE.Vector3(...point.map((x, k) => (x - middle[k]) / size)).applyQuaternion(pose.turn);
  };

  /** Where on the canvas a point of the shape after is seen. */
  viewer.project = point => {
    const {left, top, width, height} = viewer.rectangles()[1];
    aim({width, height});
    camera.updateProjectionMatrix();
    const {x, y} = seen(point).project(camera);
    return {x: left + (x + 1) / 2 * width, y: top + (1 - y) / 2 * height};
  };

  /** The point seen at a place of the canvas, as far from the camera as another one is. */
  viewer.unproject = (x, y, like) => {
    const {left, top, width, height} = viewer.rectangles()[1], {middle, size} = frames[1];
    aim({width, height});
    camera.updateProjectionMatrix();
    const deep = seen(like).project(camera).z;
    return new THREE.Vector3(2 * (x - left) / width - 1, 1 - 2 * (y - top) / height, deep).unproject(camera)
        .applyQuaternion(pose.turn.clone().invert()).toArray().map((value, k) => middle[k] + size * value);
  };

  viewer.grab = control(canvas, THREE, pose, viewer.redraw, isTaken);
  new ResizeObserver(viewer.draw).observe(canvas);
  return viewer;
}
