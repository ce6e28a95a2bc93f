// Singular values of the FRFs: a mode is a peak of the first; where the second peaks as well, two modes share a frequency.
const indicatorPlot = () => {
  const indicator = data.indicator;
  for (const figure of places("indicator")) {
    if (!indicator || !indicator.values.length) { figure.remove(); continue; }
    const values = indicator.values.map(numbers);
    const xs = values[0].map((_, k) => indicator.first_hz + k * indicator.df_hz);
    legend(figure, values.map((_, i) => ["largest", "second", "third"][i] + " singular value"));
    plot(figure, 260, "frequency, Hz", "dB re 1 (m/s²)/N", xs, values.map((v, i) => ({ values: v, ...strokes(i) })), { top: 40, hooks: { draw: [nameModes] } });
  }
};
