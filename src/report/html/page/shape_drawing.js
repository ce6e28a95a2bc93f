// A colour between −1, 0 and 1, or around the circle of phases. Both mixes start from the colour of rest: pale on faces, a
// grey on lines.
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

// Points whose signed deflection is the largest among their neighbours and at least half of the largest of all.
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

// Draws a mode at a phase in radians. `look` has amplitude (of the structure's radius), kind (displacement or phase), rest,
// sensors, signs.
const drawShape = (canvas, shapes, mode, view, look, phase) => {
  const context = canvas.getContext("2d"), ratio = canvas.width / canvas.clientWidth || devicePixelRatio;
  const at = view.projection(canvas.width, canvas.height), [c, s] = [Math.cos(phase), Math.sin(phase)], colours = look.colours;
  const move = (i, k) => c * mode.moves[6 * i + 2 * k] - s * mode.moves[6 * i + 2 * k + 1];
  const values = shapes.points.map((_, i) => [0, 1, 2].reduce((sum, k) => sum + shapes.normals[i][k] * move(i, k), 0));
  const size = look.amplitude * view.radius;
  const resting = shapes.points.map(at), spots = shapes.points.map((p, i) => at(p.map((x, k) => x + size * move(i, k))));
  const colourAt = (i) => {
    if (look.kind !== "phase") return colours.displacement(values[i]);
    const [re, im] = [0, 1].map((part) => [0, 1, 2].reduce((sum, k) => sum + shapes.normals[i][k] * mode.moves[6 * i + 2 * k + part], 0));
    return colours.phase(Math.hypot(re, im), Math.atan2(im, re));
  };
  const shade = shapes.points.map((_, i) => colourAt(i));
  const path = (corners) => {
    context.beginPath();
    for (const [x, y] of corners) context.lineTo(x, y);
  };
  context.clearRect(0, 0, canvas.width, canvas.height);
  context.lineJoin = context.lineCap = "round";
  if (look.rest) {
    context.strokeStyle = context.fillStyle = colours.rule;
    context.lineWidth = 1.5 * ratio;
    for (const [a, b] of shapes.lines) { path([resting[a], resting[b]]); context.stroke(); }
    for (const [x, y] of resting) context.fillRect(x - ratio, y - ratio, 2 * ratio, 2 * ratio);
  }
  // Faces as one piece per corner, in the corner's colour, and lines; the farthest first.
  const mean = (list) => [0, 1, 2].map((k) => list.reduce((sum, p) => sum + p[k], 0) / list.length);
  const pieces = [];
  for (const face of shapes.faces) {
    const centre = mean(face.map((i) => spots[i]));
    face.forEach((i, n) => {
      const before = face[(n + face.length - 1) % face.length], after = face[(n + 1) % face.length];
      const corners = [spots[i], mean([spots[i], spots[after]]), centre, mean([spots[before], spots[i]])];
      pieces.push({ depth: mean(corners)[2], corners, fill: shade[i] });
    });
  }
  const bare = !shapes.faces.length;
  for (const [a, b] of shapes.lines) {
    const half = mean([spots[a], spots[b]]);
    for (const end of [a, b]) pieces.push({ depth: mean([spots[end], half])[2] + 0.02 * view.radius, corners: [spots[end], half], stroke: bare ? shade[end] : colours.ink });
  }
  pieces.sort((p, q) => p.depth - q.depth);
  for (const piece of pieces) {
    path(piece.corners);
    if (piece.fill) {
      context.closePath();
      context.globalAlpha = 0.9;
      context.fillStyle = context.strokeStyle = piece.fill;
      context.fill();
      context.lineWidth = 0.5 * ratio;  // closes the seams
    } else {
      context.globalAlpha = bare ? 1 : 0.55;
      context.strokeStyle = piece.stroke;
      context.lineWidth = (bare ? 4 : 0.8) * ratio;
    }
    context.stroke();
  }
  context.globalAlpha = 1;
  if (bare) spots.forEach(([x, y], i) => {
    context.beginPath();
    context.arc(x, y, 4 * ratio, 0, 2 * Math.PI);
    context.fillStyle = shade[i];
    context.strokeStyle = colours.ink;
    context.lineWidth = ratio;
    context.fill();
    context.stroke();
  });
  if (look.sensors) {
    context.strokeStyle = colours.sensor;
    context.lineWidth = 2 * ratio;
    for (const sensor of shapes.sensors) {
      const [x, y] = spots[sensor.at], [across, up] = view.direction(sensor.direction);
      arrow(context, [x, y], [x + 28 * ratio * across, y - 28 * ratio * up], 7 * ratio);
    }
  }
  if (look.signs) {
    context.font = `bold ${16 * ratio}px system-ui`;
    context.textAlign = "center";
    context.textBaseline = "middle";
    context.lineWidth = 4 * ratio;
    context.strokeStyle = colours.paper;
    context.fillStyle = colours.ink;
    for (const i of extremePoints(shapes, values)) {
      for (const write of ["strokeText", "fillText"]) context[write](values[i] < 0 ? "−" : "+", spots[i][0], spots[i][1]);
    }
  }
  drawAxes(context, view, colours, canvas.height, ratio);
};
