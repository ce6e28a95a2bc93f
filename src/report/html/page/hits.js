const kBandwidth_dB = -20; // defines the bandwidth of the force

// Plots the curves of the hits over one x: linear between samples, `outside` before the first and after the last.
const hitPlot = (figure, curves, steps, low, high, outside, x, y, options) => {
  const xs = Array.from({ length: steps }, (_, k) => low + ((high - low) * k) / (steps - 1));
  const at = ({ first, step, values }, place) => {
    const k = (place - first) / step, i = Math.floor(k);
    if (i < 0 || i + 1 >= values.length) return outside;
    return values[i] === null || values[i + 1] === null ? null : values[i] + (k - i) * (values[i + 1] - values[i]);
  };
  return plot(figure, 220, x, y, xs, curves.map((c) => ({ values: xs.map((place) => at(c, place)), ...strokes(c.i) })), options);
};

const samplesOf = (hits, kind, unit) =>
  hits.map((hit, i) => ({ hit, i, samples: hit[kind] })).filter((c) => c.samples)
    .map((c) => ({ hit: c.hit, i: c.i, first: c.samples.first * unit, step: c.samples.step * unit, values: decoded(c.samples.values) }));

const endOf = (c) => c.first + c.step * (c.values.length - 1);

const hitPlots = () => {
  const hits = data.hits || [];
  const eachFigure = (kind, name, unit, draw) => {
    for (const figure of figuresOf(kind)) {
      const curves = samplesOf(hits, name, unit);
      if (curves.length) draw(figure, curves);
      else figure.remove();
    }
  };
  eachFigure("force", "force_n", 1e3, (figure, curves) => {
    legend(figure, hits.map((h) => h.name + (h.accepted ? "" : " (rejected)")));
    const ends = curves.map((c) => {
      const largest = c.values.reduce((a, b) => Math.max(a, Math.abs(b || 0)), 0);
      let last = c.values.length - 1;
      while (last > 0 && Math.abs(c.values[last] || 0) < 0.02 * largest) --last;
      return c.first + c.step * last;
    });
    if (hits.length < data.of_hits) addElement("figcaption", figure, `The first ${hits.length} of ${data.of_hits} hits.`);
    hitPlot(figure, curves, 800, Math.min(...curves.map((c) => Math.max(c.first, -0.5))), Math.max(...ends) + 0.2, 0, "time after the onset, ms", "force, N");
  });
  eachFigure("response", "response_mps2", 1e3, (figure, curves) => {
    hitPlot(figure, curves, 800, Math.min(...curves.map((c) => Math.max(c.first, -0.5))), Math.max(...curves.map(endOf)), null, "time after the onset, ms", "response, m/s²");
    addElement("figcaption", figure, "First accelerometer. Colours as above.");
  });
  eachFigure("spectrum", "spectrum_db", 1, (figure, curves) => {
    const bandwidth = (u) => inCanvas(u, (context) => {
      context.strokeStyle = colour("--soft");
      context.setLineDash([6 * devicePixelRatio, 4 * devicePixelRatio]);
      const at = u.valToPos(kBandwidth_dB, "y", true);
      context.beginPath();
      context.moveTo(u.bbox.left, at);
      context.lineTo(u.bbox.left + u.bbox.width, at);
      context.stroke();
      context.setLineDash([2 * devicePixelRatio, 3 * devicePixelRatio]);
      for (const edge of data.band_hz || []) drawVerticalLine(u, edge);
    });
    hitPlot(figure, curves, 600, 0, Math.max(...curves.map(endOf)), null, "frequency, Hz", "force, dB", { range: [-45, 3], hooks: { draw: [bandwidth] } });
    addElement("figcaption", figure, `Spectrum of the force. Dashed: −20 dB, which defines the usable bandwidth${data.band_hz ? "; dotted: the analysed band" : ""}. Colours as above.`);
  });
  eachFigure("decay", "decay_db", 1, (figure, curves) => {
    const withNoise = curves.filter((c) => c.hit.noise_db !== null);
    const noise = (u) => inCanvas(u, (context) => {
      context.setLineDash([2 * devicePixelRatio, 4 * devicePixelRatio]);
      for (const c of withNoise) {
        const at = u.valToPos(c.hit.noise_db, "y", true);
        if (at > u.bbox.top + u.bbox.height) continue;
        context.strokeStyle = colour(`--c${c.i % 8}`);
        context.beginPath();
        context.moveTo(u.bbox.left, at);
        context.lineTo(u.bbox.left + u.bbox.width, at);
        context.stroke();
      }
    });
    hitPlot(figure, curves, 800, 0, Math.max(...curves.map(endOf)), null, "time after the force's peak, s", "response, dB", { hooks: { draw: [noise] } });
    addElement("figcaption", figure, `Decay of the first accelerometer.${withNoise.length ? " Dotted: its noise before the hit." : ""} Colours as above.`);
  });
};
