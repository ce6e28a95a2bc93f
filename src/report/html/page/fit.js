// Steps of the Rice codes of an FRF, see fit_plot_data.hpp.
const kFitLevel_dB = 0.1, kFitPhase_rad = (2 * Math.PI) / 512, kFitResidual_dB = 1;

// Decodes the measured and the synthesised FRF, and the level of the residual. Without modes, only the measured FRF.
const decodedFrf = (fit, frf) => {
  const read = riceReader(frf.bits), n = fit.count;
  const level = read(n), phase = read(n);
  const curve = (levels, phases) => {
    const magnitude = levels.map((v) => 10 ** ((v * kFitLevel_dB) / 20));
    return { db: levels.map((v) => v * kFitLevel_dB), re: magnitude.map((s, k) => s * Math.cos(phases[k] * kFitPhase_rad)), im: magnitude.map((s, k) => s * Math.sin(phases[k] * kFitPhase_rad)) };
  };
  const out = { measured: curve(level, phase) };
  if (frf.frac === undefined) return out;
  const levels = read(n).map((v, k) => v + level[k]), phases = read(n).map((v, k) => v + phase[k]);
  out.synthesised = curve(levels, phases);
  out.residual_dB = read(n).map((v) => v * kFitResidual_dB);
  return out;
};

const peakLevel = (peak) => `${peak.db < 0 ? "−" : ""}${Math.abs(peak.db)} dB`;

// Triangles above the measured curve at the peaks that no mode explains, with their levels.
const markPeaks = (peaks, level) => (u) => inCanvas(u, (context) => {
  context.fillStyle = colour("--warn");
  context.font = `${12 * devicePixelRatio}px system-ui`;
  context.textAlign = "center";
  for (const peak of peaks) {
    if (peak.hz < u.scales.x.min || peak.hz > u.scales.x.max) continue;
    const x = u.valToPos(peak.hz, "x", true), y = u.valToPos(level(peak.hz), "y", true) - 4 * devicePixelRatio, r = 6 * devicePixelRatio;
    context.beginPath();
    context.moveTo(x, y);
    context.lineTo(x - r, y - 1.6 * r);
    context.lineTo(x + r, y - 1.6 * r);
    context.fill();
    context.fillText(peakLevel(peak), x, y - 2 * r);
  }
});

const fitChooser = (parent, name, options, change) => {
  const label = addElement("label", parent, name + " "), select = addElement("select", label);
  options.forEach((text, i) => { addElement("option", select, text).value = i; });
  select.addEventListener("change", change);
  label.hidden = options.length < 2;
  return select;
};

// The drawn lines [from, to) of three half-power bandwidths on either side of a mode, but at least 12. Without a mode,
// all lines.
const linesAround = (mode, xs) => {
  if (!mode) return [0, xs.length];
  const reach = 6 * mode.zeta * mode.hz;
  let from = xs.findIndex((hz) => hz >= mode.hz - reach), to = xs.findIndex((hz) => hz > mode.hz + reach);
  from = from < 0 ? 0 : from;
  to = to < 0 ? xs.length : to;
  const missing = Math.max(0, 12 - (to - from));
  return [Math.max(0, from - missing), Math.min(xs.length, to + missing)];
};

// The FRAC of an FRF if modes exist, and the peaks that no mode explains.
const fitSummary = (frf, modesExist, peaks) =>
  (modesExist ? `FRAC ${frf.frac.toFixed(5)} over the band` : "no modes to compare with") +
  (peaks.length ? `; ${peaks.length} unexplained peak${peaks.length > 1 ? "s" : ""}: ${peaks.map((p) => `${hertz(p.hz)} Hz (${peakLevel(p)})`).join(", ")}` : "; no unexplained peak") + ".";

