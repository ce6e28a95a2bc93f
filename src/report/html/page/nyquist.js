// Round tick values of an axis from `low` to `high`, about `count` of them.
const roundTicks = (low, high, count) => {
  const raw = (high - low) / count, power = 10 ** Math.floor(Math.log10(raw));
  const step = power * ([1, 2, 5, 10].find((m) => m * power >= raw) || 10), out = [];
  for (let k = Math.ceil(low / step); k * step <= high; ++k) out.push(k * step);
  return out;
};
// Four significant digits without rounding errors such as 0.30000000000000004.
const tickText = (value) => String(Number(value.toPrecision(4)));

// Draws curves {re, im, dots, stroke} in the complex plane with equal scales of both axes.
const drawNyquist = (canvas, curves) => {
  const width = canvas.clientWidth || 640, height = canvas.clientHeight || 420, context = canvas.getContext("2d");
  canvas.width = width * devicePixelRatio;
  canvas.height = height * devicePixelRatio;
  context.scale(devicePixelRatio, devicePixelRatio);
  const box = { left: 70, top: 12, width: width - 86, height: height - 60 };
  const bounds = (part) => curves.flatMap((c) => c[part]).reduce(([a, b], v) => [Math.min(a, v), Math.max(b, v)], [0, 0]);
  const [reLow, reHigh] = bounds("re"), [imLow, imHigh] = bounds("im");
  const perPixel = 1.1 * Math.max((reHigh - reLow) / box.width, (imHigh - imLow) / box.height) || 1;
  const middle = [(reLow + reHigh) / 2, (imLow + imHigh) / 2];
  const x = (v) => box.left + box.width / 2 + (v - middle[0]) / perPixel, y = (v) => box.top + box.height / 2 - (v - middle[1]) / perPixel;
  const line = (from, to, style) => {
    context.strokeStyle = style;
    context.beginPath();
    context.moveTo(...from);
    context.lineTo(...to);
    context.stroke();
  };
  context.font = "13px system-ui";
  context.fillStyle = colour("--ink");
  const across = [middle[0] - (box.width / 2) * perPixel, middle[0] + (box.width / 2) * perPixel];
  const up = [middle[1] - (box.height / 2) * perPixel, middle[1] + (box.height / 2) * perPixel];
  context.textAlign = "center";
  for (const v of roundTicks(...across, 6)) {
    line([x(v), box.top], [x(v), box.top + box.height], colour("--rule"));
    context.fillText(tickText(v), x(v), box.top + box.height + 18);
  }
  context.fillText("real part, (m/s²)/N", box.left + box.width / 2, height - 8);
  context.textAlign = "right";
  for (const v of roundTicks(...up, 5)) {
    line([box.left, y(v)], [box.left + box.width, y(v)], colour("--rule"));
    context.fillText(tickText(v), box.left - 6, y(v) + 4);
  }
  context.save();
  context.translate(14, box.top + box.height / 2);
  context.rotate(-Math.PI / 2);
  context.textAlign = "center";
  context.fillText("imaginary part, (m/s²)/N", 0, 0);
  context.restore();
  line([x(0), box.top], [x(0), box.top + box.height], colour("--soft"));
  line([box.left, y(0)], [box.left + box.width, y(0)], colour("--soft"));
  for (const curve of curves) {
    context.strokeStyle = context.fillStyle = curve.stroke();
    context.lineWidth = curve.dots ? 1 : 1.5;
    if (curve.dots) {
      curve.re.forEach((re, k) => context.fillRect(x(re) - 1.5, y(curve.im[k]) - 1.5, 3, 3));
    } else {
      context.beginPath();
      curve.re.forEach((re, k) => context.lineTo(x(re), y(curve.im[k])));
      context.stroke();
    }
  }
};
