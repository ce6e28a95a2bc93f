const began = performance.now();
for (const draw of [frequencyPlots, indicatorPlot, hitPlots, stabilisationPlot, bendingPlots, crossSectionPlots, shapePlots]) draw();
document.documentElement.dataset.drawn = "yes";
document.documentElement.dataset.drawnMs = Math.round(performance.now() - began);

const fit = (widthOf) => { for (const d of drawn) d.plot.setSize({ width: Math.max(320, widthOf(d.figure)), height: d.height }); };
let waiting = 0;
addEventListener("resize", () => {
  clearTimeout(waiting);
  waiting = setTimeout(() => fit((figure) => figure.clientWidth), 100);
});
const redraw = () => { for (const d of drawn) d.plot.redraw(); };
dark.addEventListener("change", redraw);

// Paper is white and as wide as it is, and hides nothing.
const kPaperWidth = 640;
addEventListener("beforeprint", () => {
  document.documentElement.dataset.paper = "yes";
  for (const details of document.querySelectorAll("details")) details.open = true;
  fit(() => kPaperWidth);
});
addEventListener("afterprint", () => {
  delete document.documentElement.dataset.paper;
  fit((figure) => figure.clientWidth);
});
