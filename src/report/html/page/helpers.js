"use strict";
const data = Object.assign({}, ...JSON.parse(document.getElementById("data").textContent));
const reducedMotion = matchMedia("(prefers-reduced-motion: reduce)");
const darkScheme = matchMedia("(prefers-color-scheme: dark)");
// The colours of the page, each read once: when a style is read after a change of the document, a browser computes all
// styles again. Paper and a dark screen have other colours: call forgetColours when that changes.
const knownColours = new Map();
const forgetColours = () => knownColours.clear();
darkScheme.addEventListener("change", forgetColours);
const colour = (name) => {
  if (!knownColours.has(name)) knownColours.set(name, getComputedStyle(document.documentElement).getPropertyValue(name).trim());
  return knownColours.get(name);
};
const dashes = [[], [8, 4], [2, 3], [10, 3, 2, 3], [5, 5], [1, 4], [12, 4], [6, 2]];
// Four significant digits; whole hertz from 10 kHz, without an exponent.
const hertz = (hz) => (hz >= 9999.5 ? hz.toFixed(0) : hz.toPrecision(4));
const strokes = (i) => ({ stroke: () => colour(`--c${i % 8}`), dash: dashes[i % 8] });

const addElement = (tag, parent, text) => {
  const element = document.createElement(tag);
  if (text !== undefined) element.textContent = text;
  if (parent) parent.append(element);
  return element;
};
const figuresOf = (kind) => document.querySelectorAll(`[data-plot="${kind}"]`);

// Widths of the figures, all read before the first of them is drawn: a width read after a change of the document costs a layout of
// the whole page.
const figures = [...document.querySelectorAll("[data-plot]")];
const widths = new Map(figures.map((figure) => [figure, figure.clientWidth]));
const readWidths = () => { for (const figure of figures) widths.set(figure, figure.clientWidth); };
const widthOf = (figure) => widths.get(figure);

// Decodes a quantised curve: from + step · k, null for k = 65535.
const decoded = (packed) => {
  const bytes = atob(packed.u16);
  const out = new Array(bytes.length / 2);
  for (let i = 0; i < out.length; ++i) {
    const k = bytes.charCodeAt(2 * i) | (bytes.charCodeAt(2 * i + 1) << 8);
    out[i] = k === 65535 ? null : packed.from + packed.step * k;
  }
  return out;
};

const legend = (figure, names) => {
  const list = addElement("ul", figure);
  list.className = "legend";
  names.forEach((name, i) => {
    const item = addElement("li", list);
    const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
    svg.setAttribute("width", "28");
    svg.setAttribute("height", "8");
    svg.setAttribute("aria-hidden", "true");
    const line = document.createElementNS("http://www.w3.org/2000/svg", "line");
    for (const [key, value] of [["x1", 0], ["x2", 28], ["y1", 4], ["y2", 4], ["stroke", `var(--c${i % 8})`], ["stroke-width", 2], ["stroke-dasharray", dashes[i % 8].join(" ")]])
      line.setAttribute(key, value);
    svg.append(line);
    item.append(svg, name);
  });
};

const axis = (label, more) => ({ label, stroke: () => colour("--ink"), grid: { stroke: () => colour("--rule"), width: 1 }, ticks: { stroke: () => colour("--rule") }, font: "13px system-ui", labelFont: "13px system-ui", ...more });
const plots = [];
// By figure, functions that redraw figures without uPlot. They are called when the size or the colours change.
const redraws = new Map();
// Functions (widthOf, paper) that redraw figures at another size: widthOf(figure) is the width; paper is true in print.
const resizable = [];

// Plots curves over one x. Plots with `shared` zoom together.
const plot = (figure, height, x, y, xs, series, options = {}) => {
  const target = options.target || addElement("div", figure);
  const opts = {
    width: Math.max(320, widthOf(figure)), height,
    legend: { show: false },
    cursor: { drag: { x: true, y: false }, ...(options.shared ? { sync: { key: "frequency", setSeries: false } } : {}) },
    scales: { x: { time: false, distr: options.logarithmic ? 3 : 1 }, y: options.range ? { range: options.range } : {} },
    axes: [axis(x), axis(y, { size: 64, ...(options.splits ? { splits: () => options.splits } : {}) })],
    series: [{}, ...series.map((s) => ({ stroke: s.stroke, width: s.width || 1.5, dash: s.dash, points: { show: false }, spanGaps: false, paths: s.paths }))],
    hooks: options.hooks || {},
    bands: options.bands,
    padding: [options.top || 12, 28, null, null],
  };
  const newPlot = new uPlot(opts, [xs, ...series.map((s) => s.values)], target);
  plots.push({ plot: newPlot, figure, height });
  return newPlot;
};

const inCanvas = (u, draw) => {
  u.ctx.save();
  draw(u.ctx);
  u.ctx.restore();
};

// A vertical line over the whole height of a plot.
const drawVerticalLine = (u, x) => {
  if (x < u.scales.x.min || x > u.scales.x.max) return;
  const at = u.valToPos(x, "x", true);
  u.ctx.beginPath();
  u.ctx.moveTo(at, u.bbox.top);
  u.ctx.lineTo(at, u.bbox.top + u.bbox.height);
  u.ctx.stroke();
};
