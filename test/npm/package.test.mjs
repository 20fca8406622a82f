/* Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later */

// Laws that what the package computes obeys, as it is installed: check_npm_package.py runs them in its folder.

import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {test} from 'node:test';
import * as everything from 'conformal-geometry';

const {Refusal, Surface, deform, readSurface, spinTransform, willmoreFlow} = everything;

/** An octahedron, divided and pushed onto the unit sphere; its vertices are moved along it by up to `noise` edges. */
function sphere(divisions, noise = 0) {
  let points = [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]];
  let triangles = [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]];
  const middles = new Map(), unit = p => p.map(x => x / Math.hypot(...p));
  const middle = (a, b) => {
    const key = [a, b].sort((x, y) => x - y).join();
    if (!middles.has(key)) middles.set(key, points.push(unit(points[a].map((x, k) => x + points[b][k]))) - 1);
    return middles.get(key);
  };
  for (let i = 0; i < divisions; ++i)
    triangles = triangles.flatMap(([a, b, c]) => {
      const [d, e, f] = [middle(b, c), middle(c, a), middle(a, b)];
      return [[a, f, e], [f, b, d], [e, d, c], [d, e, f]];
    });
  let seed = 1;
  const random = () => (seed = seed * 48271 % 2147483647) / 2147483647 - .5;
  points = points.map(p => unit(p.map(x => x + 2 * noise * Math.SQRT1_2 ** (2 * divisions) * random())));
  return {points, triangles};
}

const at = (positions, v) => Array.from(positions.subarray(3 * v, 3 * v + 3));
const distance = (a, b) => Math.hypot(...a.map((x, k) => x - b[k]));

/** By how much the lengths of the edges are multiplied, and the height of their middles before. */
function edgeScales({points, triangles}, positions) {
  return triangles.flatMap(corners => corners.map((a, i) => {
    const b = corners[(i + 1) % 3], z = (points[a][2] + points[b][2]) / 2;
    return {z, scale: distance(at(positions, a), at(positions, b)) / distance(points[a], points[b])};
  }));
}

/** The largest edge scale over the smallest, less 1: 0 for shapes that are similar. */
function dissimilarity(mesh, positions) {
  const scales = edgeScales(mesh, positions).map(({scale}) => scale);
  return Math.max(...scales) / Math.min(...scales) - 1;
}

const waves = ({points}) => points.map(([x, y]) => 1.2 * Math.sin(4 * y) + .3 * x);

for (const [name, mesh] of [['regular', sphere(3)], ['irregular', sphere(3, .4)], ['coarse', sphere(1, .3)]]) {
  test(`no change of curvature keeps a ${name} sphere`, async () => {
    const {positions, triangles, quality, report} =
        await spinTransform(mesh.points, mesh.triangles, new Float64Array(mesh.points.length));
    assert.ok(dissimilarity(mesh, positions) < 1e-6);
    assert.deepEqual(Array.from(triangles), mesh.triangles.flat());
    assert.equal(quality.length, mesh.triangles.length);
    assert.ok(quality.every(Q => Math.abs(Q - 1) < 1e-5));
    assert.equal(report.verified, true);
  });
}

// A Moebius transformation of the unit sphere multiplies lengths by s = sqrt(1 - b^2) / (1 - b z), and changes
// H times the length by s - 1.
test('a sphere becomes the sphere of a Moebius transformation, the better the finer it is', async () => {
  const b = .5, errors = [], shears = [];
  for (const divisions of [2, 3, 4]) {
    const mesh = sphere(divisions), wanted = z => Math.sqrt(1 - b * b) / (1 - b * z);
    const rho = mesh.points.map(([, , z]) => wanted(z) - 1);
    const {positions, report} = await spinTransform(mesh.points, mesh.triangles, rho, {maxScale: null});
    assert.equal(report.verified, true);
    shears.push(report.result.quasi_conformal.mean - 1);
    const logs = edgeScales(mesh, positions).map(({z, scale}) => Math.log(scale / wanted(z)));
    const mean = logs.reduce((sum, x) => sum + x, 0) / logs.length; // the size of all is free
    errors.push(Math.max(...logs.map(x => Math.abs(x - mean))));
  }
  for (const i of [0, 1]) { // second order, and first
    assert.ok(errors[i] > 2.8 * errors[i + 1], `errors ${errors}`);
    assert.ok(shears[i] > 1.8 * shears[i + 1], `Q - 1: ${shears}`);
  }
  assert.ok(errors[2] < .008, `errors ${errors}`);
});

test('rho is a density: constants change nothing, and it scales as 1 / length', async () => {
  const mesh = sphere(3, .3), rho = waves(mesh);
  const edit = async (points, values) =>
      (await spinTransform(points, mesh.triangles, values, {maxScale: null})).positions;
  const found = await edit(mesh.points, rho);
  const size = Math.max(...found.map(Math.abs));
  const difference = (others, factor) => Math.max(...found.map((x, i) => Math.abs(x - others[i] / factor))) / size;
  assert.ok(difference(await edit(mesh.points, rho.map(x => x + .7)), 1) < 1e-6);
  const large = Float32Array.from(mesh.points.flat(), x => 8 * x);
  assert.ok(difference(await edit(large, rho.map(x => x / 8)), 8) < 1e-5);
});

