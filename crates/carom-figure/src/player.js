// Plays a run: cubics between samples, so that slides and flights are exact with few of them.
// `page` holds the elements by their names; `load` gives it another motion and keeps the time.
function player(page) {
  "use strict";
  const el = (id) => page.querySelector(`#${id}`);
  const root = el("player");
  const [play, scrub, clock, label, speed, arrows] = ["play", "scrub", "clock", "stage", "speed", "arrows"].map(el);
  let [samples, others, stages, strikes, events, plots, rows] = [[], [], [], [], [], [], []];
  let [first, last, span, now] = [0, 0, 1, 0];
  let running = false;
  let frame = 0;
  let before = null;

  function load(numbers) {
    const atEnd = now >= last && samples.length > 0;
    ({ samples, stages, strikes } = numbers);
    const more = numbers.others ?? [];
    // Other parts of a feed: each appears when it starts, and stays where it was seen last.
    others = more.map((own, i) => ({ own, element: el(`part-${i + 2}`) }));
    const ends = [samples, ...more].filter((own) => own.length > 0);
    if (ends.length === 0) return;
    first = Math.min(...ends.map((own) => own[0][0]));
    last = Math.max(...ends.map((own) => own[own.length - 1][0]));
    span = Math.max(last - first, 1e-9);
    events = [...new Set([first, ...stages.map((s) => s[2]), ...strikes, last])].sort((a, b) => a - b);
    plots = [...page.querySelectorAll("svg.plot")];
    rows = [...page.querySelectorAll("[data-stage]")];
    ribbon();
    show(atEnd ? last : now);
  }

  // The last sample that is not after t, so that an instant of impact shows the motion after it.
  function indexAt(own, t) {
    let low = 0;
    let high = own.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (own[middle][0] <= t) low = middle;
      else high = middle - 1;
    }
    return low;
  }

  function cubic(p0, p1, m0, m1, u) {
    const a = 2 * p0 + m0 - 2 * p1 + m1;
    const b = -3 * p0 + 3 * p1 - 2 * m0 - m1;
    return ((a * u + b) * u + m0) * u + p0;
  }

  function poseAt(own, t) {
    const i = indexAt(own, t);
    const a = own[i];
    const b = own[Math.min(i + 1, own.length - 1)];
    const dt = b[0] - a[0];
    if (dt <= 0) return { x: a[1], y: a[2], angle: a[3], contacts: a[7] };
    const u = Math.min(Math.max((t - a[0]) / dt, 0), 1);
    const at = (k) => cubic(a[k], b[k], a[k + 3] * dt, b[k + 3] * dt, u);
    const same = a[7].length === b[7].length;
    const contacts = a[7].map((c, n) => (same ? c.map((x, k) => x + u * (b[7][n][k] - x)) : c));
    return { x: at(1), y: at(2), angle: at(3), contacts };
  }

  function stageAt(t) {
    let found = -1;
    stages.forEach((s, i) => {
      if (s[2] <= t + 1e-12) found = i;
    });
    return found;
  }

  function arrow([x, y, dx, dy]) {
    const length = Math.hypot(dx, dy);
    if (length < 2) return "";
    const [ux, uy] = [dx / length, dy / length];
    const [tx, ty] = [x + dx, y + dy];
    const wing = (s) => `${tx - 7 * ux + s * 3 * uy},${ty - 7 * uy - s * 3 * ux}`;
    return `<path class="force" d="M${x},${y}L${tx},${ty}M${wing(1)}L${tx},${ty}L${wing(-1)}"/>`;
  }

  function showPlots(t) {
    for (const plot of plots) {
      const d = plot.dataset;
      const ms = (t - Number(d.from)) * 1000;
      const line = plot.querySelector("line.now");
      const inside = ms >= Number(d.x0) && ms <= Number(d.x1);
      line.setAttribute("visibility", inside ? "visible" : "hidden");
      if (!inside) continue;
      const share = (ms - Number(d.x0)) / (Number(d.x1) - Number(d.x0));
      const x = Number(d.left) + share * (Number(d.right) - Number(d.left));
      line.setAttribute("x1", x.toFixed(2));
      line.setAttribute("x2", x.toFixed(2));
    }
  }

  function show(t) {
    now = Math.min(Math.max(t, first), last);
    const placed = (element, pose) =>
      element.setAttribute("transform", `translate(${pose.x.toFixed(3)} ${pose.y.toFixed(3)}) rotate(${pose.angle.toFixed(3)})`);
    // Numbers stay upright.
    const upright = (element, pose) =>
      element.querySelectorAll("text").forEach((text) => text.setAttribute("transform", `rotate(${(-pose.angle).toFixed(3)})`));
    const [part, forces] = [el("part"), el("forces")];
    const pose = poseAt(samples, now);
    placed(part, pose);
    upright(part, pose);
    const contacts = [...pose.contacts];
    for (const { own, element } of others) {
      const started = own.length > 0 && now >= own[0][0];
      element.setAttribute("visibility", started ? "visible" : "hidden");
      if (!started) continue;
      const other = poseAt(own, now);
      placed(element, other);
      upright(element, other);
      contacts.push(...other.contacts);
    }
    forces.innerHTML = arrows.checked ? contacts.map(arrow).join("") : "";
    scrub.value = String(Math.round(((now - first) / span) * 1000));
    const stage = stageAt(now);
    const name = stage < 0 ? "" : `${stage + 1} ${stages[stage][0]}${stages[stage][1] ? " on " + stages[stage][1] : ""}`;
    clock.textContent = `${now.toFixed(4)} s`;
    if (label.textContent !== name) label.textContent = name;
    scrub.setAttribute("aria-valuetext", `${now.toFixed(4)} seconds, ${name}`);
    rows.forEach((row) => row.classList.toggle("now", Number(row.dataset.stage) === stage));
    showPlots(now);
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
    play.textContent = "Play";
  }

  function goTo(t) {
    pause();
    show(t);
  }

  const closest = 1e-9 * (1 + Math.abs(last));
  const nextEvent = () => goTo(events.find((t) => t > now + closest) ?? last);
  const lastEvent = () => goTo(events.filter((t) => t < now - closest).pop() ?? first);
  const step = (n) => goTo(now + (n * Number(speed.value)) / 60);

  function ribbon() {
    el("ribbon").replaceChildren();
    const share = (t) => `${(100 * (t - first)) / span}%`;
    for (const s of stages) {
      const bar = document.createElement("span");
      bar.className = `key ${s[0]}`;
      bar.style.left = share(s[2]);
      bar.style.width = `${(100 * (s[3] - s[2])) / span}%`;
      el("ribbon").append(bar);
    }
    for (const t of strikes) {
      const mark = document.createElement("b");
      mark.style.left = share(t);
      el("ribbon").append(mark);
    }
  }

  play.addEventListener("click", () => (running ? pause() : start()));
  el("next").addEventListener("click", nextEvent);
  el("back").addEventListener("click", lastEvent);
  arrows.addEventListener("change", () => show(now));
  scrub.addEventListener("input", () => goTo(first + (Number(scrub.value) / 1000) * span));
  // What a key does; false where it does nothing.
  function press(key, fast) {
    const actions = {
      " ": () => (running ? pause() : start()),
      ".": nextEvent,
      ",": lastEvent,
      ArrowRight: () => step(fast ? 10 : 1),
      ArrowLeft: () => step(fast ? -10 : -1),
      Home: () => goTo(first),
      End: () => goTo(last),
    };
    actions[key]?.();
    return key in actions;
  }

  root.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.target === speed) return;
    const inButton = event.target instanceof HTMLButtonElement || event.target === arrows;
    if (inButton && event.key === " ") return;
    if (press(event.key, event.shiftKey)) event.preventDefault();
  });
  function goToPlace(plot, event) {
    const box = plot.getBoundingClientRect();
    const d = plot.dataset;
    const x = ((event.clientX - box.left) / box.width) * plot.viewBox.baseVal.width;
    const share = (x - Number(d.left)) / (Number(d.right) - Number(d.left));
    if (share < 0 || share > 1) return;
    goTo(Number(d.from) + (Number(d.x0) + share * (Number(d.x1) - Number(d.x0))) / 1000);
  }

  page.addEventListener("click", (event) => {
    const row = event.target.closest("[data-stage]");
    const plot = event.target.closest("svg.plot");
    if (row) goTo(Number(row.dataset.t));
    else if (plot) goToPlace(plot, event);
  });
  root.classList.add("ready");
  return { load, goTo, press };
}
