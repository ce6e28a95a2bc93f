"use strict";
(() => {
  const data = Object.assign({}, ...JSON.parse(document.getElementById("data").textContent));
  const still = matchMedia("(prefers-reduced-motion: reduce)");
  const dark = matchMedia("(prefers-color-scheme: dark)");
  const colour = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  const dashes = [[], [8, 4], [2, 3], [10, 3, 2, 3], [5, 5], [1, 4], [12, 4], [6, 2]];
  const made = (tag, parent, text) => {
    const element = document.createElement(tag);
    if (text !== undefined) element.textContent = text;
    if (parent) parent.append(element);
    return element;
  };
  const places = (kind) => document.querySelectorAll(`[data-picture="${kind}"]`);

  // Numbers as the page carries them: from + step · k, 65535 for none.
  const numbers = (packed) => {
    const bytes = atob(packed.u16);
    const out = new Array(bytes.length / 2);
    for (let i = 0; i < out.length; ++i) {
      const k = bytes.charCodeAt(2 * i) | (bytes.charCodeAt(2 * i + 1) << 8);
      out[i] = k === 65535 ? null : packed.from + packed.step * k;
    }
    return out;
  };

  const legend = (figure, names) => {
    const list = made("ul", figure);
    list.className = "legend";
    names.forEach((name, i) => {
      const item = made("li", list);
      const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
      svg.setAttribute("width", "28");
      svg.setAttribute("height", "8");
      svg.setAttribute("aria-hidden", "true");
      const line = document.createElementNS("http://www.w3.org/2000/svg", "line");
      for (const [key, value] of [["x1", 0], ["x2", 28], ["y1", 4], ["y2", 4], ["stroke", colour(`--c${i % 8}`)], ["stroke-width", 2], ["stroke-dasharray", dashes[i % 8].join(" ")]])
        line.setAttribute(key, value);
      svg.append(line);
      item.append(svg, name);
    });
  };

  const axis = (label, more) => ({ label, stroke: colour("--ink"), grid: { stroke: colour("--rule"), width: 1 }, ticks: { stroke: colour("--rule") }, font: "13px system-ui", labelFont: "13px system-ui", ...more });
  const drawn = [];

  // A picture of curves over one x; `shared` ones move together.
  const plot = (figure, height, x, y, xs, series, options = {}) => {
    const target = made("div", figure);
    const opts = {
      width: Math.max(320, figure.clientWidth), height,
      legend: { show: false },
      cursor: { drag: { x: true, y: false }, ...(options.shared ? { sync: { key: "frequency", setSeries: false } } : {}) },
      scales: { x: { time: false }, y: options.range ? { range: options.range } : {} },
      axes: [axis(x), axis(y, { size: 64, ...(options.splits ? { splits: () => options.splits } : {}) })],
      series: [{}, ...series.map((s) => ({ stroke: s.stroke, width: s.width || 1.5, dash: s.dash, points: { show: false }, spanGaps: false, paths: s.paths }))],
      hooks: options.hooks || {},
      bands: options.bands,
      padding: [options.top || 12, 16, null, null],
    };
    const made_plot = new uPlot(opts, [xs, ...series.map((s) => s.values)], target);
    drawn.push({ plot: made_plot, figure, height });
    return made_plot;
  };

  // Where a phase leaps from one end of its circle to the other there is no line.
  const unjumped = (values) => values.map((v, k) => (k > 0 && v !== null && values[k - 1] !== null && Math.abs(v - values[k - 1]) > 300 ? null : v));

  const frequencyPictures = () => {
    const frf = data.frf;
    if (!frf || !frf.curves.length) return;
    const count = atob(frf.curves[0].db.u16).length / 2;
    const xs = Array.from({ length: count }, (_, k) => frf.first_hz + k * frf.df_hz);
    const together = [];
    let following = false;
    const follow = (u, key) => {
      if (key !== "x" || following) return;
      following = true;
      const { min, max } = u.scales.x;
      for (const other of together) if (other !== u) other.setScale("x", { min, max });
      following = false;
    };
    const colours = (i) => ({ stroke: colour(`--c${i % 8}`), dash: dashes[i % 8] });
    const nameModes = (u) => {
      const context = u.ctx;
      context.save();
      context.fillStyle = colour("--ink");
      context.strokeStyle = colour("--soft");
      context.font = `${12 * devicePixelRatio}px system-ui`;
      context.textAlign = "center";
      const free = [-Infinity, -Infinity]; // two rows of names
      for (const mode of data.modes) {
        if (mode.hz < u.scales.x.min || mode.hz > u.scales.x.max) continue;
        const at = u.valToPos(mode.hz, "x", true);
        context.beginPath();
        context.setLineDash([2 * devicePixelRatio, 3 * devicePixelRatio]);
        context.moveTo(at, u.bbox.top);
        context.lineTo(at, u.bbox.top + u.bbox.height);
        context.stroke();
        const half = context.measureText(mode.name).width / 2;
        const rowOf = free.findIndex((end) => at - half >= end);
        if (rowOf < 0) continue;
        context.fillText(mode.name, at, u.bbox.top - (6 + 15 * rowOf) * devicePixelRatio);
        free[rowOf] = at + half + 8 * devicePixelRatio;
      }
      context.restore();
    };
    for (const figure of places("magnitude")) {
      legend(figure, frf.curves.map((c) => c.name));
      const series = [], bands = [];
      // The curves set the scale: a deviation that is as large as its value reaches to nothing.
      const all = frf.curves.flatMap((c) => numbers(c.db)).filter((v) => v !== null);
      const span = [all.reduce((a, b) => Math.min(a, b), Infinity) - 5, all.reduce((a, b) => Math.max(a, b), -Infinity) + 5];
      frf.curves.forEach((curve, i) => {
        const db = numbers(curve.db);
        // The band is as far below as above, not in decibels but in amplitude.
        const below = (above) => 20 * Math.log10(Math.max(0.01, 2 - 10 ** (above / 20)));
        series.push({ values: db, ...colours(i) });
        if (curve.sigma_db) {
          const sigma = numbers(curve.sigma_db);
          series.push({ values: db.map((v, k) => (v === null || sigma[k] === null ? null : v + sigma[k])), stroke: "transparent", width: 0 });
          series.push({ values: db.map((v, k) => (v === null || sigma[k] === null ? null : v + below(sigma[k]))), stroke: "transparent", width: 0 });
          bands.push({ series: [series.length - 1, series.length], fill: colour(`--c${i % 8}`) + "33" });
        }
        if (curve.fit_db) series.push({ values: numbers(curve.fit_db), stroke: colour("--fit"), width: 0.75 });
      });
      together.push(plot(figure, 360, "frequency, Hz", "dB re 1 (m/s²)/N", xs, series, { shared: true, top: 40, range: span, bands, hooks: { draw: [nameModes], setScale: [follow] } }));
      const notes = [frf.curves.length < frf.of ? `The ${frf.curves.length} strongest of ${frf.of} FRFs.` : "", frf.curves.some((c) => c.fit_db) ? "Thin on top: the modes found." : "", frf.curves.some((c) => c.sigma_db) ? "Shaded: one standard deviation." : ""];
      made("figcaption", figure, notes.filter((note) => note).join(" "));
    }
    for (const figure of places("phase"))
      together.push(plot(figure, 180, "frequency, Hz", "phase, degrees", xs, frf.curves.map((c, i) => ({ values: unjumped(numbers(c.phase_deg)), ...colours(i) })), { shared: true, range: [-190, 190], splits: [-180, -90, 0, 90, 180], hooks: { setScale: [follow] } }));
    const coherent = frf.curves.filter((c) => c.coherence);
    for (const figure of places("coherence")) {
      if (!coherent.length) figure.remove();
      else together.push(plot(figure, 150, "frequency, Hz", "coherence", xs, coherent.map((c, i) => ({ values: numbers(c.coherence), ...colours(i) })), { shared: true, range: [0, 1.02], hooks: { setScale: [follow] } }));
    }
  };

  const hitPictures = () => {
    const hits = data.hits || [];
    for (const figure of places("force")) {
      if (!hits.length) { figure.remove(); continue; }
      legend(figure, hits.map((h) => h.name + (h.accepted ? "" : " (rejected)")));
      const curves = hits.map((h) => ({ hit: h, values: numbers(h.force_n) }));
      const ends = curves.map(({ hit, values }) => {
        const largest = values.reduce((a, b) => Math.max(a, Math.abs(b || 0)), 0);
        let last = values.length - 1;
        while (last > 0 && Math.abs(values[last] || 0) < 0.02 * largest) --last;
        return hit.start_ms + hit.step_ms * last;
      });
      const low = Math.min(...hits.map((h) => Math.max(h.start_ms, -0.5))), high = Math.max(...ends) + 0.2;
      const steps = 800, xs = Array.from({ length: steps }, (_, k) => low + ((high - low) * k) / (steps - 1));
      const at = ({ hit, values }, x) => {
        const k = (x - hit.start_ms) / hit.step_ms, i = Math.floor(k);
        return i < 0 || i + 1 >= values.length ? 0 : values[i] + (k - i) * (values[i + 1] - values[i]);
      };
      if (hits.length < data.of_hits) made("figcaption", figure, `The first ${hits.length} of ${data.of_hits} hits.`);
      plot(figure, 220, "time after the onset, ms", "force, N", xs, curves.map((c, i) => ({ values: xs.map((x) => at(c, x)), stroke: colour(`--c${i % 8}`), dash: dashes[i % 8] })));
    }
    for (const figure of places("decay")) {
      const curves = hits.map((h, i) => ({ ...h.decay, i })).filter((c) => c.db).map((c) => ({ ...c, values: numbers(c.db) }));
      if (!curves.length) { figure.remove(); continue; }
      const step = Math.min(...curves.map((c) => c.step_s));
      const longest = Math.max(...curves.map((c) => c.values.length * c.step_s));
      const xs = Array.from({ length: Math.ceil(longest / step) }, (_, k) => k * step);
      plot(figure, 220, "time after the peak, s", "response, dB", xs, curves.map((c) => ({ values: xs.map((x) => { const k = Math.round(x / c.step_s); return k < c.values.length ? c.values[k] : null; }), stroke: colour(`--c${c.i % 8}`), dash: dashes[c.i % 8] })));
      made("figcaption", figure, "Of the first accelerometer; colours as above.");
    }
  };

  const stabilisationPicture = () => {
    const diagram = data.stabilisation;
    for (const figure of places("stabilisation")) {
      if (!diagram || !diagram.order.length) { figure.remove(); continue; }
      const hz = numbers(diagram.hz);
      const kinds = [["n", "new", "·"], ["f", "stable frequency", "+"], ["d", "stable damping", "×"], ["s", "stable", "●"]];
      const list = made("ul", figure);
      list.className = "legend";
      for (const [, name, mark] of kinds) made("li", list, `${mark} ${name}`);
      const order = hz.map((_, i) => i).sort((a, b) => hz[a] - hz[b]);
      const xs = order.map((i) => hz[i]), ys = order.map((i) => diagram.order[i]), marks = order.map((i) => diagram.stability[i]);
      const dots = (u) => {
        const context = u.ctx, r = 3 * devicePixelRatio;
        context.save();
        context.strokeStyle = context.fillStyle = colour("--ink");
        xs.forEach((x, i) => {
          if (x < u.scales.x.min || x > u.scales.x.max) return;
          const px = u.valToPos(x, "x", true), py = u.valToPos(ys[i], "y", true), mark = marks[i];
          context.globalAlpha = mark === "s" ? 1 : 0.55;
          context.beginPath();
          if (mark === "s") { context.arc(px, py, r, 0, 7); context.fill(); }
          else if (mark === "n") context.fillRect(px - r / 3, py - r / 3, r / 1.5, r / 1.5);
          else {
            const [a, b] = mark === "f" ? [r, 0] : [r * 0.7, r * 0.7];
            context.moveTo(px - a, py - b); context.lineTo(px + a, py + b);
            context.moveTo(px + b, py - a); context.lineTo(px - b, py + a);
            context.stroke();
          }
        });
        context.globalAlpha = 1;
        context.strokeStyle = colour("--c1");
        for (const mode of data.modes || []) {
          const px = u.valToPos(mode.hz, "x", true);
          if (mode.hz < u.scales.x.min || mode.hz > u.scales.x.max) continue;
          context.beginPath(); context.moveTo(px, u.bbox.top); context.lineTo(px, u.bbox.top + u.bbox.height); context.stroke();
        }
        context.restore();
      };
      plot(figure, 300, "frequency, Hz", "model order", xs, [{ values: ys, stroke: "transparent", paths: () => null }], { hooks: { draw: [dots] } });
      made("figcaption", figure, "Lines: the modes found.");
    }
  };

  // How a ring moves that two sensors saw: bending shifts it, hoop turns it into an ellipse.
  const ringOf = (mode) => {
    const [a, b] = mode.sensors;
    const strong = [a, b].reduce((x, y) => (Math.hypot(x.re, x.im) >= Math.hypot(y.re, y.im) ? x : y));
    const turn = Math.atan2(strong.im, strong.re), part = (s) => s.re * Math.cos(turn) + s.im * Math.sin(turn);
    const n = mode.family === "hoop" ? 2 : 1;
    const m = [[Math.cos(n * a.angle_rad), Math.sin(n * a.angle_rad)], [Math.cos(n * b.angle_rad), Math.sin(n * b.angle_rad)]];
    const v = [part(a), part(b)];
    // The smallest movement that both sensors agree to (they may be blind to one pattern).
    const g = [[m[0][0] ** 2 + m[1][0] ** 2 + 1e-9, m[0][0] * m[0][1] + m[1][0] * m[1][1]], [0, m[0][1] ** 2 + m[1][1] ** 2 + 1e-9]];
    g[1][0] = g[0][1];
    const h = [m[0][0] * v[0] + m[1][0] * v[1], m[0][1] * v[0] + m[1][1] * v[1]];
    const det = g[0][0] * g[1][1] - g[0][1] * g[1][0];
    const c = (g[1][1] * h[0] - g[0][1] * h[1]) / det, s = (g[0][0] * h[1] - g[1][0] * h[0]) / det, size = Math.hypot(c, s) || 1;
    return { n, c: c / size, s: s / size };
  };

  // A row of pictures that move together, a button that stops them, and sliders. `play` takes what draws them at a phase, 0 … 1.
  const stage = (figure, kind) => {
    const controls = made("div", figure), row = made("div", figure), button = made("button", controls), sliders = [];
    controls.className = "controls";
    row.className = kind;
    const slider = (text, value) => {
      const input = made("input", made("label", controls, `${text} `));
      Object.assign(input, { type: "range", min: 0, max: 100, value });
      sliders.push(input);
      return input;
    };
    const play = (draw) => {
      let running = !still.matches, phase = 0.25;
      const step = (time) => {
        if (!running) return;
        phase = (time / 2000) % 1;
        draw(phase);
        requestAnimationFrame(step);
      };
      const start = () => {
        button.textContent = running ? "Pause" : "Play";
        if (running) requestAnimationFrame(step);
      };
      button.addEventListener("click", () => { running = !running; start(); });
      for (const input of sliders) input.addEventListener("input", () => draw(phase));
      draw(phase);
      start();
    };
    return { row, slider, play };
  };

  const movementPictures = () => {
    const modes = (data.modes || []).filter((m) => m.sensors.length === 2 && m.family !== "unknown");
    for (const figure of places("movement")) {
      if (!modes.length) { figure.closest("section").remove(); continue; }
      const { row, slider, play } = stage(figure, "barrels");
      const amplitude = slider("amplitude", 60);
      const rings = modes.map((mode) => {
        const box = made("div", row), canvas = made("canvas", box);
        canvas.width = canvas.height = 150 * devicePixelRatio;
        made("p", box, mode.name);
        made("p", box, `${mode.hz.toPrecision(4)} Hz`);
        return { canvas, ring: ringOf(mode) };
      });
      play((phase) => {
        for (const { canvas, ring } of rings) {
          const context = canvas.getContext("2d"), middle = canvas.width / 2, r = 0.62 * middle;
          const size = (0.35 * amplitude.value * r) / 100, now = Math.sin(2 * Math.PI * phase);
          context.clearRect(0, 0, canvas.width, canvas.height);
          const outline = (amount, style, width) => {
            context.beginPath();
            for (let k = 0; k <= 180; ++k) {
              // Outwards, and along the ring so that it keeps its length: n = 1 is a shift, n = 2 an ellipse.
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
      made("figcaption", figure, "Looked at along the axis from the barrel's end; 0° points right, 90° up. Exaggerated.");
    }
  };

  // Points and lines seen from above at an angle that the slider turns; every mode in a picture of its own.
  const shapePictures = () => {
    const shapes = data.shapes;
    for (const figure of places("shapes")) {
      if (!shapes || shapes.points.length < 2) { figure.remove(); continue; }
      const { row, slider, play } = stage(figure, "shapes");
      const amplitude = slider("amplitude", 50), turn = slider("turn", 35), tilt = slider("tilt", 30);
      const middle = [0, 1, 2].map((i) => shapes.points.reduce((sum, p) => sum + p[i], 0) / shapes.points.length);
      const radius = Math.max(...shapes.points.map((p) => Math.hypot(p[0] - middle[0], p[1] - middle[1], p[2] - middle[2]))) || 1;
      const pictures = shapes.modes.map((mode) => {
        const box = made("div", row), canvas = made("canvas", box);
        canvas.width = 300 * devicePixelRatio;
        canvas.height = 240 * devicePixelRatio;
        made("p", box, `${mode.name}, ${mode.hz.toPrecision(4)} Hz`);
        const largest = mode.moves.reduce((most, x) => Math.max(most, Math.abs(x)), 0) || 1;
        return { canvas, moves: mode.moves.map((x) => x / largest) };
      });
      play((phase) => {
        const a = (turn.value / 100) * Math.PI, b = (tilt.value / 100) * (Math.PI / 2), size = (0.3 * radius * amplitude.value) / 100;
        const [ca, sa, cb, sb] = [Math.cos(a), Math.sin(a), Math.cos(b), Math.sin(b)];
        const c = Math.cos(2 * Math.PI * phase), s = Math.sin(2 * Math.PI * phase);
        for (const { canvas, moves } of pictures) {
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
      made("figcaption", figure, "Exaggerated; grey: at rest.");
    }
  };

  const all = () => {
    frequencyPictures();
    hitPictures();
    stabilisationPicture();
    movementPictures();
    shapePictures();
    document.documentElement.dataset.drawn = "yes";
  };
  all();
  let waiting = 0;
  addEventListener("resize", () => {
    clearTimeout(waiting);
    waiting = setTimeout(() => { for (const d of drawn) d.plot.setSize({ width: Math.max(320, d.figure.clientWidth), height: d.height }); }, 100);
  });
  dark.addEventListener("change", () => location.reload());
})();
