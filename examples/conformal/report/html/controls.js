/* Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later */

// Turns, moves and zooms what is seen, by pointer, wheel and keys.

/** `pose` has a quaternion `turn`, a shift {x, y} in heights of the view, and `zoom`. Pointers that
    are taken when they go down are left alone; what is returned takes them over later. */
function control(canvas, THREE, pose, redraw, isTaken) {
  const pointers = new Map();

  const turn = (right, down) => {
    const angle = Math.hypot(right, down);
    if (angle === 0) return;
    const axis = new THREE.Vector3(down / angle, right / angle, 0);
    pose.turn.premultiply(new THREE.Quaternion().setFromAxisAngle(axis, angle)).normalize();
  };
  const move = (right, down) => {
    pose.x += right / canvas.clientHeight;
    pose.y -= down / canvas.clientHeight;
  };
  const zoom = factor => pose.zoom = Math.min(Math.max(pose.zoom * factor, .2), 40);
  const spread = () => {
    const [a, b] = [...pointers.values()];
    return Math.hypot(a.x - b.x, a.y - b.y);
  };
  const reset = () => {
    Object.assign(pose, {x: 0, y: 0, zoom: 1});
    pose.turn.copy(pose.start);
  };

  const on = (name, act) => canvas.addEventListener(name, event => {
    act(event);
    redraw();
  }, {passive: false});
  const grab = event => {
    canvas.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, {x: event.clientX, y: event.clientY});
  };
  on('pointerdown', event => {
    if (!isTaken(event)) grab(event);
  });
  for (const name of ['pointerup', 'pointercancel'])
    on(name, event => pointers.delete(event.pointerId));
  on('pointermove', event => {
    const last = pointers.get(event.pointerId);
    if (!last) return;
    const right = event.clientX - last.x, down = event.clientY - last.y;
    const gap = pointers.size === 2 ? spread() : 0;
    Object.assign(last, {x: event.clientX, y: event.clientY});
    if (pointers.size === 2) {
      zoom(spread() / (gap || 1));
      move(right / 2, down / 2);
    } else if (event.shiftKey || event.buttons & 2) {
      move(right, down);
    } else {
      turn(right * 5 / canvas.clientHeight, down * 5 / canvas.clientHeight);
    }
  });
  on('wheel', event => {
    event.preventDefault();
    zoom(Math.exp(-event.deltaY * (event.deltaMode ? .04 : .0012)));
  });
  on('contextmenu', event => event.preventDefault());
  on('mousedown', event => { // or a drag that leaves the canvas selects words of the page
    event.preventDefault();
    canvas.focus({preventScroll: true});
  });
  on('dblclick', reset);
  const keys = {ArrowLeft: () => turn(-.1, 0), ArrowRight: () => turn(.1, 0), '+': () => zoom(1.15),
                ArrowUp: () => turn(0, -.1), ArrowDown: () => turn(0, .1), '-': () => zoom(1 / 1.15),
                '0': reset};
  on('keydown', event => {
    if (!keys[event.key]) return;
    event.preventDefault();
    keys[event.key]();
  });
  return grab;
}
