// Displacement of the cross-section from two sensors: bending shifts it, a hoop mode turns it into an ellipse.
const ringPattern = (mode) => {
  const [a, b] = mode.sensors;
  const strong = [a, b].reduce((x, y) => (Math.hypot(x.re, x.im) >= Math.hypot(y.re, y.im) ? x : y));
  const turn = Math.atan2(strong.im, strong.re), part = (s) => s.re * Math.cos(turn) + s.im * Math.sin(turn);
  const n = mode.family === "hoop" ? 2 : 1;
  const m = [[Math.cos(n * a.angle_rad), Math.sin(n * a.angle_rad)], [Math.cos(n * b.angle_rad), Math.sin(n * b.angle_rad)]];
  const v = [part(a), part(b)];
  // The smallest displacement that both sensors agree with; regularised, as both may sit on nodes of one pattern.
  const g = [[m[0][0] ** 2 + m[1][0] ** 2 + 1e-9, m[0][0] * m[0][1] + m[1][0] * m[1][1]], [0, m[0][1] ** 2 + m[1][1] ** 2 + 1e-9]];
  g[1][0] = g[0][1];
  const h = [m[0][0] * v[0] + m[1][0] * v[1], m[0][1] * v[0] + m[1][1] * v[1]];
  const det = g[0][0] * g[1][1] - g[0][1] * g[1][0];
  const c = (g[1][1] * h[0] - g[0][1] * h[1]) / det, s = (g[0][0] * h[1] - g[1][0] * h[0]) / det, size = Math.hypot(c, s) || 1;
  return { n, c: c / size, s: s / size };
};

const crossSectionPlots = () => {
  const modes = (data.modes || []).filter((m) => m.sensors.length === 2 && m.family !== "unknown");
  for (const figure of figuresOf("movement")) {
    if (!modes.length) { figure.closest("section").remove(); continue; }
    const { row, slider, play } = animation(figure, "barrels");
    const amplitude = slider("amplitude", 60);
    const rings = modes.map((mode) => {
      const box = addElement("div", row), canvas = addElement("canvas", box);
      canvas.width = canvas.height = 150 * devicePixelRatio;
      addElement("p", box, mode.name);
      addElement("p", box, `${hertz(mode.hz)} Hz`);
      return { canvas, ring: ringPattern(mode) };
    });
    play((phase) => {
      for (const { canvas, ring } of rings) {
        const context = canvas.getContext("2d"), middle = canvas.width / 2, r = 0.62 * middle;
        const size = (0.35 * amplitude.value * r) / 100, now = Math.sin(2 * Math.PI * phase);
        context.clearRect(0, 0, canvas.width, canvas.height);
        const outline = (amount, style, width) => {
          context.beginPath();
          for (let k = 0; k <= 180; ++k) {
            // Radial, and tangential so that the ring keeps its length: n = 1 is a shift, n = 2 an ellipse.
            const t = (k * Math.PI) / 90, [c, s] = [Math.cos(ring.n * t), Math.sin(ring.n * t)];
            const out = r + amount * size * (ring.c * c + ring.s * s), along = (amount * size * (ring.s * c - ring.c * s)) / ring.n;
            context.lineTo(middle + out * Math.cos(t) - along * Math.sin(t), middle - out * Math.sin(t) - along * Math.cos(t));
          }
          context.strokeStyle = style;
          context.lineWidth = width * devicePixelRatio;
          context.stroke();
        };
        outline(0, colour("--rule"), 1);
        outline(now, colour("--c0"), 3);
      }
    });
    addElement("figcaption", figure, "View along the axis from the barrel's end; 0° points right, 90° up. Exaggerated.");
  }
};
