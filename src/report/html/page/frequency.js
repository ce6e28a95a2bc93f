// Names of the modes above vertical lines at their frequencies, in two rows; names that do not fit are left out.
const nameModes = (u) => inCanvas(u, (context) => {
  context.fillStyle = colour("--ink");
  context.strokeStyle = colour("--soft");
  context.font = `${12 * devicePixelRatio}px system-ui`;
  context.textAlign = "center";
  context.setLineDash([2 * devicePixelRatio, 3 * devicePixelRatio]);
  const free = [-Infinity, -Infinity];
  for (const mode of data.modes) {
    if (mode.hz < u.scales.x.min || mode.hz > u.scales.x.max) continue;
    drawVerticalLine(u, mode.hz);
    const at = u.valToPos(mode.hz, "x", true), half = context.measureText(mode.name).width / 2;
    const row = free.findIndex((end) => at - half >= end);
    if (row < 0) continue;
    context.fillText(mode.name, at, u.bbox.top - (6 + 15 * row) * devicePixelRatio);
    free[row] = at + half + 8 * devicePixelRatio;
  }
});

// Zoom buttons for the keyboard. All plots of `together` show the same frequency range.
const zoomButtons = (figure, together, lowest, highest, changeAxis) => {
  const controls = addElement("div");
  controls.className = "controls";
  figure.prepend(controls);
  const change = (move) => {
    const { min, max } = together[0].scales.x, [low, high] = move(min, max, max - min);
    together[0].setScale("x", { min: Math.max(lowest, low), max: Math.min(highest, high) });
  };
  const moves = [
    ["Zoom in", (min, max, width) => [min + width / 4, max - width / 4]],
    ["Zoom out", (min, max, width) => [min - width / 2, max + width / 2]],
    ["Lower", (min, max, width) => (min - width / 4 < lowest ? [lowest, lowest + width] : [min - width / 4, max - width / 4])],
    ["Higher", (min, max, width) => (max + width / 4 > highest ? [highest - width, highest] : [min + width / 4, max + width / 4])],
    ["All", () => [lowest, highest]],
  ];
  for (const [name, move] of moves) addElement("button", controls, name).addEventListener("click", () => change(move));
  const kind = addElement("button", controls, "Logarithmic");
  kind.addEventListener("click", () => { kind.textContent = changeAxis() ? "Linear" : "Logarithmic"; });
};

// A line of text below the plot with the levels at the cursor.
const readout = (figure, curves, levels) => {
  const line = addElement("p", figure, "Point at the plot to read values.");
  line.className = "readout";
  return (u) => {
    const k = u.cursor.idx;
    if (k === null || k === undefined) return;
    line.textContent = `${u.data[0][k].toFixed(2)} Hz: ` + curves.map((c, i) => `${c.name} ${levels[i][k] === null ? "–" : levels[i][k].toFixed(2)} dB`).join(", ");
  };
};

const magnitudeSeries = (frf, levels) => {
  const series = [], bands = [];
  frf.curves.forEach((curve, i) => {
    const db = levels[i];
    // The ± band is symmetric in amplitude, not in decibels.
    const below = (above) => 20 * Math.log10(Math.max(0.01, 2 - 10 ** (above / 20)));
    series.push({ values: db, ...strokes(i) });
    if (curve.sigma_db) {
      const sigma = decoded(curve.sigma_db);
      series.push({ values: db.map((v, k) => (v === null || sigma[k] === null ? null : v + sigma[k])), stroke: "transparent", width: 0 });
      series.push({ values: db.map((v, k) => (v === null || sigma[k] === null ? null : v + below(sigma[k]))), stroke: "transparent", width: 0 });
      bands.push({ series: [series.length - 1, series.length], fill: () => colour(`--c${i % 8}`) + "33" });
    }
    if (curve.fit_db) series.push({ values: decoded(curve.fit_db), stroke: () => colour("--fit"), width: 0.75 });
  });
  return { series, bands };
};

const frequencyPlots = () => {
  const frf = data.frf;
  if (!frf || !frf.curves.length) return;
  const levels = frf.curves.map((c) => decoded(c.db)), count = levels[0].length;
  const xs = Array.from({ length: count }, (_, k) => frf.first_hz + k * frf.df_hz);
  const together = [], drawFunctions = [];
  let following = false, logarithmic = false;
  const follow = (u, key) => {
    if (key !== "x" || following) return;
    following = true;
    const { min, max } = u.scales.x;
    for (const other of together) if (other !== u) other.setScale("x", { min, max });
    following = false;
  };
  // A change of the axis recreates each plot in its place.
  const add = (figure, height, y, series, options) => {
    const target = addElement("div", figure);
    target.className = "plot";
    const draw = () => together.push(plot(figure, height, "frequency, Hz", y, xs, series, { shared: true, target, logarithmic, ...options, hooks: { setScale: [follow], ...options.hooks } }));
    drawFunctions.push(draw);
    draw();
  };
  const changeAxis = () => {
    logarithmic = !logarithmic;
    for (const u of together) {
      plots.splice(plots.findIndex((d) => d.plot === u), 1);
      u.destroy();
    }
    together.length = 0;
    for (const draw of drawFunctions) draw();
    return logarithmic;
  };
  for (const figure of figuresOf("magnitude")) {
    legend(figure, frf.curves.map((c) => c.name));
    // The curves set the scale without their ± bands, whose lower edges lie up to 40 dB below the curves.
    const all = levels.flat().filter((v) => v !== null);
    const span = [all.reduce((a, b) => Math.min(a, b), Infinity) - 5, all.reduce((a, b) => Math.max(a, b), -Infinity) + 5];
    const { series, bands } = magnitudeSeries(frf, levels);
    let read = () => {};
    add(figure, 360, "dB re 1 (m/s²)/N", series, { top: 40, range: span, bands, hooks: { draw: [nameModes], setCursor: [(u) => read(u)] } });
    read = readout(figure, frf.curves, levels);
    zoomButtons(figure, together, xs[0], xs[count - 1], changeAxis);
    const notes = [frf.curves.length < frf.of ? `The ${frf.curves.length} strongest of ${frf.of} FRFs.` : "", frf.curves.some((c) => c.fit_db) ? "Thin: the fitted modes." : "", frf.curves.some((c) => c.sigma_db) ? "Shaded: one standard deviation." : ""];
    addElement("figcaption", figure, notes.filter((note) => note).join(" "));
  }
  // The curve is interrupted where the phase wraps.
  const withoutWraps = (values) => values.map((v, k) => (k > 0 && v !== null && values[k - 1] !== null && Math.abs(v - values[k - 1]) > 300 ? null : v));
  for (const figure of figuresOf("phase"))
    add(figure, 180, "phase, degrees", frf.curves.map((c, i) => ({ values: withoutWraps(decoded(c.phase_deg)), ...strokes(i) })), { range: [-190, 190], splits: [-180, -90, 0, 90, 180] });
  const coherent = frf.curves.filter((c) => c.coherence);
  for (const figure of figuresOf("coherence")) {
    if (!coherent.length) figure.remove();
    else add(figure, 150, "coherence", coherent.map((c, i) => ({ values: decoded(c.coherence), ...strokes(i) })), { range: [0, 1.02] });
  }
};
