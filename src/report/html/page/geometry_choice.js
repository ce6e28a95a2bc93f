// Draws the points of a survey, to choose one of them: seen along the axis of the smallest extent, a little from above.
// Returns a function that marks the chosen point.
const geometryChoice = (parent, places, choose) => {
  const known = places.map((p, i) => ({ p, i })).filter((q) => q.p);
  if (known.length < 2) return () => {};
  const extent = (k) => Math.max(...known.map((q) => q.p[k])) - Math.min(...known.map((q) => q.p[k]));
  const [a, b, c] = [0, 1, 2].sort((i, j) => extent(j) - extent(i) || i - j);
  const flat = known.map(({ p, i }) => ({ i, x: p[a] + 0.25 * p[c], y: p[b] + 0.4 * p[c] }));
  const [width, height, margin] = [320, 200, 14];
  const low = { x: Math.min(...flat.map((q) => q.x)), y: Math.min(...flat.map((q) => q.y)) };
  const size = { x: Math.max(...flat.map((q) => q.x)) - low.x, y: Math.max(...flat.map((q) => q.y)) - low.y };
  const scale = Math.min((width - 2 * margin) / (size.x || 1), (height - 2 * margin) / (size.y || 1));
  const spots = flat.map((q) => ({ i: q.i, x: (width - scale * size.x) / 2 + scale * (q.x - low.x), y: (height + scale * size.y) / 2 - scale * (q.y - low.y) }));
  const canvas = addElement("canvas", parent), context = canvas.getContext("2d");
  canvas.className = "geometry";
  canvas.title = "Click a point to choose it";
  canvas.width = width * devicePixelRatio;
  canvas.height = height * devicePixelRatio;
  context.scale(devicePixelRatio, devicePixelRatio);
  canvas.addEventListener("click", (event) => {
    const box = canvas.getBoundingClientRect();
    const at = { x: ((event.clientX - box.left) / box.width) * width, y: ((event.clientY - box.top) / box.height) * height };
    const away = (q) => Math.hypot(q.x - at.x, q.y - at.y);
    choose(spots.reduce((best, q) => (away(q) < away(best) ? q : best)).i);
  });
  return (chosen) => {
    context.clearRect(0, 0, width, height);
    for (const q of spots) {
      context.beginPath();
      context.fillStyle = colour(q.i === chosen ? "--c1" : "--c0");
      context.arc(q.x, q.y, q.i === chosen ? 6 : 3, 0, 7);
      context.fill();
    }
  };
};
