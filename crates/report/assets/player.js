// The clock: one time for map, slider and curves.

const player = (() => {
  const byId = (id) => document.getElementById(id);
  const slider = byId("time");
  const readout = byId("readout");
  const play = byId("play");
  const speed = byId("speed");
  const source = byId("source");
  const listeners = [];
  const state = { time: 0, playing: false, motion: motions[0] };
  let stamp = null;
  slider.max = duration;

  const show = () => {
    slider.value = state.time;
    const steps = motions[0].times.length - 1;
    const step = locate(motions[0].times, state.time).index;
    const words = `${formatNumber(state.time, 2)} s of ${formatNumber(duration, 1)} s`;
    readout.textContent = `${words} \u00b7 step ${step} of ${Math.max(0, steps)}`;
    slider.setAttribute("aria-valuetext", readout.textContent);
    for (const listener of listeners) listener(state);
  };
  const setTime = (time) => {
    state.time = Math.min(duration, Math.max(0, Number.isFinite(time) ? time : 0));
    show();
  };
  const tick = (now) => {
    if (!state.playing) return;
    if (stamp !== null) setTime(state.time + ((now - stamp) / 1000) * Number(speed.value));
    stamp = now;
    if (state.time >= duration) setPlaying(false);
    else requestAnimationFrame(tick);
  };
  const setPlaying = (playing) => {
    if (playing && state.time >= duration) setTime(0);
    state.playing = playing && duration > 0;
    play.querySelector("path").setAttribute("d", state.playing ? "M4 2h3v12h-3zM9 2h3v12h-3z" : "M4 2l9 6-9 6z");
    play.setAttribute("aria-pressed", state.playing);
    stamp = null;
    if (state.playing) requestAnimationFrame(tick);
  };
  // To the waypoint or frame so many before or after the present one.
  const step = (by) => {
    setPlaying(false);
    const { times } = state.motion;
    const at = locate(times, state.time);
    const between = at.share > 1e-6 && by < 0 ? 1 : 0;
    const index = Math.min(times.length - 1, Math.max(0, at.index + by + between));
    setTime(times[index]);
  };
  const setMotion = (name) => {
    state.motion = motions.find((m) => m.name === name) || motions[0];
    if (source) source.value = state.motion.name;
    show();
  };

  slider.addEventListener("input", () => {
    setPlaying(false);
    setTime(Number(slider.value));
  });
  play.addEventListener("click", () => setPlaying(!state.playing));
  byId("back").addEventListener("click", () => step(-1));
  byId("forward").addEventListener("click", () => step(1));
  byId("first").addEventListener("click", () => setTime(0));
  byId("last").addEventListener("click", () => setTime(duration));
  if (source) source.addEventListener("change", () => setMotion(source.value));

  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const on = event.target;
    // A select, a check box and a button keep their own keys; the slider takes ours.
    const owns = on.closest && on.closest("select, input:not([type=range]), textarea");
    const presses = on.closest && on.closest("button, a, summary");
    const many = event.shiftKey ? 10 : 1;
    if (event.key === " " && !owns && !presses) setPlaying(!state.playing);
    else if (event.key === "ArrowLeft" && !owns) step(-many);
    else if (event.key === "ArrowRight" && !owns) step(many);
    else if (event.key === "Home" && on === slider) setTime(0);
    else if (event.key === "End" && on === slider) setTime(duration);
    else return;
    event.preventDefault();
  });

  // #t=12.5&show=rehearsal&play=1
  const readFragment = () => {
    const fragment = new URLSearchParams(location.hash.slice(1));
    if (fragment.has("show")) setMotion(fragment.get("show"));
    if (fragment.has("t")) setTime(Number(fragment.get("t")));
    if (fragment.has("play")) setPlaying(true);
  };
  return {
    setTime,
    setPlaying,
    setMotion,
    listen: (listener) => listeners.push(listener),
    start: () => {
      window.addEventListener("hashchange", readFragment);
      // On paper the map shows how it ended.
      let before = null;
      onPrint(
        () => {
          before = state.time;
          setTime(duration);
        },
        () => setTime(before),
      );
      // The physics tells more than the plan, where there is any.
      setMotion(motions[motions.length - 1].name);
      readFragment();
    },
  };
})();
