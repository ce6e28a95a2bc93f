// The structure's points and lines from a viewpoint set by the sliders, one animated drawing per mode.
const shapePlots = () => {
  const shapes = data.shapes;
  for (const figure of figuresOf("shapes")) {
    if (!shapes || shapes.points.length < 2) { figure.remove(); continue; }
    const { row, slider, play } = animation(figure, "shapes");
    const amplitude = slider("amplitude", 50), turn = slider("turn", 35), tilt = slider("tilt", 30);
    const middle = [0, 1, 2].map((i) => shapes.points.reduce((sum, p) => sum + p[i], 0) / shapes.points.length);
    const radius = Math.max(...shapes.points.map((p) => Math.hypot(p[0] - middle[0], p[1] - middle[1], p[2] - middle[2]))) || 1;
    const drawings = shapes.modes.map((mode) => {
      const box = addElement("div", row), canvas = addElement("canvas", box);
      canvas.width = 300 * devicePixelRatio;
      canvas.height = 240 * devicePixelRatio;
      addElement("p", box, `${mode.name}, ${hertz(mode.hz)} Hz`);
      const largest = mode.moves.reduce((max, x) => Math.max(max, Math.abs(x)), 0) || 1;
      return { canvas, moves: mode.moves.map((x) => x / largest) };
    });
    play((phase) => {
      const a = (turn.value / 100) * Math.PI, b = (tilt.value / 100) * (Math.PI / 2), size = (0.3 * radius * amplitude.value) / 100;
      const [ca, sa, cb, sb] = [Math.cos(a), Math.sin(a), Math.cos(b), Math.sin(b)];
      const c = Math.cos(2 * Math.PI * phase), s = Math.sin(2 * Math.PI * phase);
      for (const { canvas, moves } of drawings) {
        const context = canvas.getContext("2d"), scale = (0.37 * canvas.height) / radius;
        const at = (p, i, amount) => {
          const q = [0, 1, 2].map((k) => p[k] - middle[k] + amount * size * (moves[6 * i + 2 * k] * s + moves[6 * i + 2 * k + 1] * c));
          const across = q[0] * ca - q[1] * sa, away = q[0] * sa + q[1] * ca;
          return [canvas.width / 2 + scale * across, canvas.height / 2 - scale * (q[2] * cb + away * sb)];
        };
        context.clearRect(0, 0, canvas.width, canvas.height);
        for (const [amount, style, width] of [[0, colour("--rule"), 1], [1, colour("--c0"), 2]]) {
          const spots = shapes.points.map((p, i) => at(p, i, amount));
          context.strokeStyle = context.fillStyle = style;
          context.lineWidth = width * devicePixelRatio;
          context.beginPath();
          for (const [from, to] of shapes.lines) {
            context.moveTo(...spots[from]);
            context.lineTo(...spots[to]);
          }
          context.stroke();
          for (const [x, y] of spots) context.fillRect(x - width * devicePixelRatio, y - width * devicePixelRatio, 2 * width * devicePixelRatio, 2 * width * devicePixelRatio);
        }
      }
    });
    addElement("figcaption", figure, "Exaggerated; grey: at rest.");
  }
};