const fitPlots = () => {
  const fit = data.fit;
  for (const figure of figuresOf("fit")) {
    if (!fit || !fit.frfs.length) { figure.remove(); continue; }
    const xs = riceReader(fit.lines)(fit.count).map((k) => fit.first_hz + k * fit.df_hz);
    const controls = addElement("div", figure), modes = data.modes || [];
    controls.className = "controls interactive";
    const show = () => draw();
    const point = fitChooser(controls, "Point", fit.points.map(String), show);
    const channel = fitChooser(controls, "Channel", fit.channels, show);
    const view = fitChooser(controls, "View", ["Magnitude and residual", "Real and imaginary", "Nyquist"], show);
    const range = fitChooser(controls, "Range", ["Whole band", ...modes.map((m) => `${m.name}, ${hertz(m.hz)} Hz`)], show);
    const step = (by) => {
      const n = fit.frfs.length;
      const at = fit.frfs.findIndex((f) => f.point === Number(point.value) && f.channel === Number(channel.value));
      const next = fit.frfs[(at + by + n) % n];
      point.value = next.point;
      channel.value = next.channel;
      draw();
    };
    addElement("button", controls, "Previous").addEventListener("click", () => step(-1));
    addElement("button", controls, "Next").addEventListener("click", () => step(1));
    const choosePlace = geometryChoice(figure, fit.places || [], (i) => { point.value = i; draw(); });
    const summary = addElement("p", figure);
    summary.className = "said";
    summary.setAttribute("aria-live", "polite");
    const target = addElement("div", figure);
    let own = [];
    const add = (height, y, cut, series, options = {}) => {
      const place = addElement("div", target);
      own.push(plot(figure, height, "frequency, Hz", y, cut(xs), series.map((s) => ({ ...s, values: cut(s.values) })), { target: place, ...options }));
    };
    const kMeasured = strokes(0), kSynthesised = strokes(1), kResidual = { ...strokes(2), width: 1 };
    const draw = () => {
      for (const u of own) {
        plots.splice(plots.findIndex((d) => d.plot === u), 1);
        u.destroy();
      }
      own = [];
      target.replaceChildren();
      choosePlace(Number(point.value));
      const frf = fit.frfs.find((f) => f.point === Number(point.value) && f.channel === Number(channel.value));
      const name = (fit.points.length > 1 ? `Point ${fit.points[Number(point.value)]}, ` : "") + fit.channels[Number(channel.value)];
      if (!frf) { summary.textContent = `${name}: not measured.`; return; }
      const { measured, synthesised, residual_dB } = decodedFrf(fit, frf), [from, to] = linesAround(modes[Number(range.value) - 1], xs), cut = (values) => values.slice(from, to);
      const inRange = fit.peaks.filter((p) => p.hz >= xs[from] && p.hz <= xs[to - 1]);
      summary.textContent = `${name}: ${fitSummary(frf, synthesised, inRange)}`;
      if (view.value === "2") {
        legend(target, ["measured", "synthesised"].slice(0, synthesised ? 2 : 1));
        const canvas = addElement("canvas", target);
        canvas.className = "nyquist";
        const part = (curve, more) => ({ re: cut(curve.re), im: cut(curve.im), ...more });
        const curves = [part(measured, { dots: true, stroke: kMeasured.stroke }), ...(synthesised ? [part(synthesised, { stroke: kSynthesised.stroke })] : [])];
        redraws.set(figure, () => drawNyquist(canvas, curves));
      } else if (view.value === "1") {
        legend(target, ["measured", "synthesised"].slice(0, synthesised ? 2 : 1));
        for (const [word, key] of [["real part", "re"], ["imaginary part", "im"]])
          add(220, `${word}, (m/s²)/N`, cut, [{ values: measured[key], ...kMeasured }, ...(synthesised ? [{ values: synthesised[key], ...kSynthesised }] : [])], { top: 40, hooks: { draw: [nameModes] } });
        redraws.set(figure, () => {});
      } else {
        legend(target, ["measured", "synthesised", "residual"].slice(0, synthesised ? 3 : 1));
        const level = (hz) => measured.db[xs.reduce((best, x, k) => (Math.abs(x - hz) < Math.abs(xs[best] - hz) ? k : best), 0)];
        add(340, "dB re 1 (m/s²)/N", cut, [{ values: measured.db, ...kMeasured }, ...(synthesised ? [{ values: synthesised.db, ...kSynthesised }, { values: residual_dB, ...kResidual }] : [])], { top: 40, hooks: { draw: [nameModes, markPeaks(inRange, level)] } });
        redraws.set(figure, () => {});
      }
      redraws.get(figure)();
    };
    const first = fit.frfs.reduce((worst, f) => ((f.frac ?? 1) < (worst.frac ?? 1) ? f : worst));
    point.value = first.point;
    channel.value = first.channel;
    draw();
    const remarks = [];
    if (fit.frfs.length > 1) remarks.push("Shown first: the FRF with the lowest FRAC.");
    if (fit.count < fit.of) remarks.push(`Curves are drawn at ${fit.count} of ${fit.of} spectral lines, densest around the modes.`);
    if (remarks.length > 0) addElement("figcaption", figure, remarks.join(" "));
  }
};
