// The bent bat: its outline if known, else a line; nodes with their ± as vertical bands.
const bendingPlots = () => {
  const bending = data.bending;
  for (const figure of figuresOf("bending")) {
    if (!bending || !bending.modes.length) { figure.remove(); continue; }
    const { row, slider, play } = animation(figure, "bats");
    const amplitude = slider("amplitude", 50);
    const all = bending.outline.map(([z]) => z).concat(bending.modes.flatMap((m) => m.z_m));
    const low = Math.min(...all), high = Math.max(...all);
    const drawings = bending.modes.map((mode) => {
      const box = addElement("div", row), canvas = addElement("canvas", box);
      canvas.width = 640 * devicePixelRatio;
      canvas.height = 120 * devicePixelRatio;
      addElement("p", box, `${mode.name}, ${mode.hz.toPrecision(5)} Hz${mode.nodes.length ? `; nodes: ${mode.nodes.map((n) => n.text).join("; ")}` : ""}`);
      return { canvas, mode };
    });
    play((phase) => {
      const now = Math.sin(2 * Math.PI * phase) * amplitude.value / 100;
      for (const { canvas, mode } of drawings) {
        const context = canvas.getContext("2d"), margin = 16 * devicePixelRatio;
        const scale = (canvas.width - 2 * margin) / (high - low), middle = canvas.height / 2, largest = 0.3 * canvas.height;
        const across = (z) => margin + (bending.from_right ? high - z : z - low) * scale;
        const deflection = (z) => {
          const k = mode.z_m.findIndex((at) => at >= z);
          if (k < 0) return mode.y[mode.y.length - 1];
          if (k === 0) return mode.y[0];
          const fraction = (z - mode.z_m[k - 1]) / (mode.z_m[k] - mode.z_m[k - 1]);
          return mode.y[k - 1] + fraction * (mode.y[k] - mode.y[k - 1]);
        };
        context.clearRect(0, 0, canvas.width, canvas.height);
        context.strokeStyle = colour("--rule");
        context.lineWidth = devicePixelRatio;
        context.beginPath();
        context.moveTo(margin, middle);
        context.lineTo(canvas.width - margin, middle);
        context.stroke();
        const outline = bending.outline.length ? bending.outline : mode.z_m.map((z) => [z, 0]);
        context.beginPath();
        for (const [z, r] of outline) context.lineTo(across(z), middle - now * largest * deflection(z) - r * scale);
        for (const [z, r] of [...outline].reverse()) context.lineTo(across(z), middle - now * largest * deflection(z) + r * scale);
        context.closePath();
        context.fillStyle = colour("--c0") + "33";
        context.fill();
        context.strokeStyle = colour("--c0");
        context.lineWidth = 2 * devicePixelRatio;
        context.stroke();
        context.strokeStyle = context.fillStyle = colour("--c1");
        for (const node of mode.nodes) {
          const at = across(node.z_m), half = node.std_m * scale;
          context.globalAlpha = 0.3;
          context.fillRect(at - half, middle - 0.42 * canvas.height, 2 * half, 0.84 * canvas.height);
          context.globalAlpha = 1;
          context.beginPath();
          context.moveTo(at, middle - 0.42 * canvas.height);
          context.lineTo(at, middle + 0.42 * canvas.height);
          context.stroke();
        }
      }
    });
    addElement("figcaption", figure, `${bending.ends} Exaggerated; vertical lines: nodes${bending.modes.some((m) => m.nodes.some((n) => n.std_m > 0)) ? "; bands: their ±" : ""}.`);
  }
};
