// SPDX-License-Identifier: GPL-3.0-or-later
// Series over time, in plots under one cursor.
"use strict";

// Okabe and Ito's colours, which the colour-blind tell apart, darkened where they are too light for lines on white.
const kLineColours = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#8c6d00", "#3aa0d8", "#444444", "#7a3db8"];
const kDashes = [[], [5, 3], [1.5, 2.5]];
const kMargin = {left: 58, right: 18, top: 6, bottom: 20};

const lineStyle = i => ({
  colour: kLineColours[i % kLineColours.length],
  dash: kDashes[Math.floor(i / kLineColours.length) % kDashes.length],
});

const kSuperscripts = {"-": "\u207b", 0: "\u2070", 1: "\u00b9", 2: "\u00b2", 3: "\u00b3", 4: "\u2074", 5: "\u2075",
  6: "\u2076", 7: "\u2077", 8: "\u2078", 9: "\u2079"};
const powerOfTen = exponent => "10" + [...String(exponent)].map(digit => kSuperscripts[digit]).join("");

/// The axis of values: from, to (logarithms where it is logarithmic), ticks [place, label] and its unit.
const valueAxis = (lines, logarithmic, unit) => {
  let low = Infinity, high = -Infinity;
  for (const {value} of lines) {
    for (const x of value) {
      if (!isFinite(x) || (logarithmic && x <= 0)) continue;
      low = Math.min(low, x);
      high = Math.max(high, x);
    }
  }
  if (low > high) return null;
  if (logarithmic) {
    const from = Math.floor(Math.log10(low) + 1e-6), to = Math.max(from + 1, Math.ceil(Math.log10(high) - 1e-6));
    const step = Math.ceil((to - from) / 6);
    const ticks = [];
    for (let i = from; i <= to; i += step) ticks.push([i, powerOfTen(i)]);
    return {from, to, ticks, unit};
  }
  if (low > 0 && low < 0.5 * high) low = 0;
  if (high < 0 && high > 0.5 * low) high = 0;
  const room = 0.05 * (high - low) || Math.abs(high) * 0.1 || 1;
  const from = low === 0 ? 0 : low - room, to = high === 0 && low < 0 ? 0 : high + room;
  const power = prefixPower(Math.max(Math.abs(low), Math.abs(high)), unit);
  const scale = 1000 ** power;
  const ticks = roundTicks(from / scale, to / scale, 4).map(x => [x * scale, threeDigits(x)]);
  return {from, to, ticks, unit: kPrefixes[power] + unit};
};

/// Draws a line through points; where many fall into one column of pixels, its first, least, greatest and last are what
/// is seen of them.
const drawLine = (context, {t, value}, x, y) => {
  let column = NaN, kept = [], isDown = false;
  const flush = () => {
    kept.sort((a, b) => a[0] - b[0]);
    for (const [, px, py] of kept) {
      if (isDown) context.lineTo(px, py); else context.moveTo(px, py);
      isDown = true;
    }
    kept = [];
  };
  context.beginPath();
  let low, high;
  for (let i = 0; i < t.length; ++i) {
    const px = x(t[i]), py = y(value[i]);
    if (!isFinite(py)) {
      flush();
      isDown = false;
      column = NaN;
      continue;
    }
    const point = [i, px, py];
    if (Math.floor(px) !== column) {
      flush();
      column = Math.floor(px);
      kept = [point];
      low = high = point;
    } else {
      if (py < low[2]) low = point;
      if (py > high[2]) high = point;
      kept = [...new Set([kept[0], low, high, point])];
    }
  }
  flush();
  context.stroke();
};

