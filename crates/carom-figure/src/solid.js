// Plays a body in space in the page that holds its canvas; `view` is from where it is seen, and stays with who gives it.
function solidPlayer(page, numbers, view) {
  "use strict";
  const el = (id) => page.querySelector(`#${id}`);
  const root = el("player");
  const canvas = el("solid");
  if (!root || !canvas) return;
  const { samples, stages, strikes } = numbers;
  if (samples.length === 0) return;
  const first = samples[0][0];
  const last = samples[samples.length - 1][0];
  const span = Math.max(last - first, 1e-12);
  const [play, scrub, clock, label, speed, named] = ["play", "scrub", "clock", "stage", "speed", "names"].map(el);
  const charts = [...page.querySelectorAll("svg.tilt")];
  const rows = [...page.querySelectorAll("tr[data-t]")];
  const events = [...new Set([first, ...stages.map((s) => s[2]), ...strikes.map((s) => s[0]), last])].sort((a, b) => a - b);
  let now = first;
  let running = false;
  let frame = 0;
  let before = null;

  function indexAt(t) {
    let low = 0;
    let high = samples.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (samples[middle][0] <= t) low = middle;
      else high = middle - 1;
    }
    return low;
  }

  function poseAt(t) {
    const a = samples[indexAt(t)];
    const b = samples[Math.min(indexAt(t) + 1, samples.length - 1)];
    const dt = b[0] - a[0];
    const u = dt > 0 ? Math.min(Math.max((t - a[0]) / dt, 0), 1) : 0;
    const dot = a[4] * b[4] + a[5] * b[5] + a[6] * b[6] + a[7] * b[7];
    const near = dot < 0 ? -1 : 1;
    const q = [4, 5, 6, 7].map((k) => a[k] + u * (near * b[k] - a[k]));
    const size = Math.hypot(...q);
    return { at: [1, 2, 3].map((k) => a[k] + u * (b[k] - a[k])), q: q.map((x) => x / size), held: a[8], also: a[9] };
  }

  const drawAt = solidView(root, canvas, numbers, poseAt, named, view ?? {});

  function stageAt(t) {
    let found = -1;
    stages.forEach((s, i) => {
      if (s[2] <= t + 1e-12) found = i;
    });
    return found;
  }

  function show(t) {
    now = Math.min(Math.max(t, first), last);
    drawAt(now);
    if (!scrub) return;
    const stage = stages[stageAt(now)];
    const name = stage ? `${stage[0]}${stage[1] ? " on " + stage[1] : ""}` : "";
    scrub.value = String(Math.round(((now - first) / span) * 1000));
    clock.textContent = `${now.toFixed(5)} s`;
    if (label.textContent !== name) label.textContent = name;
    scrub.setAttribute("aria-valuetext", `${now.toFixed(5)} seconds, ${name}`);
    let reached = -1;
    rows.forEach((row, i) => {
      if (Number(row.dataset.t) <= now + 1e-12) reached = i;
    });
    rows.forEach((row, i) => row.classList.toggle("now", i === reached));
    for (const chart of charts) {
      const d = chart.dataset;
      const share = (now - Number(d.x0)) / (Number(d.x1) - Number(d.x0));
      const x = (Number(d.left) + share * (Number(d.right) - Number(d.left))).toFixed(2);
      const line = chart.querySelector("line.now");
      line.setAttribute("visibility", "visible");
      line.setAttribute("x1", x);
      line.setAttribute("x2", x);
    }
  }

  function tick(time) {
    if (!running) return;
    if (before !== null) show(now + ((time - before) / 1000) * Number(speed.value));
    before = time;
    if (now >= last) pause();
    else frame = requestAnimationFrame(tick);
  }

  function start() {
    if (now >= last) show(first);
    running = true;
    before = null;
    play.textContent = "Pause";
    frame = requestAnimationFrame(tick);
  }

  function pause() {
    running = false;
    cancelAnimationFrame(frame);
    if (play) play.textContent = "Play";
  }

  function goTo(t) {
    pause();
    show(t);
  }

  if (!scrub) {
    drawAt(first);
    return;
  }

  const closest = 1e-9 * (1 + Math.abs(last));
  const nextEvent = () => goTo(events.find((t) => t > now + closest) ?? last);
  const lastEvent = () => goTo(events.filter((t) => t < now - closest).pop() ?? first);
  const step = (n) => goTo(now + (n * Number(speed.value)) / 60);
  play.addEventListener("click", () => (running ? pause() : start()));
  el("next").addEventListener("click", nextEvent);
  el("back").addEventListener("click", lastEvent);
  named.addEventListener("change", () => drawAt(now));
  scrub.addEventListener("input", () => goTo(first + (Number(scrub.value) / 1000) * span));
  root.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.target === speed) return;
    const actions = {
      ".": nextEvent,
      ",": lastEvent,
      ArrowRight: () => step(event.shiftKey ? 10 : 1),
      ArrowLeft: () => step(event.shiftKey ? -10 : -1),
      Home: () => goTo(first),
      End: () => goTo(last),
    };
    const inButton = event.target instanceof HTMLButtonElement || event.target === named;
    if (!inButton) actions[" "] = () => (running ? pause() : start());
    const action = actions[event.key];
    if (!action) return;
    event.preventDefault();
    action();
  });
  for (const row of rows) row.addEventListener("click", () => goTo(Number(row.dataset.t)));
  for (const chart of charts) {
    chart.addEventListener("click", (event) => {
      const box = chart.getBoundingClientRect();
      const d = chart.dataset;
      const x = ((event.clientX - box.left) / box.width) * chart.viewBox.baseVal.width;
      const share = (x - Number(d.left)) / (Number(d.right) - Number(d.left));
      if (share < 0 || share > 1) return;
      goTo(Number(d.x0) + share * (Number(d.x1) - Number(d.x0)));
    });
  }
  const share = (t) => `${(100 * (t - first)) / span}%`;
  for (const s of stages) {
    const bar = document.createElement("span");
    bar.className = `key ${s[0]}`;
    bar.style.left = share(s[2]);
    bar.style.width = `${(100 * (s[3] - s[2])) / span}%`;
    el("ribbon").append(bar);
  }
  for (const [t] of strikes) {
    const mark = document.createElement("b");
    mark.style.left = share(t);
    el("ribbon").append(mark);
  }
  root.classList.add("ready");
  show(first);
}
