// A row of pictures that move together, a button that stops them, and sliders. `play` takes what draws them at a phase, 0 … 1.
const animation = (figure, kind) => {
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