/// The plots of a recording within `parent`, over the times [begin, end]; `moveTo(t)` is called when one is clicked in.
const makePlots = (series, parent, begin, end, moveTo) => {
  const plots = [];
  series.forEach(line => {
    let plot = plots.find(p => p.title === line.plot);
    if (!plot) plots.push(plot = {title: line.plot, lines: []});
    plot.lines.push({...line, visible: true, ...lineStyle(plot.lines.length)});
  });
  const span = end - begin || 1;

  const draw = plot => {
    const {canvas, lines} = plot;
    const width = canvas.clientWidth, height = canvas.clientHeight, ratio = window.devicePixelRatio;
    if (width === 0) return;
    canvas.width = width * ratio;
    canvas.height = height * ratio;
    const context = canvas.getContext("2d");
    context.scale(ratio, ratio);
    const left = kMargin.left, right = width - kMargin.right, top = kMargin.top, bottom = height - kMargin.bottom;
    const shown = lines.filter(line => line.visible);
    const units = [...new Set(lines.map(line => line.unit))];
    const axis = valueAxis(shown, plot.logarithmic, units.length === 1 ? units[0] : "");
    plot.unitLabel.textContent = axis && axis.unit ? axis.unit : "";
    const x = t => left + (t - begin) / span * (right - left);
    const y = axis && (value => bottom - ((plot.logarithmic ? Math.log10(value) : value) - axis.from) /
      (axis.to - axis.from) * (bottom - top));

    context.font = "11px system-ui, 'Helvetica Neue', Arial, 'DejaVu Sans', sans-serif";
    context.fillStyle = "#52606d";
    context.lineWidth = 1;
    const rule = (x0, y0, x1, y1, colour) => {
      context.strokeStyle = colour;
      context.beginPath();
      context.moveTo(x0, y0);
      context.lineTo(x1, y1);
      context.stroke();
    };
    context.textAlign = "center";
    context.textBaseline = "top";
    const timeTicks = roundTicks(begin, begin + span, Math.max(2, Math.floor((right - left) / 75)));
    timeTicks.forEach((t, i) => {
      rule(x(t), top, x(t), bottom, "#e8ecf0");
      const isLast = i === timeTicks.length - 1;
      context.fillText(threeDigits(t) + (isLast ? " s" : ""), Math.min(x(t), right - (isLast ? 8 : 0)), bottom + 5);
    });
    if (!axis) {
      context.fillText("no values", (left + right) / 2, (top + bottom) / 2);
      return;
    }
    context.textAlign = "right";
    context.textBaseline = "middle";
    for (const [place, label] of axis.ticks) {
      const py = bottom - (place - axis.from) / (axis.to - axis.from) * (bottom - top);
      rule(left, py, right, py, place === 0 && !plot.logarithmic ? "#9aa5b1" : "#e8ecf0");
      context.fillText(label, left - 6, py);
    }
    context.strokeStyle = "#b8c2cc";
    context.strokeRect(left + 0.5, top + 0.5, right - left - 1, bottom - top - 1);
    context.save();
    context.rect(left, top, right - left, bottom - top);
    context.clip();
    context.lineWidth = 1.5;
    context.lineJoin = "round";
    for (const line of shown) {
      context.strokeStyle = line.colour;
      context.setLineDash(line.dash);
      drawLine(context, line, x, y);
    }
    context.restore();
  };

  const legendEntry = (plot, line) => {
    const sample = document.createElementNS("http://www.w3.org/2000/svg", "svg");
    sample.setAttribute("width", "18");
    sample.setAttribute("height", "4");
    const stroke = document.createElementNS("http://www.w3.org/2000/svg", "path");
    stroke.setAttribute("d", "M0 2H18");
    stroke.setAttribute("stroke", line.colour);
    stroke.setAttribute("stroke-width", "2.5");
    stroke.setAttribute("stroke-dasharray", line.dash.join(" "));
    sample.append(stroke);
    line.label = element("span");
    const entry = element("button", {type: "button", title: "Show or hide"}, sample, line.name + " ", line.label);
    entry.setAttribute("aria-pressed", "true");
    entry.addEventListener("click", () => {
      line.visible = !line.visible;
      entry.setAttribute("aria-pressed", String(line.visible));
      draw(plot);
    });
    return entry;
  };

  for (const plot of plots) {
    plot.logarithmic = plot.lines.some(line => line.logarithmic);
    plot.canvas = element("canvas");
    plot.cursor = element("div", {className: "cursor"});
    plot.axes = element("div", {className: "axes"}, plot.canvas, plot.cursor);
    plot.unitLabel = element("span");
    const heading = element("h2", {}, plot.title + " ", plot.unitLabel);
    plot.unitLabel.style.fontWeight = "normal";
    const caption = element("figcaption", {}, heading, ...plot.lines.map(line => legendEntry(plot, line)));
    parent.append(element("figure", {className: "plot"}, caption, plot.axes));
    const move = event => {
      const box = plot.axes.getBoundingClientRect();
      const fraction = (event.clientX - box.left - kMargin.left) / (box.width - kMargin.left - kMargin.right);
      moveTo(begin + Math.max(0, Math.min(1, fraction)) * span);
    };
    plot.axes.addEventListener("pointerdown", event => {
      if (event.button !== 0) return;
      plot.axes.setPointerCapture(event.pointerId);
      move(event);
    });
    plot.axes.addEventListener("pointermove", event => {
      if (plot.axes.hasPointerCapture(event.pointerId)) move(event);
    });
  }
  return {
    isEmpty: plots.length === 0,
    draw: () => plots.forEach(draw),
    /// The cursor, and beside each name the value next to t.
    showTime(t) {
      for (const plot of plots) {
        const width = plot.axes.clientWidth - kMargin.left - kMargin.right;
        plot.cursor.style.left = kMargin.left + (t - begin) / span * width + "px";
        for (const line of plot.lines) {
          const i = nearest(line.t, t);
          line.label.textContent = i < 0 ? "" : quantity(line.value[i], line.unit);
        }
      }
    },
  };
};
