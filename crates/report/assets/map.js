// The map: axes, zoom, layers and the moving duo. The layers themselves stand in the page, in meters.

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
  let frame = { width: 1, height: 1, scale: 1 };
  // Zoom about a center in meters; 1 shows everything.
  const view = { zoom: 1, x: (x0 + x1) / 2, y: (y0 + y1) / 2 };

  const clampView = () => {
    view.zoom = Math.min(40, Math.max(1, view.zoom));
    const half = { x: frame.width / 2 / frame.scale / view.zoom, y: frame.height / 2 / frame.scale / view.zoom };
    const clamp = (v, low, high) => (low > high ? (low + high) / 2 : Math.min(high, Math.max(low, v)));
    view.x = clamp(view.x, x0 + half.x, x1 - half.x);
    view.y = clamp(view.y, y0 + half.y, y1 - half.y);
  };

  const layOut = () => {
    const width = Math.max(200, box.clientWidth);
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
    const px = (x) => frame.width / 2 + (x - view.x) * scale;
    const py = (y) => frame.height / 2 - (y - view.y) * scale;
    world.setAttribute("transform", `matrix(${scale} 0 0 ${-scale} ${px(0)} ${py(0)})`);
    axes.replaceChildren();
    svgElement("rect", { class: "pane", x: margin.left, y: margin.top, width: frame.width, height: frame.height }, axes);
    const span = { x: frame.width / scale / 2, y: frame.height / scale / 2 };
    const bottom = margin.top + frame.height;
    const tx = ticksOf(view.x - span.x, view.x + span.x, frame.width / 60);
    for (const value of tx.values) {
      const x = margin.left + px(value);
      svgElement("path", { class: "grid", d: `M${x} ${margin.top}V${bottom}` }, axes);
      svgText(formatNumber(value, tx.decimals), { x, y: bottom + 15, class: "tick", "text-anchor": "middle" }, axes);
    }
    const ty = ticksOf(view.y - span.y, view.y + span.y, frame.height / 45);
    for (const value of ty.values) {
      const y = margin.top + py(value);
      svgElement("path", { class: "grid", d: `M${margin.left} ${y}h${frame.width}` }, axes);
      svgText(formatNumber(value, ty.decimals), { x: margin.left - 6, y: y + 4, class: "tick", "text-anchor": "end" }, axes);
    }
    svgText("x (m)", { x: margin.left + frame.width / 2, y: bottom + 31, class: "tick", "text-anchor": "middle" }, axes);
    const turn = `translate(12 ${margin.top + frame.height / 2}) rotate(-90)`;
    svgText("y (m)", { transform: turn, class: "tick", "text-anchor": "middle" }, axes);
  };

  // Zoom and pan.
  const zoomBy = (factor) => {
    view.zoom *= factor;
    draw();
  };
  byId("zoom-in").addEventListener("click", () => zoomBy(1.5));
  byId("zoom-out").addEventListener("click", () => zoomBy(1 / 1.5));
  byId("zoom-fit").addEventListener("click", () => zoomBy(0));
  let grip = null;
  pane.addEventListener("pointerdown", (event) => {
    if (view.zoom <= 1) return;
    grip = { x: event.clientX, y: event.clientY };
    pane.setPointerCapture(event.pointerId);
  });
  pane.addEventListener("pointermove", (event) => {
    if (!grip) return;
    const scale = frame.scale * view.zoom;
    view.x -= (event.clientX - grip.x) / scale;
    view.y += (event.clientY - grip.y) / scale;
    grip = { x: event.clientX, y: event.clientY };
    draw();
  });
  for (const end of ["pointerup", "pointercancel"]) pane.addEventListener(end, () => (grip = null));

  // What the duo has swept so far: finished blocks of steps, then the steps of the block under way.
  const BLOCK = 64;
  const sweptGroup = svgElement("g", { class: "swept" }, duo);
  const plan = motions[0];
  const corner = (robot, i) => `${robot.x[i].toFixed(3)} ${robot.y[i].toFixed(3)}`;
  const quad = (i) => {
    const ring = [[plan.left, i], [plan.right, i], [plan.right, i + 1], [plan.left, i + 1]];
    return `M${ring.map(([robot, k]) => corner(robot, k)).join("L")}Z`;
  };
  const steps = Math.max(0, plan.times.length - 1);
  const blocks = [];
  for (let first = 0; first < steps; first += BLOCK) {
    let d = "";
    for (let i = first; i < Math.min(steps, first + BLOCK); i += 1) d += quad(i);
    blocks.push(svgElement("path", { d }, sweptGroup));
  }
  const partial = svgElement("path", {}, sweptGroup);
  const showSwept = (time) => {
    const done = locate(plan.times, time).index;
    const whole = Math.floor(done / BLOCK);
    blocks.forEach((block, k) => (block.style.display = k < whole ? "" : "none"));
    let d = "";
    for (let i = whole * BLOCK; i < done; i += 1) d += quad(i);
    partial.setAttribute("d", d);
  };

  // The duo itself.
  const rung = svgElement("path", { class: "rung" }, duo);
  const net = svgElement("path", { class: "net" }, duo);
  const movers = svgElement("g", {}, duo);
  const robot = (side) => {
    const group = svgElement("g", { class: `robot moving ${side}` }, duo);
    svgElement("circle", { class: "body", r: data.radius }, group);
    svgElement("path", { class: "nose", d: `M0 0H${data.radius}` }, group);
    svgElement("circle", { class: "hitch", cx: -data.hitch, r: 0.12 * data.radius }, group);
    return group;
  };
  const robots = { left: robot("left"), right: robot("right") };
  const pin = svgElement("circle", { class: "pin", r: 0, "aria-hidden": "true" }, world);
  const lying = [...document.querySelectorAll("#layer-objects > .object")];
  const shapes = data.objects.map((object) => {
    const group = svgElement("g", {}, movers);
    if (object.radius) svgElement("circle", { class: "object", r: object.radius }, group);
    else {
      const [w, d] = object.size;
      svgElement("path", { class: "object", d: `M${-w / 2} ${-d / 2}h${w}v${d}h${-w}Z` }, group);
    }
    return group;
  });

  // Layers; what moves goes with what it belongs to.
  const movingParts = { "layer-sweep": sweptGroup, "layer-objects": movers };
  for (const check of document.querySelectorAll("#layers input")) {
    const parts = [byId(check.dataset.layer), movingParts[check.dataset.layer]].filter(Boolean);
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
    showSwept(time);
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

  onWidth(box, layOut);
  layOut();
})();
