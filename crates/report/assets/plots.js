// Curves over time, one above or beside the other, on one time axis, with the player's time as a common cursor.

(() => {
  const host = document.getElementById("plots");
  const margin = { left: 60, right: 82, top: 6, bottom: 32 };
  const height = 176;
  const plots = [];
  let hover = null;

  const rangeOf = (panel) => {
    let low = Infinity;
    let high = -Infinity;
    for (const line of panel.lines) for (const v of line.values) if (Number.isFinite(v)) {
      low = Math.min(low, v);
      high = Math.max(high, v);
    }
    if (low > high) [low, high] = [0, 1];
    const greatest = Math.max(Math.abs(low), Math.abs(high));
    // Bounds belong into the picture, unless they are so far off that the curve would become a straight line.
    const reach = 4 * Math.max(high - low, Math.abs(high), Math.abs(low), 1e-9);
    const shown = panel.limits.filter((l) => l.value >= low - reach && l.value <= high + reach);
    for (const limit of shown) {
      low = Math.min(low, limit.value);
      high = Math.max(high, limit.value);
    }
    const pad = high > low ? 0.07 * (high - low) : Math.max(1e-3, 0.1 * Math.abs(high));
    return { low: low - pad, high: high + pad, greatest, shown, hidden: panel.limits.filter((l) => !shown.includes(l)) };
  };

  const valueAt = (panel, line, time) => {
    if (!panel.times.length || time > panel.times[panel.times.length - 1] + 1e-6) return NaN;
    const at = locate(panel.times, time);
    if (panel.steps) return line.values[Math.min(at.index, line.values.length - 1)];
    return blend(line.values, at);
  };

  const pathOf = (panel, line, px, py) => {
    let d = "";
    let pen = false;
    line.values.forEach((v, i) => {
      if (!Number.isFinite(v)) {
        pen = false;
        return;
      }
      d += `${pen ? "L" : "M"}${px(panel.times[i]).toFixed(1)} ${py(v).toFixed(1)}`;
      if (panel.steps && i + 1 < panel.times.length) d += `H${px(panel.times[i + 1]).toFixed(1)}`;
      pen = true;
    });
    return d;
  };

  // Moves labels apart until none covers another, keeping their order.
  const spread = (labels, gap, low, high) => {
    labels.sort((a, b) => a.y - b.y);
    labels.forEach((label, i) => {
      if (i > 0) label.y = Math.max(label.y, labels[i - 1].y + gap);
    });
    for (let i = labels.length - 1; i >= 0; i -= 1) {
      const most = i + 1 < labels.length ? labels[i + 1].y - gap : high;
      labels[i].y = Math.max(low, Math.min(labels[i].y, most));
    }
  };

  // Several curves that are neither robot's nor the net's are told apart by a class of their own each.
  const classOf = (panel, line) =>
    line.role === "other" ? `other other${panel.lines.filter((l) => l.role === "other").indexOf(line) % 4}` : line.role;

  // Robots' curves are told apart by letters and dashes as well as by color.
  const letterOf = (line) => ({ left: "L ", right: "R " })[line.role] || "";

  const build = (panel) => {
    const figure = document.createElement("figure");
    figure.className = "card plot";
    const caption = document.createElement("figcaption");
    const title = document.createElement("h3");
    title.textContent = panel.measure ? `${panel.title} (${panel.measure})` : panel.title;
    caption.appendChild(title);
    const readouts = panel.lines.map((line) => {
      const entry = document.createElement("span");
      entry.className = `entry ${classOf(panel, line)}`;
      const key = document.createElement("i");
      const name = document.createElement("span");
      name.textContent = letterOf(line) + line.label;
      const value = document.createElement("b");
      entry.append(key, name, value);
      caption.appendChild(entry);
      return value;
    });
    const range = rangeOf(panel);
    for (const limit of range.hidden) {
      const note = document.createElement("span");
      note.className = "entry";
      const side = limit.value > range.high ? "above" : "below";
      const value = String(Number(limit.value.toPrecision(3))).replace("-", "\u2212");
      note.textContent = `${limit.label} ${value} is ${side} the plot`;
      caption.appendChild(note);
    }
    figure.appendChild(caption);
    const svg = svgElement("svg", { role: "img", height });
    figure.appendChild(svg);
    host.appendChild(figure);
    const decimals = Math.max(0, Math.min(5, 2 - Math.floor(Math.log10(Math.max(1e-9, range.greatest)))));
    const extremes = panel.lines.map((line) => {
      const finite = line.values.filter(Number.isFinite);
      const [low, high] = finite.reduce(([l, h], v) => [Math.min(l, v), Math.max(h, v)], [Infinity, -Infinity]);
      return `${line.label} from ${formatNumber(low, decimals)} to ${formatNumber(high, decimals)}`;
    });
    svg.setAttribute("aria-label", `${title.textContent} over time: ${extremes.join(", ")}`);
    const plot = { panel, svg, range, readouts, decimals, cursor: null, dots: [] };
    plots.push(plot);

    const timeAt = (event) => {
      const inside = event.clientX - svg.getBoundingClientRect().left - margin.left;
      return Math.min(duration, Math.max(0, (inside / plot.width) * duration));
    };
    svg.addEventListener("pointermove", (event) => {
      hover = timeAt(event);
      if (event.buttons & 1) player.setTime(hover);
      else refresh();
    });
    svg.addEventListener("pointerdown", (event) => {
      player.setPlaying(false);
      player.setTime(timeAt(event));
    });
    svg.addEventListener("pointerleave", () => {
      hover = null;
      refresh();
    });
    return plot;
  };

  const layOut = (plot, room) => {
    const { svg, panel, range } = plot;
    const width = Math.max(180, room);
    plot.width = width - margin.left - margin.right;
    svg.setAttribute("width", width);
    svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
    const bottom = height - margin.bottom;
    const right = margin.left + plot.width;
    const px = (t) => margin.left + (duration > 0 ? t / duration : 0) * plot.width;
    const py = (v) => bottom - ((v - range.low) / (range.high - range.low)) * (bottom - margin.top);
    plot.px = px;
    plot.py = py;
    svg.replaceChildren();
    svgElement("rect", { class: "pane", x: margin.left, y: margin.top, width: plot.width, height: bottom - margin.top }, svg);
    const tx = ticksOf(0, duration, plot.width / 44);
    for (const value of tx.values) {
      svgElement("path", { class: "grid", d: `M${px(value)} ${margin.top}V${bottom}` }, svg);
      svgText(formatNumber(value, tx.decimals), { x: px(value), y: bottom + 14, class: "tick", "text-anchor": "middle" }, svg);
    }
    svgText("time (s)", { x: margin.left + plot.width / 2, y: bottom + 28, class: "tick", "text-anchor": "middle" }, svg);
    const ty = ticksOf(range.low, range.high, (bottom - margin.top) / 30);
    for (const value of ty.values) {
      svgElement("path", { class: "grid", d: `M${margin.left} ${py(value)}h${plot.width}` }, svg);
      svgText(formatNumber(value, ty.decimals), { x: margin.left - 6, y: py(value) + 4, class: "tick", "text-anchor": "end" }, svg);
    }
    const labels = range.shown.map((limit) => ({ ...limit, y: py(limit.value) }));
    spread(labels, 13, margin.top + 5, bottom);
    for (const label of labels) {
      svgElement("path", { class: "limit", d: `M${margin.left} ${py(label.value)}H${right}L${right + 5} ${label.y}` }, svg);
      const words = `${label.label} ${Number(label.value.toPrecision(3))}`.replace("-", "\u2212");
      svgText(words, { x: right + 8, y: label.y + 4, class: "tick" }, svg);
    }
    for (const line of panel.lines) svgElement("path", { class: `curve ${classOf(panel, line)}`, d: pathOf(panel, line, px, py) }, svg);
    plot.cursor = svgElement("path", { class: "cursor" }, svg);
    // The right robot's mark is a diamond.
    const mark = (line) => (line.role === "right" ? "M0-5L5 0L0 5L-5 0Z" : "M-3.5 0a3.5 3.5 0 1 0 7 0a3.5 3.5 0 1 0-7 0Z");
    plot.dots = panel.lines.map((line) => svgElement("path", { class: `dot ${classOf(panel, line)}`, d: mark(line) }, svg));
  };

  let now = 0;
  const refresh = () => {
    const time = hover === null ? now : hover;
    for (const plot of plots) {
      if (!plot.cursor) continue;
      const x = plot.px(time).toFixed(1);
      plot.cursor.setAttribute("d", `M${x} ${margin.top}V${height - margin.bottom}`);
      plot.panel.lines.forEach((line, k) => {
        const value = valueAt(plot.panel, line, time);
        plot.readouts[k].textContent = formatNumber(value, plot.decimals);
        const dot = plot.dots[k];
        dot.style.display = Number.isFinite(value) ? "" : "none";
        if (Number.isFinite(value)) dot.setAttribute("transform", `translate(${x} ${plot.py(value)})`);
      });
    }
  };

  panels.forEach(build);
  const layOutAll = (room) => {
    for (const plot of plots) layOut(plot, room || plot.svg.parentElement.clientWidth - 24);
    refresh();
  };
  onWidth(host, () => layOutAll());
  layOutAll();
  onPrint(() => layOutAll(PAPER / 2 - 20), () => layOutAll());
  player.listen(({ time }) => {
    now = time;
    refresh();
  });
})();

player.start();
