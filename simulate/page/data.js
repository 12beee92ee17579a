// SPDX-License-Identifier: GPL-3.0-or-later
// Reads what page_data.h describes, and writes numbers for people.
"use strict";

const decodeArray = ({type, base64}) => {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return new {Float32: Float32Array, Float64: Float64Array, Uint16: Uint16Array, Uint32: Uint32Array}[type](bytes.buffer);
};

/// Where the items of each of `counts` begin in the list of all, and the end of the last.
const offsetsOf = counts => {
  const offsets = new Uint32Array(counts.length + 1);
  counts.forEach((count, i) => { offsets[i + 1] = offsets[i] + count; });
  return offsets;
};

const decodeRecording = data => {
  const frames = {};
  for (const [name, array] of Object.entries(data.frames)) frames[name] = decodeArray(array);
  frames.firstRun = offsetsOf(frames.element_runs);
  frames.firstElement = offsetsOf(frames.run_length);
  frames.firstContact = offsetsOf(frames.contacts);
  const times = data.times.map(decodeArray);
  return {
    title: data.title,
    surfaces: data.surfaces.map(s => ({...s, vertices: decodeArray(s.vertices), faces: decodeArray(s.faces)})),
    pairings: data.pairings,
    frames,
    series: data.series.map(s => ({...s, t: times[s.times], value: decodeArray(s.value)})),
  };
};

/// Calls visit(surface, face, pressure) for each element of a frame.
const forEachElement = (recording, frame, visit) => {
  const {firstRun, firstElement, run_master, face, pressure} = recording.frames;
  for (let run = firstRun[frame]; run < firstRun[frame + 1]; ++run) {
    const surface = recording.pairings[run_master[run] >> 1].surfaces[run_master[run] & 1];
    for (let i = firstElement[run]; i < firstElement[run + 1]; ++i) visit(surface, face[i], pressure[i]);
  }
};

/// The index in an ascending list of the entry next to x.
const nearest = (list, x) => {
  let low = 0, high = list.length - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (list[middle] <= x) low = middle; else high = middle;
  }
  return high < 0 ? -1 : x - list[low] <= list[high] - x ? low : high;
};

const kPrefixes = {"-4": "p", "-3": "n", "-2": "\u00b5", "-1": "m", 0: "", 1: "k", 2: "M", 3: "G", 4: "T"};
/// The power of 1000 whose prefix suits a number of this unit.
const prefixPower = (size, unit) => {
  if (!/^(Pa|N|J|W|m|s|N m|N s|Hz)$/.test(unit) || !(size > 0) || !isFinite(size)) return 0;
  return Math.max(-4, Math.min(unit === "m" || unit === "s" ? 0 : 4, Math.floor(Math.log10(size * 1.0000001) / 3)));
};
const withMinus = text => text.replace(/-/g, "\u2212");
/// Three digits, without a tail of zeros.
const threeDigits = x =>
  withMinus(x === 0 ? "0" : Math.abs(x) >= 1e5 || Math.abs(x) < 1e-3 ? x.toExponential(2) : String(+x.toPrecision(3)));
const quantity = (x, unit) => {
  if (!isFinite(x)) return "\u2013";
  const power = prefixPower(Math.abs(x), unit);
  const symbol = kPrefixes[power] + unit;
  return threeDigits(x / 1000 ** power) + (symbol ? "\u00a0" + symbol : "");
};

/// Round numbers between low and high, about `count` of them.
const roundTicks = (low, high, count) => {
  const rough = (high - low) / count;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].find(m => m * power >= rough * 0.999) * power;
  const ticks = [];
  for (let i = Math.ceil(low / step - 1e-6); i * step <= high + 1e-6 * step; ++i) ticks.push(+(i * step).toPrecision(12));
  return ticks;
};

const element = (name, properties = {}, ...children) => {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
};
