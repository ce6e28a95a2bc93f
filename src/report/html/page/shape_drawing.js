// Colours of the points: of a deflection from −1 to 1, or of an amplitude and a phase. Both are mixed with the colour of
// rest, which is pale on faces and grey on lines.
const shapeColours = (onFaces) => {
  const parts = (name) => [1, 3, 5].map((i) => parseInt(colour(name).slice(i, i + 2), 16));
  const [rest, minus, plus, lead, lag] = [onFaces ? "--rest" : "--rest-line", "--minus", "--plus", "--lead", "--lag"].map(parts);
  const mix = (a, b, t) => a.map((x, i) => x + (b[i] - x) * t);
  const text = (c) => `rgb(${c.map(Math.round).join(",")})`;
  const around = [plus, lead, minus, lag];  // 0°, 90°, 180°, 270°
  return {
    displacement: (value) => text(mix(rest, value < 0 ? minus : plus, Math.min(1, Math.abs(value)))),
    phase: (amplitude, phase_rad) => {
      const quarter = ((phase_rad / (Math.PI / 2)) % 4 + 4) % 4, k = Math.floor(quarter) % 4;
      return text(mix(rest, mix(around[k], around[(k + 1) % 4], quarter - Math.floor(quarter)), Math.min(1, amplitude)));
    },
    ink: colour("--ink"), rule: colour("--rule"), soft: colour("--soft"), paper: colour("--paper"), sensor: colour("--c2"),
  };
};

// Points whose deflection has the largest magnitude among their neighbours, and at least half of the largest magnitude of all.
const extremePoints = (shapes, values) => {
  const neighbours = shapes.points.map(() => []);
  for (const [a, b] of shapes.lines) { neighbours[a].push(b); neighbours[b].push(a); }
  const largest = Math.max(...values.map(Math.abs));
  return values.flatMap((v, i) => (largest > 0 && Math.abs(v) >= 0.5 * largest && neighbours[i].every((n) => Math.abs(values[n]) < Math.abs(v) || (Math.abs(values[n]) === Math.abs(v) && n > i)) ? [i] : []));
};

const arrow = (context, from, to, head) => {
  const angle = Math.atan2(to[1] - from[1], to[0] - from[0]);
  context.beginPath();
  context.moveTo(from[0], from[1]);
  context.lineTo(to[0], to[1]);
  for (const side of [-0.5, 0.5]) {
    context.moveTo(to[0], to[1]);
    context.lineTo(to[0] - head * Math.cos(angle + side), to[1] - head * Math.sin(angle + side));
  }
  context.stroke();
};

// The directions of x, y and z in the corner.
const drawAxes = (context, view, colours, height, ratio) => {
  const from = [34 * ratio, height - 34 * ratio];
  context.strokeStyle = context.fillStyle = colours.soft;
  context.lineWidth = ratio;
  context.font = `${12 * ratio}px system-ui`;
  context.textAlign = "center";
  context.textBaseline = "middle";
  ["x", "y", "z"].forEach((name, i) => {
    const [across, up] = view.direction([0, 1, 2].map((k) => (k === i ? 1 : 0)));
    if (Math.hypot(across, up) < 0.15) return;
    arrow(context, from, [from[0] + 18 * ratio * across, from[1] - 18 * ratio * up], 4 * ratio);
    context.fillText(name, from[0] + 27 * ratio * across, from[1] - 27 * ratio * up);
  });
};

// The structure in a mode at a phase in radians: for each point its place on the canvas at rest and deflected, and its colour.
// `values` are the deflections along the normals.
const deflectedStructure = (shapes, mode, look, phase, size, at) => {
  const c = Math.cos(phase), s = Math.sin(phase), byPhase = look.kind === "phase";
  const resting = [], spots = [], values = [], shade = [];
  shapes.points.forEach((p, i) => {
    const m = mode.moves, k = 6 * i, n = shapes.normals[i];
    const moved = [c * m[k] - s * m[k + 1], c * m[k + 2] - s * m[k + 3], c * m[k + 4] - s * m[k + 5]];
    const value = n[0] * moved[0] + n[1] * moved[1] + n[2] * moved[2];
    resting.push(at(p));
    spots.push(at([p[0] + size * moved[0], p[1] + size * moved[1], p[2] + size * moved[2]]));
    values.push(value);
    const re = n[0] * m[k] + n[1] * m[k + 2] + n[2] * m[k + 4], im = n[0] * m[k + 1] + n[1] * m[k + 3] + n[2] * m[k + 5];
    shade.push(byPhase ? look.colours.phase(Math.hypot(re, im), Math.atan2(im, re)) : look.colours.displacement(value));
  });
  return { resting, spots, values, shade };
};