test('lengths stay within the bound, and the report tells what is kept', async () => {
  const mesh = sphere(3), surface = await Surface.open(mesh.points, mesh.triangles);
  const rho = waves(mesh).map(x => 2 * x);
  const {scale_control: byDefault} = surface.transform(rho).report.result;
  assert.equal(byDefault.bound, 2);
  const {report} = surface.transform(rho, {maxScale: 1.3});
  const {low, high} = report.result.scale_control;
  assert.ok(high <= 1.3 * 1.01 && low >= 1 / 1.3 / 1.01);
  assert.ok(report.result.realised_curvature.left_out > 0);
  assert.equal(surface.transform(rho, {maxScale: null}).report.result.scale_control, undefined);
});

test('a preview comes near the result', async () => {
  const mesh = sphere(3), surface = await Surface.open(mesh.points, mesh.triangles), rho = waves(mesh);
  surface.preview(rho.map(x => x / 2));
  const preview = surface.preview(rho, {continues: true}).positions, {positions} = surface.transform(rho);
  const norm = values => Math.hypot(...values), start = mesh.points.flat();
  assert.ok(norm(preview.map((x, i) => x - positions[i])) < .1 * norm(positions.map((x, i) => x - start[i])));
});

test('targets are met', async () => {
  const mesh = sphere(3), top = 4;
  const targets = [0, 1, 2, 3, 5].map(vertex => ({vertex, to: mesh.points[vertex]}));
  targets.push({vertex: top, to: [0, 0, 1.2]});
  const {positions, report} = await deform(mesh.points, mesh.triangles, targets);
  for (const {vertex, to} of targets) assert.ok(distance(at(positions, vertex), to) < 1e-6);
  assert.equal(report.verified, true);
});

test('the Willmore flow makes an ellipsoid round', async () => {
  const {points, triangles} = sphere(3);
  const {report} = await willmoreFlow(points.map(([x, y, z]) => [1.6 * x, y, .8 * z]), triangles, {steps: 40});
  const {initial, final} = report.result.energy;
  assert.ok(initial > 1.05 * final && Math.abs(final / (4 * Math.PI) - 1) < .02, `${initial} -> ${final}`);
});

test('what is not a surface is refused in words', async () => {
  const {points, triangles} = sphere(1), zero = new Float64Array(points.length);
  const refused = (message, ...call) => assert.rejects(spinTransform(...call), error =>
      error instanceof Refusal && message.test(error.message));
  await refused(/rho: wanted a number of each of 18 vertices, got 3/, points, triangles, [1, 2, 3]);
  await refused(/not all are finite/, points, triangles, zero.map(() => NaN));
  await refused(/maxScale/, points, triangles, zero, {maxScale: .5});
  await refused(/positions: wanted 3 numbers each/, [1, 2, 3, 4], triangles, zero);
  await refused(/./, points, [...triangles, [0, 1, 99]], zero);
  await refused(/./, points, [...triangles, [0, 2, -1]], zero);
  await refused(/./, points, [...triangles, triangles[0]], zero);
  const flat = points.map(p => triangles[0].map(v => points[v]).includes(p) ? [0, 0, 0] : p);
  await refused(/area|degenerate|face/i, flat, triangles, zero);
});

test('the types name what there is', () => {
  const types = readFileSync(new URL('./node_modules/conformal-geometry/index.d.ts', import.meta.url), 'utf8');
  const declared = [...types.matchAll(/^export (?:class|function) (\w+)/gm)].map(([, name]) => name);
  assert.deepEqual(declared.sort(), Object.keys(everything).sort());
  const methods = Object.getOwnPropertyNames(Surface.prototype).filter(name => name !== 'constructor');
  for (const method of methods) assert.match(types, new RegExp(`^  ${method}\\(`, 'm'));
});

test('files are read as the program reads them', async () => {
  const {points, triangles} = sphere(2, .3);
  const words = [...points.map(p => `v ${p.join(' ')}`), 'v 9 9 9', ...triangles.map(t => `f ${t.map(v => v + 1).join(' ')}`)];
  const bytes = lines => new TextEncoder().encode(lines.join('\n') + '\n');
  const read = await readSurface(bytes(words), 'a.obj');
  assert.deepEqual(Array.from(read.positions), points.flat());
  assert.deepEqual(Array.from(read.triangles), triangles.flat());
  assert.deepEqual(Array.from(read.vertexInFile), points.map((_, v) => v));
  assert.equal(read.notes.length, 1); // the vertex without a face
  await assert.rejects(readSurface(bytes(['v 0 0 x']), 'a.obj'), error => error instanceof Refusal && error.message.startsWith('a.obj:1: '));
  const twice = [...words, words.at(-1)];
  await assert.rejects(readSurface(bytes(twice), 'a.obj'), /non-manifold/);
  assert.equal((await readSurface(bytes(twice), 'a.obj', {repair: true})).triangles.length, 3 * triangles.length);
});
