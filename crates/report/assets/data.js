"use strict";
// The page's data, unpacked. Lengths are packed in `lengthUnit` (m), angles in mrad, times in 0.1 ms, each as differences.

const data = JSON.parse(document.getElementById("data").textContent);

const unpack = (packed, unit) => {
  let sum = 0;
  return Float64Array.from(packed, (difference) => (sum += difference) * unit);
};
const unpackPoses = ([x, y, angle]) => ({
  x: unpack(x, data.lengthUnit),
  y: unpack(y, data.lengthUnit),
  angle: angle ? unpack(angle, 1e-3) : null,
});

// What can move on the map: the plan, the rehearsal, a run.
const motions = data.motions.map((m) => ({
  name: m.name,
  times: unpack(m.t, 1e-4),
  left: unpackPoses(m.left),
  right: unpackPoses(m.right),
  net: (m.net || []).map(unpackPoses),
  objects: m.objects ? m.objects.map(unpackPoses) : null,
}));

const panels = data.panels.map((p) => ({
  ...p,
  times: unpack(data.times[p.t], 1e-4),
  lines: p.lines.map((line) => ({
    ...line,
    values: line.v.map((v) => (v === null ? NaN : v * p.unit)),
  })),
}));

const duration = Math.max(
  0,
  ...motions.map((m) => m.times[m.times.length - 1] || 0),
  ...panels.map((p) => p.times[p.times.length - 1] || 0),
);

// The last index whose time is not after t, and how far t is on the way to the next one.
const locate = (times, t) => {
  let low = 0;
  let high = times.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (times[middle] <= t + 1e-9) low = middle;
    else high = middle - 1;
  }
  const next = Math.min(low + 1, times.length - 1);
  const span = times[next] - times[low];
  const share = span > 0 ? (t - times[low]) / span : 0;
  return { index: low, next, share: Math.min(1, Math.max(0, share)) };
};

const blend = (list, at) => list[at.index] + (list[at.next] - list[at.index]) * at.share;

const formatNumber = (value, decimals) =>
  Number.isFinite(value) ? value.toFixed(decimals).replace("-", "\u2212").replace(/^\u2212(0(\.0*)?)$/, "$1") : "\u2013";

// Round steps: 1, 2 or 5 times a power of ten, at most `most` of them in the span.
const ticksOf = (min, max, most) => {
  const least = (max - min) / Math.max(1, most);
  if (!(least > 0) || !Number.isFinite(least)) return { values: [], decimals: 0 };
  const power = 10 ** Math.floor(Math.log10(least));
  const step = [1, 2, 5, 10].map((k) => k * power).find((s) => s >= least * (1 - 1e-9));
  const values = [];
  for (let k = Math.ceil(min / step - 1e-9); k * step <= max + 1e-9 * step; k += 1) values.push(k * step);
  return { values, decimals: Math.max(0, -Math.floor(Math.log10(step) + 1e-9)) };
};

// Calls back when an element's width has changed; heights follow from it and must not call again.
const onWidth = (element, callback) => {
  let width = -1;
  new ResizeObserver(() => {
    if (element.clientWidth === width) return;
    width = element.clientWidth;
    callback();
  }).observe(element);
};

// Width of a page of paper without its margins, px: charts are drawn anew for it, so that their text keeps its size.
const PAPER = 670;
const onPrint = (before, after) => {
  window.addEventListener("beforeprint", before);
  window.addEventListener("afterprint", after);
};

const svgElement = (name, attributes, parent) => {
  const element = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes || {})) element.setAttribute(key, value);
  if (parent) parent.appendChild(element);
  return element;
};
const svgText = (text, attributes, parent) => {
  const element = svgElement("text", attributes, parent);
  element.textContent = text;
  return element;
};