const drawRest = (context, shapes, resting, colour, ratio) => {
  context.strokeStyle = context.fillStyle = colour;
  context.lineWidth = 1.5 * ratio;
  context.beginPath();
  for (const [a, b] of shapes.lines) {
    context.moveTo(resting[a][0], resting[a][1]);
    context.lineTo(resting[b][0], resting[b][1]);
  }
  context.stroke();
  for (const [x, y] of resting) context.fillRect(x - ratio, y - ratio, 2 * ratio, 2 * ratio);
};

const middleOf = (p, q) => [(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2];

// The pieces to draw, the farthest first. A face gives one piece per corner, in the corner's colour, and each line is one
// piece. In a structure without faces, a line gives two halves, each in the colour of its end.
const piecesOf = (shapes, { spots, shade }, ink, radius) => {
  const pieces = [];
  for (const face of shapes.faces) {
    const centre = [0, 0, 0], count = face.length;
    for (const i of face) for (let k = 0; k < 3; ++k) centre[k] += spots[i][k] / count;
    const halves = face.map((i, n) => middleOf(spots[i], spots[face[(n + 1) % count]]));
    face.forEach((i, n) => {
      const corners = [spots[i], halves[n], centre, halves[(n + count - 1) % count]];
      pieces.push({ depth: (corners[0][2] + corners[1][2] + centre[2] + corners[3][2]) / 4, corners, fill: shade[i] });
    });
  }
  // Lines lie a little before the faces that they bound.
  const before = 0.02 * radius;
  for (const [a, b] of shapes.lines) {
    const half = middleOf(spots[a], spots[b]);
    if (shapes.faces.length) pieces.push({ depth: half[2] + before, corners: [spots[a], spots[b]], stroke: ink });
    else for (const end of [a, b]) pieces.push({ depth: (spots[end][2] + half[2]) / 2 + before, corners: [spots[end], half], stroke: shade[end] });
  }
  return pieces.sort((p, q) => p.depth - q.depth);
};

const drawPieces = (context, pieces, bare, ratio) => {
  for (const { corners, fill, stroke } of pieces) {
    context.beginPath();
    for (const corner of corners) context.lineTo(corner[0], corner[1]);
    if (fill) {
      context.closePath();
      context.globalAlpha = 0.9;
      context.fillStyle = context.strokeStyle = fill;
      context.fill();
      context.lineWidth = 0.5 * ratio;  // closes the seams
    } else {
      context.globalAlpha = bare ? 1 : 0.55;
      context.strokeStyle = stroke;
      context.lineWidth = (bare ? 4 : 0.8) * ratio;
    }
    context.stroke();
  }
  context.globalAlpha = 1;
};

const drawPoints = (context, { spots, shade }, ink, ratio) => spots.forEach(([x, y], i) => {
  context.beginPath();
  context.arc(x, y, 4 * ratio, 0, 2 * Math.PI);
  context.fillStyle = shade[i];
  context.strokeStyle = ink;
  context.lineWidth = ratio;
  context.fill();
  context.stroke();
});

const drawSensors = (context, shapes, spots, view, colour, ratio) => {
  context.strokeStyle = colour;
  context.lineWidth = 2 * ratio;
  for (const sensor of shapes.sensors) {
    const [x, y] = spots[sensor.at], [across, up] = view.direction(sensor.direction);
    arrow(context, [x, y], [x + 28 * ratio * across, y - 28 * ratio * up], 7 * ratio);
  }
};

const drawSigns = (context, shapes, { spots, values }, colours, ratio) => {
  context.font = `bold ${16 * ratio}px system-ui`;
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.lineWidth = 4 * ratio;
  context.strokeStyle = colours.paper;
  context.fillStyle = colours.ink;
  for (const i of extremePoints(shapes, values)) {
    for (const write of ["strokeText", "fillText"]) context[write](values[i] < 0 ? "−" : "+", spots[i][0], spots[i][1]);
  }
};

// Draws a mode at a phase in radians. `look` has amplitude (of the structure's radius), kind (displacement or phase),
// colours (shapeColours), and whether to draw rest, sensors and signs.
const drawShape = (canvas, shapes, mode, view, look, phase) => {
  const context = canvas.getContext("2d"), ratio = devicePixelRatio;
  const at = view.projection(canvas.width, canvas.height), colours = look.colours, bare = !shapes.faces.length;
  const structure = deflectedStructure(shapes, mode, look, phase, look.amplitude * view.radius, at);
  context.clearRect(0, 0, canvas.width, canvas.height);
  context.lineJoin = context.lineCap = "round";
  if (look.rest) drawRest(context, shapes, structure.resting, colours.rule, ratio);
  drawPieces(context, piecesOf(shapes, structure, colours.ink, view.radius), bare, ratio);
  if (bare) drawPoints(context, structure, colours.ink, ratio);
  if (look.sensors) drawSensors(context, shapes, structure.spots, view, colours.sensor, ratio);
  if (look.signs) drawSigns(context, shapes, structure, colours, ratio);
  drawAxes(context, view, colours, canvas.height, ratio);
};
