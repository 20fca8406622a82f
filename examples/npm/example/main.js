/* Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later */

// A sphere of three.js whose mean curvature is changed by waves.

import * as THREE from 'three';
import {Surface} from 'conformal-geometry';

/** An octahedron, its faces divided and pushed onto the unit sphere, with shared vertices. */
function sphere(divisions) {
  const points = [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]], middles = new Map();
  let triangles = [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]];
  const middle = (a, b) => {
    const key = Math.min(a, b) + ' ' + Math.max(a, b);
    if (!middles.has(key)) {
      const p = points[a].map((x, k) => x + points[b][k]), length = Math.hypot(...p);
      middles.set(key, points.push(p.map(x => x / length)) - 1);
    }
    return middles.get(key);
  };
  for (let i = 0; i < divisions; ++i)
    triangles = triangles.flatMap(([a, b, c]) => {
      const [d, e, f] = [middle(b, c), middle(c, a), middle(a, b)];
      return [[a, f, e], [f, b, d], [e, d, c], [d, e, f]];
    });
  return {points, triangles};
}

const {points, triangles} = sphere(4);
const surface = await Surface.open(points, triangles);

const geometry = new THREE.BufferGeometry();
geometry.setIndex(triangles.flat());
geometry.setAttribute('position', new THREE.BufferAttribute(Float32Array.from(points.flat()), 3));
const canvas = document.querySelector('#canvas');
const renderer = new THREE.WebGLRenderer({canvas, antialias: true});
renderer.setPixelRatio(devicePixelRatio);
renderer.setSize(canvas.clientWidth, canvas.clientHeight, false);
renderer.setClearColor(0xeef1f5);
const scene = new THREE.Scene(), mesh = new THREE.Mesh(geometry, new THREE.MeshStandardMaterial({color: 0x6f9bd8}));
const light = new THREE.DirectionalLight(0xffffff, 2.5);
light.position.set(1, 2, 3);
scene.add(mesh, light, new THREE.AmbientLight(0xffffff, .6));
const camera = new THREE.PerspectiveCamera(35, canvas.clientWidth / canvas.clientHeight, .01, 100);

function bend() {
  const amplitude = Number(document.querySelector('#amplitude').value);
  const {positions, report} = surface.transform(points.map(([, y]) => amplitude * Math.sin(5 * y)));
  geometry.attributes.position.array.set(positions);
  geometry.attributes.position.needsUpdate = true;
  geometry.computeVertexNormals();
  geometry.computeBoundingSphere();
  const {center, radius} = geometry.boundingSphere;
  mesh.position.copy(center).negate();
  camera.position.z = 3.8 * radius;
  renderer.render(scene, camera);
  const {quasi_conformal: Q} = report.result;
  document.querySelector('#report').textContent =
      report.verified ? `Angles are kept: mean Q ${Q.mean.toFixed(3)}` : report.error;
}

document.querySelector('#amplitude').addEventListener('input', bend);
bend();
