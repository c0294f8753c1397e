// The map: axes, zoom, layers, labels and the moving duo. The layers themselves stand in the page, in meters.

(() => {
  const byId = (id) => document.getElementById(id);
  const box = byId("map-box");
  const svg = byId("map");
  const pane = byId("map-window");
  const world = byId("world");
  const axes = byId("map-axes");
  const duo = byId("duo");
  const [x0, y0, x1, y1] = data.view;
  const margin = { left: 44, right: 8, top: 8, bottom: 36 };
  const { name: unit, perMeter } = data.axis;
  let frame = { width: 1, height: 1, scale: 1 };
  // Zoom about a center in meters; 1 shows everything.
  const view = { zoom: 1, x: (x0 + x1) / 2, y: (y0 + y1) / 2 };

  const px = (x) => frame.width / 2 + (x - view.x) * frame.scale * view.zoom;
  const py = (y) => frame.height / 2 - (y - view.y) * frame.scale * view.zoom;

  const clampView = () => {
    view.zoom = Math.min(40, Math.max(1, view.zoom));
    const half = { x: frame.width / 2 / frame.scale / view.zoom, y: frame.height / 2 / frame.scale / view.zoom };
    const clamp = (v, low, high) => (low > high ? (low + high) / 2 : Math.min(high, Math.max(low, v)));
    view.x = clamp(view.x, x0 + half.x, x1 - half.x);
    view.y = clamp(view.y, y0 + half.y, y1 - half.y);
  };

  const layOut = (room) => {
    const width = Math.max(200, room);
    const inner = width - margin.left - margin.right;
    const most = Math.max(280, Math.min(720, window.innerHeight * 0.72));
    const scale = Math.min(inner / (x1 - x0), most / (y1 - y0));
    frame = { width: scale * (x1 - x0), height: scale * (y1 - y0), scale };
    const total = { x: frame.width + margin.left + margin.right, y: frame.height + margin.top + margin.bottom };
    svg.setAttribute("viewBox", `0 0 ${total.x} ${total.y}`);
    svg.setAttribute("width", total.x);
    svg.setAttribute("height", total.y);
    for (const [key, value] of Object.entries({ x: margin.left, y: margin.top, width: frame.width, height: frame.height }))
      pane.setAttribute(key, value);
    draw();
  };

  const draw = () => {
    clampView();
    const scale = frame.scale * view.zoom;
    world.setAttribute("transform", `matrix(${scale} 0 0 ${-scale} ${px(0)} ${py(0)})`);
    svg.style.touchAction = view.zoom > 1 ? "none" : "pan-y";
    axes.replaceChildren();
    svgElement("rect", { class: "pane", x: margin.left, y: margin.top, width: frame.width, height: frame.height }, axes);
    const span = { x: frame.width / scale / 2, y: frame.height / scale / 2 };
    const bottom = margin.top + frame.height;
    const ticks = (middle, half, most) => ticksOf((middle - half) * perMeter, (middle + half) * perMeter, most);
    const tx = ticks(view.x, span.x, frame.width / 60);
    for (const value of tx.values) {
      const x = margin.left + px(value / perMeter);
      svgElement("path", { class: "grid", d: `M${x} ${margin.top}V${bottom}` }, axes);
      svgText(formatNumber(value, tx.decimals), { x, y: bottom + 15, class: "tick", "text-anchor": "middle" }, axes);
    }
    const ty = ticks(view.y, span.y, frame.height / 45);
    for (const value of ty.values) {
      const y = margin.top + py(value / perMeter);
      svgElement("path", { class: "grid", d: `M${margin.left} ${y}h${frame.width}` }, axes);
      svgText(formatNumber(value, ty.decimals), { x: margin.left - 6, y: y + 4, class: "tick", "text-anchor": "end" }, axes);
    }
    svgText(`x (${unit})`, { x: margin.left + frame.width / 2, y: bottom + 31, class: "tick", "text-anchor": "middle" }, axes);
    const turn = `translate(12 ${margin.top + frame.height / 2}) rotate(-90)`;
    svgText(`y (${unit})`, { transform: turn, class: "tick", "text-anchor": "middle" }, axes);
    placeLabels();
  };

  // Labels hang on places by offsets in pixels; one that would cover an earlier one waits until there is room.
  const labels = [...document.querySelectorAll("#labels text")].map((text) => {
    const [x, y, dx, dy] = ["x", "y", "dx", "dy"].map((key) => Number(text.dataset[key]));
    return { text, x, y, dx, dy };
  });
  const placeLabels = () => {
    const shown = [];
    for (const { text, x, y, dx, dy } of labels) {
      const at = { x: px(x) + dx, y: py(y) + dy, half: 3.6 * text.textContent.length };
      const covers = shown.some((s) => Math.abs(s.x - at.x) < s.half + at.half && Math.abs(s.y - at.y) < 11);
      text.style.display = covers ? "none" : "";
      if (covers) continue;
      shown.push(at);
      text.setAttribute("x", at.x);
      text.setAttribute("y", at.y + 4);
    }
    for (const robot of Object.values(letters)) placeLetter(robot);
  };
  const letters = {};
  for (const [side, letter] of [["left", "L"], ["right", "R"]]) {
    letters[side] = { text: svgText(letter, { class: "letter" }, pane), x: 0, y: 0 };
  }
  const placeLetter = ({ text, x, y }) => {
    // Beside robots that are too small to hold it.
    const aside = data.radius * frame.scale * view.zoom < 8 ? 10 : 0;
    text.setAttribute("x", px(x) + aside);
    text.setAttribute("y", py(y) + 4 - aside);
  };

  // Zoom and pan: wheel, two fingers, buttons, keys. The point (x, y) of the pane, px, stays where it is.
  const MOST_ZOOM = 40;
  const zoomBy = (factor, x = frame.width / 2, y = frame.height / 2) => {
    const zoom = Math.min(MOST_ZOOM, Math.max(1, view.zoom * factor));
    const shift = (1 / view.zoom - 1 / zoom) / frame.scale;
    view.x += (x - frame.width / 2) * shift;
    view.y -= (y - frame.height / 2) * shift;
    view.zoom = zoom;
    draw();
  };
  const panBy = (dx, dy) => {
    const scale = frame.scale * view.zoom;
    view.x -= dx / scale;
    view.y += dy / scale;
    draw();
  };
  const showAll = () => zoomBy(0);
  byId("zoom-in").addEventListener("click", () => zoomBy(1.5));
  byId("zoom-out").addEventListener("click", () => zoomBy(1 / 1.5));
  byId("zoom-fit").addEventListener("click", showAll);
  svg.addEventListener("dblclick", showAll);
  const inPane = ({ clientX, clientY }) => {
    const box = svg.getBoundingClientRect();
    const ratio = (frame.width + margin.left + margin.right) / box.width;
    return [(clientX - box.left) * ratio - margin.left, (clientY - box.top) * ratio - margin.top];
  };
  svg.addEventListener(
    "wheel",
    (event) => {
      // A map that is shown as a whole, or as near as can be, lets the page scroll.
      const closer = event.deltaY < 0;
      if (closer ? view.zoom >= MOST_ZOOM : view.zoom <= 1) return;
      event.preventDefault();
      const pixels = event.deltaMode === 0 ? event.deltaY : 30 * event.deltaY;
      zoomBy(Math.exp(-0.002 * Math.max(-200, Math.min(200, pixels))), ...inPane(event));
    },
    { passive: false },
  );
  svg.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const pans = { ArrowLeft: [60, 0], ArrowRight: [-60, 0], ArrowUp: [0, 60], ArrowDown: [0, -60] };
    if (event.key === "+" || event.key === "=") zoomBy(1.5);
    else if (event.key === "-") zoomBy(1 / 1.5);
    else if (event.key === "0") showAll();
    else if (pans[event.key] && view.zoom > 1) panBy(...pans[event.key]);
    else return;
    event.preventDefault();
    event.stopPropagation();
  });
  let grip = null;
  svg.addEventListener("pointerdown", (event) => {
    if (view.zoom <= 1 || !event.isPrimary) return;
    grip = { x: event.clientX, y: event.clientY };
    svg.setPointerCapture(event.pointerId);
  });
  svg.addEventListener("pointermove", (event) => {
    if (!grip || !event.isPrimary) return;
    panBy(event.clientX - grip.x, event.clientY - grip.y);
    grip = { x: event.clientX, y: event.clientY };
  });
  for (const end of ["pointerup", "pointercancel"]) svg.addEventListener(end, () => (grip = null));
  let pinch = null;
  const fingers = ([a, b]) => ({
    apart: Math.max(1, Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY)),
    at: inPane({ clientX: (a.clientX + b.clientX) / 2, clientY: (a.clientY + b.clientY) / 2 }),
  });
  svg.addEventListener(
    "touchmove",
    (event) => {
      if (event.touches.length !== 2) {
        // One finger scrolls the page, unless there is a part of the map to move to.
        if (view.zoom > 1) event.preventDefault();
        return;
      }
      event.preventDefault();
      grip = null;
      const now = fingers(event.touches);
      if (pinch) {
        panBy(now.at[0] - pinch.at[0], now.at[1] - pinch.at[1]);
        zoomBy(now.apart / pinch.apart, ...now.at);
      }
      pinch = now;
    },
    { passive: false },
  );
  for (const end of ["touchend", "touchcancel"]) svg.addEventListener(end, () => (pinch = null));

  // What the line between the robots has swept so far in the motion that is shown: finished blocks of steps, then the steps
  // of the block under way.
  const BLOCK = 64;
  const sweptGroup = svgElement("g", { class: "swept" }, duo);
  const ring = ({ left, right }, i) => {
    const corners = [[left, i], [right, i], [right, i + 1], [left, i + 1]].map(([robot, k]) => [robot.x[k], robot.y[k]]);
    const area = corners.reduce((sum, [x, y], k) => {
      const [u, v] = corners[(k + 1) % 4];
      return sum + (x - corners[0][0]) * (v - corners[0][1]) - (u - corners[0][0]) * (y - corners[0][1]);
    }, 0);
    // All one way around, so that overlaps add up instead of cancelling.
    if (area < 0) corners.reverse();
    return `M${corners.map(([x, y]) => `${x.toPrecision(7)} ${y.toPrecision(7)}`).join("L")}Z`;
  };
  const rings = (motion, first, end) => {
    let d = "";
    for (let i = first; i < end; i += 1) d += ring(motion, i);
    return d;
  };
  let swept = null;
  const sweptBy = (motion) => {
    if (swept && swept.motion === motion) return swept;
    sweptGroup.replaceChildren();
    const steps = Math.max(0, motion.times.length - 1);
    const blocks = [];
    for (let first = 0; first < steps; first += BLOCK) {
      blocks.push(svgElement("path", { d: rings(motion, first, Math.min(steps, first + BLOCK)) }, sweptGroup));
    }
    swept = { motion, blocks, partial: svgElement("path", {}, sweptGroup) };
    return swept;
  };
  const showSwept = (motion, at) => {
    const { blocks, partial } = sweptBy(motion);
    const whole = Math.floor(at.index / BLOCK);
    blocks.forEach((block, k) => (block.style.display = k < whole ? "" : "none"));
    partial.setAttribute("d", rings(motion, whole * BLOCK, at.index));
  };

  // The duo itself.
  const rung = svgElement("path", { class: "rung" }, duo);
  const net = svgElement("path", { class: "net" }, duo);
  const movers = svgElement("g", {}, duo);
  const robot = (side) => {
    const group = svgElement("g", { class: `robot moving ${side}` }, duo);
    for (const [cx, cy, r] of data.body) svgElement("circle", { class: "body", cx, cy, r }, group);
    svgElement("path", { class: "nose", d: `M${0.55 * data.front} 0H${data.front}` }, group);
    svgElement("circle", { class: "hitch", cx: -data.hitch, r: 0.12 * data.radius }, group);
    return group;
  };
  const robots = { left: robot("left"), right: robot("right") };
  const pin = svgElement("circle", { class: "pin", r: 0, "aria-hidden": "true" }, world);
  const lying = [...document.querySelectorAll("#layer-objects > .object")];
  const shapes = data.objects.map((object) => {
    const group = svgElement("g", {}, movers);
    const look = object.leave ? "object leave" : "object";
    if (object.radius) svgElement("circle", { class: look, r: object.radius }, group);
    else {
      const [w, d] = object.size;
      svgElement("path", { class: look, d: `M${-w / 2} ${-d / 2}h${w}v${d}h${-w}Z` }, group);
    }
    return group;
  });

  // Layers; labels and what moves go with what they belong to.
  const movingParts = { "layer-sweep": sweptGroup, "layer-objects": movers };
  for (const check of document.querySelectorAll("#layers input")) {
    const parts = [byId(check.dataset.layer), byId(check.dataset.layer.replace("layer", "labels")), movingParts[check.dataset.layer]].filter(Boolean);
    const apply = () => parts.forEach((part) => (part.style.visibility = check.checked ? "" : "hidden"));
    check.addEventListener("change", apply);
    apply();
  }

  const degrees = (radians) => (radians * 180) / Math.PI;
  const place = (group, poses, at) => {
    const [x, y, angle] = [blend(poses.x, at), blend(poses.y, at), blend(poses.angle, at)];
    group.setAttribute("transform", `translate(${x} ${y}) rotate(${degrees(angle)})`);
    return { x, y, angle };
  };
  const hitchOf = (pose) =>
    `${pose.x - data.hitch * Math.cos(pose.angle)} ${pose.y - data.hitch * Math.sin(pose.angle)}`;

  player.listen(({ time, motion }) => {
    if (!motion.times.length) return;
    const at = locate(motion.times, time);
    const left = place(robots.left, motion.left, at);
    const right = place(robots.right, motion.right, at);
    rung.setAttribute("d", `M${left.x} ${left.y}L${right.x} ${right.y}`);
    rung.classList.toggle("faint", motion.net.length > 0);
    const nodes = motion.net.map((node) => `${blend(node.x, at)} ${blend(node.y, at)}`);
    net.setAttribute("d", nodes.length ? `M${nodes.join("L")}` : `M${hitchOf(left)}L${hitchOf(right)}`);
    net.classList.toggle("faint", nodes.length === 0);
    showSwept(motion, at);
    for (const [side, pose] of Object.entries({ left, right })) placeLetter(Object.assign(letters[side], { x: pose.x, y: pose.y }));
    const moving = motion.objects !== null;
    movers.style.display = moving ? "" : "none";
    if (moving) motion.objects.forEach((poses, k) => shapes[k] && place(shapes[k], poses, at));
    data.objects.forEach((object, k) => {
      if (!lying[k]) return;
      lying[k].classList.toggle("ghost", moving);
      lying[k].classList.toggle("taken", !moving && object.swept !== null && object.swept <= time);
    });
  });

  for (const button of document.querySelectorAll("button.goto")) {
    button.addEventListener("click", () => {
      player.setPlaying(false);
      if (button.dataset.motion) player.setMotion(button.dataset.motion);
      player.setTime(Number(button.dataset.time));
      if (!button.dataset.place) return;
      const [x, y] = button.dataset.place.split(" ").map(Number);
      pin.setAttribute("cx", x);
      pin.setAttribute("cy", y);
      pin.setAttribute("r", 0.02 * Math.max(x1 - x0, y1 - y0));
      view.x = x;
      view.y = y;
      draw();
      byId("map-card").scrollIntoView({ block: "nearest" });
    });
  }

  const fill = () => layOut(box.clientWidth);
  onWidth(box, fill);
  fill();
  onPrint(() => layOut(PAPER - 26), fill);
})();
