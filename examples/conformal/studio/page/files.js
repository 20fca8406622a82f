/* Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later */

// Files to save, and the command lines that do what the page has done.

function save(name, parts) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob(parts, {type: 'application/octet-stream'}));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

function rowsOf(values, size, head) {
  const rows = [];
  for (let i = 0; i < values.length; i += size)
    rows.push(head + Array.from(values.subarray(i, i + size)).join(' '));
  return rows.join('\n') + '\n';
}

const toObj = (points, faces) =>
    rowsOf(points, 3, 'v ') + rowsOf(faces.map(v => v + 1), 3, 'f ');

/** Binary, with coordinates of double precision, and rho. */
function toPly(points, faces, rho) {
  const head = new TextEncoder().encode(
      `ply\nformat binary_little_endian 1.0\nelement vertex ${points.length / 3}\n` +
      'property double x\nproperty double y\nproperty double z\nproperty double rho\n' +
      `element face ${faces.length / 3}\nproperty list uchar int vertex_indices\nend_header\n`);
  const body = new DataView(new ArrayBuffer(32 * rho.length + 13 * faces.length / 3));
  let at = 0;
  rho.forEach((value, v) => {
    for (const x of [points[3 * v], points[3 * v + 1], points[3 * v + 2], value]) {
      body.setFloat64(at, x, true);
      at += 8;
    }
  });
  for (let f = 0; f < faces.length; f += 3) {
    body.setUint8(at, 3);
    for (let c = 0; c < 3; ++c) body.setInt32(at + 1 + 4 * c, faces[f + c], true);
    at += 13;
  }
  return [head, body];
}

/** A number per vertex of the file, 0 where none is on the surface. */
function toRhoFile(shape, rho) {
  const all = new Float64Array(shape.fileVertices || rho.length);
  rho.forEach((value, v) => all[shape.fileVertices ? shape.origin[v] : v] = value);
  return Array.from(all).join('\n') + '\n';
}

const stem = file => file.replace(/^.*[\\/]/, '').replace(/\.[^.]*$/, '') || 'shape';

/** A word for a shell. */
const quoted = word => /^[\w./+-]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`;

/** Where vertices are wanted, by their numbers in the file. */
function toTargetFile(shape, targets) {
  const inFile = ({vertex, to}) => ({vertex: shape.fileVertices ? shape.origin[vertex] : vertex, to});
  return JSON.stringify({targets: targets.map(inFile)}) + '\n';
}

const boundOf = ({bound}) => ['--max-scale', bound > 1 ? String(bound) : 'none'];

/** The options of one step. */
const optionsOf = {
  flow: ({steps}) => ['--steps', String(steps)],
  deform: (step, file) => ['--targets', file, ...boundOf(step)],
  spin: (step, file) => ['--rho-file', file, ...boundOf(step),
                         ...step.amplitude === 1 ? [] : [`--amplitude=${step.amplitude}`]]
};

/** The command of one step: its input with the options for it, and what it makes. */
function commandOf(step, input, output, file) {
  return ['conformal', step.kind, ...input, ...optionsOf[step.kind](step, file), '-o', output].map(quoted).join(' ');
}

/** The steps of a state, as the program is told to take them. */
function commandsOf(shape, steps) {
  const name = stem(shape.file), all = [];
  let input = shape.isRepaired ? [shape.file, '--repair'] : [shape.file];
  steps.forEach((step, i) => {
    const number = steps.length > 1 ? `_${i + 1}` : '';
    const output = `${name}_edited${number}.ply`;
    all.push(commandOf(step, input, output, stepFile(shape, steps, i)));
    input = [output];
  });
  return all.join('\n');
}

/** The file with what a step is made of. */
const stepFile = (shape, steps, i) => stem(shape.file) + (steps[i].kind === 'deform' ? '_targets' : '_rho') +
    (steps.length > 1 ? `_${i + 1}` : '') + (steps[i].kind === 'deform' ? '.json' : '.txt');
