/* Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later */

// Meshes of the visitor: a file that is dropped anywhere on the page, or chosen. The readers are the program's.

let repaired = null; // the shape of the file that was refused, if repairing it helps

function tellFile(words, isGood) {
  element('file-words').hidden = false;
  element('file-words').textContent = words;
  element('file-words').classList.toggle('poor', !isGood);
}

async function openFile(file) {
  tellFile(`Reading ${file.name} …`, true);
  repaired = null;
  const bytes = new Uint8Array(await file.arrayBuffer());
  const read = async isRepaired => {
    const shape = await kernels.quick.read({name: file.name, bytes, isRepaired});
    return {...shape, name: file.name, file: file.name, isRepaired};
  };
  try {
    offerShape(await read(false));
  } catch (error) {
    repaired = await read(true).catch(() => null);
    tellFile(error.message, false);
  }
  element('repair').hidden = !repaired;
}

function offerShape(shape) {
  const notes = shape.notes.map(note => `; ${note}`).join('');
  tellFile(`${shape.name} has ${shape.faces.length / 3} triangles${notes}.`, true);
  studio.shapes.push(shape);
  const last = studio.shapes.length - 1;
  element('shape').add(new Option(shape.name, last));
  element('shape-choice').hidden = last === 0;
  element('shape').value = last;
  chooseShape(last);
}

function listenToFiles() {
  const carriesFiles = event => event.dataTransfer?.types.includes('Files');
  document.addEventListener('dragover', event => {
    if (!carriesFiles(event)) return;
    event.preventDefault();
    document.body.classList.add('dropping');
  });
  document.addEventListener('dragleave', event => {
    if (!event.relatedTarget) document.body.classList.remove('dropping');
  });
  document.addEventListener('drop', event => {
    if (!carriesFiles(event)) return;
    event.preventDefault();
    document.body.classList.remove('dropping');
    openFile(event.dataTransfer.files[0]);
  });
  listen('open', 'click', () => element('file').click());
  listen('file', 'change', () => {
    if (element('file').files.length) openFile(element('file').files[0]);
    element('file').value = ''; // so that the same file can be chosen again
  });
  listen('repair', 'click', () => {
    element('repair').hidden = true;
    offerShape(repaired);
  });
}
