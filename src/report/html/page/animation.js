// A row of plots animated together, a pause button, and sliders. `play` takes a function that draws all plots at a phase, 0 … 1.
const animation = (figure, kind) => {
  const controls = addElement("div", figure), row = addElement("div", figure), button = addElement("button", controls), sliders = [];
  controls.className = "controls";
  row.className = kind;
  const slider = (text, value) => {
    const input = addElement("input", addElement("label", controls, `${text} `));
    Object.assign(input, { type: "range", min: 0, max: 100, value });
    sliders.push(input);
    return input;
  };
  const play = (draw) => {
    const largest = 0.25;
    let running = !reducedMotion.matches, phase = largest, onPaper = false;
    const step = (time) => {
      if (!running) return;
      phase = (time / 2000) % 1;
      if (!onPaper) draw(phase);
      requestAnimationFrame(step);
    };
    const start = () => {
      button.textContent = running ? "Pause" : "Play";
      if (running) requestAnimationFrame(step);
    };
    button.addEventListener("click", () => { running = !running; start(); });
    for (const input of sliders) input.addEventListener("input", () => draw(phase));
    // Paper shows the largest deflection.
    resizable.push((_widthOf, paper) => {
      onPaper = paper === true;
      draw(onPaper ? largest : phase);
    });
    draw(phase);
    start();
  };
  return { row, slider, play };
};
