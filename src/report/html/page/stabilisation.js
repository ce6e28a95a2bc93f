const kStabilities = [["n", "new", "·"], ["f", "stable frequency", "+"], ["d", "stable damping", "×"], ["s", "stable", "●"]];

const stabilisationMark = (context, mark, x, y) => {
  const r = 3 * devicePixelRatio;
  context.globalAlpha = mark === "s" ? 1 : 0.55;
  context.beginPath();
  if (mark === "s") {
    context.arc(x, y, r, 0, 7);
    context.fill();
  } else if (mark === "n") {
    context.fillRect(x - r / 3, y - r / 3, r / 1.5, r / 1.5);
  } else {
    const [a, b] = mark === "f" ? [r, 0] : [r * 0.7, r * 0.7];
    context.moveTo(x - a, y - b);
    context.lineTo(x + a, y + b);
    context.moveTo(x + b, y - a);
    context.lineTo(x - b, y + a);
    context.stroke();
  }
  context.globalAlpha = 1;
};

// Draws, at each frequency, the strongest of the page's FRF curves behind the poles, over the height of the plot.
const frfBehind = (u) => {
  const frf = data.frf;
  if (!frf || !frf.curves.length) return;
  const levels = frf.curves.map((c) => decoded(c.db));
  const strongest = levels[0].map((_, k) => levels.reduce((max, values) => (values[k] === null ? max : Math.max(max, values[k])), -Infinity));
  const finite = strongest.filter((v) => v > -Infinity);
  const low = finite.reduce((a, b) => Math.min(a, b), Infinity), high = finite.reduce((a, b) => Math.max(a, b), -Infinity);
  u.ctx.beginPath();
  strongest.forEach((v, k) => {
    const hz = frf.first_hz + k * frf.df_hz;
    if (v > -Infinity && hz >= u.scales.x.min && hz <= u.scales.x.max)
      u.ctx.lineTo(u.valToPos(hz, "x", true), u.bbox.top + u.bbox.height * (0.95 - (0.9 * (v - low)) / (high - low || 1)));
  });
  u.ctx.strokeStyle = colour("--rule");
  u.ctx.lineWidth = 2 * devicePixelRatio;
  u.ctx.stroke();
};

const stabilisationPlot = () => {
  const diagram = data.stabilisation;
  for (const figure of figuresOf("stabilisation")) {
    if (!diagram || !diagram.order.length) { figure.remove(); continue; }
    const hz = decoded(diagram.hz);
    const list = addElement("ul", figure);
    list.className = "legend";
    for (const [, name, mark] of kStabilities) addElement("li", list, `${mark} ${name}`);
    const order = hz.map((_, i) => i).sort((a, b) => hz[a] - hz[b]);
    const xs = order.map((i) => hz[i]), ys = order.map((i) => diagram.order[i]), marks = order.map((i) => diagram.stability[i]);
    // Each mode's ring marks its stable pole of the highest order.
    const ringed = (data.modes || []).map((mode) => {
      let best = -1;
      xs.forEach((x, i) => { if (marks[i] === "s" && Math.abs(x - mode.hz) <= Math.max(mode.zeta, 1e-3) * mode.hz && (best < 0 || ys[i] > ys[best])) best = i; });
      return best;
    });
    const dots = (u) => inCanvas(u, (context) => {
      frfBehind(u);
      context.lineWidth = devicePixelRatio;
      context.strokeStyle = context.fillStyle = colour("--ink");
      xs.forEach((x, i) => {
        if (x >= u.scales.x.min && x <= u.scales.x.max) stabilisationMark(context, marks[i], u.valToPos(x, "x", true), u.valToPos(ys[i], "y", true));
      });
      context.strokeStyle = colour("--c1");
      for (const mode of data.modes || []) drawVerticalLine(u, mode.hz);
      context.setLineDash([4 * devicePixelRatio, 4 * devicePixelRatio]);
      context.strokeStyle = colour("--ink");
      for (const unmodelled of diagram.unmodelled_hz || []) drawVerticalLine(u, unmodelled);
      context.setLineDash([]);
      context.strokeStyle = colour("--c1");
      context.lineWidth = 2 * devicePixelRatio;
      for (const i of ringed) {
        if (i < 0 || xs[i] < u.scales.x.min || xs[i] > u.scales.x.max) continue;
        context.beginPath();
        context.arc(u.valToPos(xs[i], "x", true), u.valToPos(ys[i], "y", true), 7 * devicePixelRatio, 0, 7);
        context.stroke();
      }
    });
    plot(figure, 300, "frequency, Hz", "model order", xs, [{ values: ys, stroke: "transparent", paths: () => null }], { hooks: { draw: [dots] } });
    addElement("figcaption", figure, "Grey: at each frequency, the strongest of the FRFs that this page plots. Vertical lines: the modes; ringed: their stable poles of the highest order."
      + (diagram.unmodelled_hz ? " Dashed: poles that are stable in the diagram of a section of the band and that no mode describes." : ""));
  }
};
