// The common view of all drawings of a structure: turned, tilted, shifted and magnified by mouse, touch and keys.
// Depth grows towards the viewer.
const shapeView = (shapes, changed) => {
  const middle = [0, 1, 2].map((i) => (Math.min(...shapes.points.map((p) => p[i])) + Math.max(...shapes.points.map((p) => p[i]))) / 2);
  const radius = Math.max(...shapes.points.map((p) => Math.hypot(...p.map((x, i) => x - middle[i])))) || 1;
  const degrees = Math.PI / 180;
  const views = { "3-D": [30, 30], "x–y": [0, 90], "x–z": [0, 0], "y–z": [-90, 0] };
  // A beam is seen from the side: across both the beam and its deflection.
  const home = () => {
    if (shapes.layout !== "line") return views["3-D"].map((x) => x * degrees);
    const [a, b] = [shapes.points[shapes.lines[0][0]], shapes.points[shapes.lines[0][1]]], t = b.map((x, i) => x - a[i]), n = shapes.normals[0];
    const side = [t[1] * n[2] - t[2] * n[1], t[2] * n[0] - t[0] * n[2]];
    const turn = Math.atan2(side[0], side[1]);
    return [Math.abs(turn) > Math.PI / 2 ? turn - Math.sign(turn) * Math.PI : turn, 0];
  };
  const view = { turn: 0, tilt: 0, x: 0, y: 0, zoom: 1, radius, names: Object.keys(views) };
  const place = (turn, tilt) => { Object.assign(view, { turn, tilt, x: 0, y: 0, zoom: 1 }); changed(); };
  view.reset = () => place(...home());
  view.show = (name) => place(...views[name].map((x) => x * degrees));
  view.rotate = (right, up) => {
    view.turn += right;
    view.tilt = Math.max(-Math.PI / 2, Math.min(Math.PI / 2, view.tilt + up));
    changed();
  };
  view.pan = (right, up) => { view.x += right / view.zoom; view.y += up / view.zoom; changed(); };
  view.magnify = (factor) => { view.zoom = Math.max(0.2, Math.min(20, view.zoom * factor)); changed(); };
  // A function of a direction in space: across and up on the drawing, and depth.
  view.rotation = () => {
    const ca = Math.cos(view.turn), sa = Math.sin(view.turn), cb = Math.cos(view.tilt), sb = Math.sin(view.tilt);
    return (v) => {
      const across = v[0] * ca - v[1] * sa, away = v[0] * sa + v[1] * ca;
      return [across, v[2] * cb + away * sb, v[2] * sb - away * cb];
    };
  };
  view.direction = (v) => view.rotation()(v);
  [view.turn, view.tilt] = home();
  // Half the width and height of the structure as first seen, with room for its deflection.
  const first = shapes.points.map((p) => view.direction(p.map((x, i) => x - middle[i])));
  const half = [0, 1].map((k) => Math.max(...first.map((q) => Math.abs(q[k]))) + 0.3 * radius);
  view.aspect = half[1] / half[0];
  // Places on a canvas of this width and height in pixels.
  view.projection = (width, height) => {
    const scale = Math.min(0.48 * width / half[0], 0.48 * height / half[1]) * view.zoom;
    const direction = view.rotation();
    return (p) => {
      const [x, y, depth] = direction([p[0] - middle[0], p[1] - middle[1], p[2] - middle[2]]);
      return [width / 2 + scale * (x + view.x * radius), height / 2 - scale * (y + view.y * radius), depth];
    };
  };
  return view;
};

// Drag: rotate; with shift, the right button or two fingers: pan. Wheel or two fingers: zoom. The wheel and fingers act on the
// focused drawing only: elsewhere they scroll the page.
const moveView = (canvas, view, toggle) => {
  const pointers = new Map();
  const spread = () => { const [a, b] = [...pointers.values()]; return Math.hypot(a.x - b.x, a.y - b.y) || 1; };
  canvas.addEventListener("pointerdown", (event) => {
    if (event.pointerType === "touch" && document.activeElement !== canvas) return canvas.focus({ preventScroll: true });
    canvas.focus({ preventScroll: true });
    canvas.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
  });
  canvas.addEventListener("pointermove", (event) => {
    const at = pointers.get(event.pointerId);
    if (!at) return;
    const size = Math.min(canvas.clientWidth, canvas.clientHeight), before = pointers.size > 1 ? spread() : 0;
    const right = (event.clientX - at.x) / size, down = (event.clientY - at.y) / size;
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    if (before) {
      view.pan(right, -down);
      view.magnify(spread() / before);
    } else if (event.shiftKey || event.buttons & 2) {
      view.pan(2 * right, -2 * down);
    } else {
      view.rotate(-3 * right, 3 * down);
    }
  });
  for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, (event) => pointers.delete(event.pointerId));
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  canvas.addEventListener("wheel", (event) => {
    if (document.activeElement !== canvas) return;
    event.preventDefault();
    view.magnify(Math.exp(-event.deltaY / 500));
  }, { passive: false });
  const step = 0.12;
  const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
  canvas.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    if (arrows[event.key]) {
      const [right, up] = arrows[event.key];
      if (event.shiftKey) view.pan(step * right, step * up);
      else view.rotate(-step * right, -step * up);
    } else if (event.key === "+" || event.key === "=") view.magnify(1.2);
    else if (event.key === "-") view.magnify(1 / 1.2);
    else if (event.key === "0" || event.key === "Home") view.reset();
    else if (event.key === " ") toggle();
    else return;
    event.preventDefault();
  });
};
