const began = performance.now();
for (const draw of [frequencyPlots, fitPlots, indicatorPlot, hitPlots, stabilisationPlot, bendingPlots, crossSectionPlots, shapePlots]) draw();
document.documentElement.dataset.drawn = "yes";
document.documentElement.dataset.drawnMs = Math.round(performance.now() - began);

const resize = (widthNow, paper) => {
  for (const d of plots) d.plot.setSize({ width: Math.max(320, widthNow(d.figure)), height: d.height });
  for (const redraw of redraws.values()) redraw();
  for (const change of resizable) change((figure) => Math.max(320, widthNow(figure)), paper);
};
const resizeToWindow = () => {
  readWidths();
  resize(widthOf);
};
// A scroll bar that appeared with the drawings makes the figures narrower.
requestAnimationFrame(() => { if (figures.some((figure) => figure.isConnected && figure.clientWidth !== widths.get(figure))) resizeToWindow(); });
let waiting = 0;
addEventListener("resize", () => {
  clearTimeout(waiting);
  waiting = setTimeout(resizeToWindow, 100);
});
darkScheme.addEventListener("change", () => {
  for (const d of plots) d.plot.redraw();
  for (const redraw of redraws.values()) redraw();
});

// Printing: white background, a fixed width, and no folded details.
const paperWidth = Number(colour("--print-width"));
addEventListener("beforeprint", () => {
  document.documentElement.dataset.paper = "yes";
  forgetColours();
  for (const details of document.querySelectorAll("details")) details.open = true;
  resize(() => paperWidth, true);
});
addEventListener("afterprint", () => {
  delete document.documentElement.dataset.paper;
  forgetColours();
  resizeToWindow();
});
