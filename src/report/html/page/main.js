const began = performance.now();
for (const draw of [frequencyPlots, fitPlots, indicatorPlot, hitPlots, stabilisationPlot, bendingPlots, crossSectionPlots, shapePlots]) draw();
document.documentElement.dataset.drawn = "yes";
document.documentElement.dataset.drawnMs = Math.round(performance.now() - began);

const resize = (widthOf, paper) => {
  for (const d of plots) d.plot.setSize({ width: Math.max(320, widthOf(d.figure)), height: d.height });
  for (const redraw of redraws.values()) redraw();
  for (const change of resizable) change((figure) => Math.max(320, widthOf(figure)), paper);
};
let waiting = 0;
addEventListener("resize", () => {
  clearTimeout(waiting);
  waiting = setTimeout(() => resize((figure) => figure.clientWidth), 100);
});
darkScheme.addEventListener("change", () => {
  for (const d of plots) d.plot.redraw();
  for (const redraw of redraws.values()) redraw();
});

// Printing: white background, a fixed width, and no folded details.
const paperWidth = Number(colour("--print-width"));
addEventListener("beforeprint", () => {
  document.documentElement.dataset.paper = "yes";
  for (const details of document.querySelectorAll("details")) details.open = true;
  resize(() => paperWidth, true);
});
addEventListener("afterprint", () => {
  delete document.documentElement.dataset.paper;
  resize((figure) => figure.clientWidth);
});
