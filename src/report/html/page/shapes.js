// The structure in each chosen mode: at rest in grey, deflected in colour. All drawings share one view.
const shapePlots = () => {
  const shapes = data.shapes;
  for (const figure of figuresOf("shapes")) {
    if (!shapes || shapes.points.length < 2 || !shapes.modes.length) { figure.remove(); continue; }
    const state = { kind: "displacement", rest: true, sensors: true, amplitude: 0.25, phase: 0, running: !reducedMotion.matches, chosen: shapes.modes.map((_, m) => m < 6) };
    const controls = addElement("div", figure), chooser = addElement("fieldset", figure), row = addElement("div", figure);
    controls.className = "controls";
    chooser.className = "modes";
    row.className = "shapes";
    const view = shapeView(shapes, () => draw());
    const labelled = (text, input, settings) => {
      const label = addElement("label", controls), element = document.createElement(input);
      label.append(...(settings.type === "checkbox" ? [element, ` ${text}`] : [`${text} `, element]));
      return Object.assign(element, settings);
    };
    const play = addElement("button", controls), toggle = () => { state.running = !state.running; run(); };
    play.addEventListener("click", toggle);
    const phase = labelled("phase", "input", { type: "range", min: 0, max: 360, step: 5, value: 0 });
    phase.addEventListener("input", () => { Object.assign(state, { running: false, phase: (phase.value * Math.PI) / 180 }); run(); });
    const amplitude = labelled("amplitude", "input", { type: "range", min: 0, max: 100, value: 50 });
    amplitude.addEventListener("input", () => { state.amplitude = amplitude.value / 200; draw(); });
    const kind = labelled("colour", "select", {});
    for (const name of ["displacement", "phase"]) addElement("option", kind, name);
    const scale = addElement("span", controls);
    kind.addEventListener("change", () => { state.kind = kind.value; draw(); });
    for (const [text, key] of [["at rest", "rest"], ["sensors", "sensors"]]) {
      if (key === "sensors" && !shapes.sensors.length) continue;
      const box = labelled(text, "input", { type: "checkbox", checked: true });
      box.addEventListener("change", () => { state[key] = box.checked; draw(); });
    }
    for (const name of view.names) addElement("button", controls, name).addEventListener("click", () => view.show(name));
    addElement("button", controls, "Reset view").addEventListener("click", view.reset);
    addElement("legend", chooser, "Modes");
    const drawings = shapes.modes.map((packed, m) => {
      const mode = { ...packed, moves: packed.moves.map((x) => x / 1e4) }, name = `${mode.name}, ${hertz(mode.hz)} Hz`;
      const box = addElement("div", row), canvas = addElement("canvas", box), caption = addElement("p", box, name);
      if (mode.mpc < 0.9) addElement("span", caption, `; complex, phase collinearity ${mode.mpc.toFixed(2)}`);
      canvas.tabIndex = 0;
      canvas.setAttribute("role", "img");
      canvas.setAttribute("aria-label", `Shape of ${name}. Arrow keys rotate, with shift they move; plus and minus zoom; 0 resets; the space key pauses.`);
      moveView(canvas, view, toggle);
      const label = addElement("label", chooser), check = Object.assign(addElement("input", label), { type: "checkbox", checked: state.chosen[m] });
      label.append(` ${name}`);
      check.addEventListener("change", () => { state.chosen[m] = check.checked; state.touched = true; layout(widthOf(figure)); });
      return { mode, box, canvas, check };
    });
    const choose = (wanted) => {
      drawings.forEach(({ check }, m) => { check.checked = state.chosen[m] = wanted(m); });
      state.touched = true;
      layout(widthOf(figure));
    };
    addElement("button", chooser, "All").addEventListener("click", () => choose(() => true));
    for (const [text, by] of [["Previous alone", -1], ["Next alone", 1]]) {
      addElement("button", chooser, text).addEventListener("click", () => {
        const at = state.chosen.indexOf(true), count = drawings.length, alone = state.chosen.filter(Boolean).length === 1;
        const next = alone ? (at + by + count) % count : Math.max(at, 0);
        choose((m) => m === next);
      });
    }
    const drawOne = ({ canvas, mode }) => drawShape(canvas, shapes, mode, view, { ...state, signs: !state.running, colours: state.colours }, state.phase);
    const draw = () => {
      state.colours = shapeColours(shapes.faces.length > 0);
      scale.className = `scale ${state.kind}`;
      scale.textContent = state.kind === "phase" ? "0° 90° 180° 270°" : "− 0 +";
      drawings.forEach((drawing, m) => { if (state.chosen[m]) drawOne(drawing); });
    };
    const layout = (width) => {
      const count = state.chosen.filter(Boolean).length, columns = Math.min(count, width < 500 ? 1 : count < 3 ? count : width < 800 ? 2 : 3);
      const each = Math.floor((width - 16 * (columns - 1)) / columns), height = Math.round(Math.min(each * Math.max(0.4, Math.min(1, view.aspect)), 520));
      drawings.forEach(({ box, canvas }, m) => {
        box.hidden = !state.chosen[m];
        box.style.width = `${each}px`;
        canvas.style.width = `${each}px`;
        canvas.style.height = `${height}px`;
        canvas.width = Math.round(each * devicePixelRatio);
        canvas.height = Math.round(height * devicePixelRatio);
      });
      draw();
    };
    const step = (time) => {
      if (!state.running) return;
      state.phase = ((time / 2000) % 1) * 2 * Math.PI;
      phase.value = (state.phase * 180) / Math.PI;
      drawings.forEach((drawing, m) => {
        const seen = drawing.canvas.getBoundingClientRect();
        if (state.chosen[m] && seen.bottom > 0 && seen.top < innerHeight) drawOne(drawing);
      });
      requestAnimationFrame(step);
    };
    const setRunning = () => {
      play.textContent = state.running ? "Pause" : "Play";
      if (state.running) requestAnimationFrame(step);
    };
    const run = () => { setRunning(); draw(); };
    const caption = addElement("figcaption", figure, "Grey: at rest. Colour: displacement along the normal of the structure, + outwards or up, or its phase");
    addElement("span", caption, ", as chosen above").className = "screen";
    caption.append(". Signs");
    addElement("span", caption, ", while paused").className = "screen";
    caption.append(": direction of the displacement. Arrows: sensors. Exaggerated; phase 0° is the largest deflection.");
    addElement("p", figure, "Drag to rotate, shift-drag to move; click a drawing, then zoom with the wheel or two fingers. Keys: arrows, shift with arrows, +, −, 0, space.").className = "hint";
    // Paper shows the largest deflection.
    resizable.push((widthOf, paper) => {
      if (paper) {
        state.before = { running: state.running, phase: state.phase, chosen: [...state.chosen] };
        Object.assign(state, { running: false, phase: 0 });
        if (!state.touched) state.chosen.fill(true);
      } else if (state.before) {
        Object.assign(state, state.before, { before: undefined });
        run();
      }
      layout(widthOf(figure));
    });
    darkScheme.addEventListener("change", draw);
    layout(widthOf(figure));
    setRunning();
  }
};
