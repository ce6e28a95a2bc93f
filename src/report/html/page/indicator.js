// Singular values of the FRFs: the first peaks at each mode; if the second peaks as well, two modes share a frequency.
const indicatorPlot = () => {
  const indicator = data.indicator;
  for (const figure of figuresOf("indicator")) {
    if (!indicator || !indicator.values.length) { figure.remove(); continue; }
    const values = indicator.values.map(decoded);
    const xs = values[0].map((_, k) => indicator.first_hz + k * indicator.df_hz);
    legend(figure, values.map((_, i) => ["largest", "second", "third"][i] + " singular value"));
    plot(figure, 260, "frequency, Hz", "dB re 1 (m/s²)/N", xs, values.map((v, i) => ({ values: v, ...strokes(i) })), { top: 40, hooks: { draw: [nameModes] } });
  }
  for (const figure of figuresOf("mif")) {
    if (!indicator) { figure.remove(); continue; }
    const values = decoded(indicator.mif);
    const xs = values.map((_, k) => indicator.first_hz + k * indicator.df_hz);
    plot(figure, 180, "frequency, Hz", "MIF", xs, [{ values, ...strokes(0) }], { top: 40, range: [0, 1.02], hooks: { draw: [nameModes] } });
  }
};
