// Draws a body in space on its plane; the view is turned by dragging.
// `poseAt(t)` gives its place, the attitude as a quaternion and the points that are held; what is returned draws an instant.
function solidView(root, canvas, numbers, poseAt, named, view) {
  "use strict";
  const { corners, faces, lines, points, names, samples, strikes } = numbers;
  const pen = canvas.getContext("2d");
  const span = Math.max(samples[samples.length - 1][0] - samples[0][0], 1e-12);
  const home = { yaw: -0.95, pitch: 0.42, zoom: 1 };
  if (view.zoom === undefined) Object.assign(view, home);
  let now = samples[0][0];

  // v turned by a unit quaternion [w, x, y, z].
  function turned([w, x, y, z], [a, b, c]) {
    const [p, q, r] = [2 * (y * c - z * b), 2 * (z * a - x * c), 2 * (x * b - y * a)];
    return [a + w * p + (y * r - z * q), b + w * q + (z * p - x * r), c + w * r + (x * q - y * p)];
  }

  const placed = (pose, r) => turned(pose.q, r).map((x, k) => x + pose.at[k]);

  // What the view looks at, and how much of the plane it shows.
  const [target, reach] = (() => {
    const low = [Infinity, Infinity, Infinity];
    const high = [-Infinity, -Infinity, -Infinity];
    const every = Math.max(1, Math.floor(samples.length / 200));
    for (let i = 0; i < samples.length; i += every) {
      const pose = poseAt(samples[i][0]);
      for (const corner of corners) {
        placed(pose, corner).forEach((x, k) => {
          low[k] = Math.min(low[k], x);
          high[k] = Math.max(high[k], x);
        });
      }
    }
    const half = high.map((x, k) => 0.5 * (x - low[k]));
    return [low.map((x, k) => x + half[k]), Math.hypot(...half)];
  })();

  function camera() {
    const [cy, sy, cp, sp] = [Math.cos(view.yaw), Math.sin(view.yaw), Math.cos(view.pitch), Math.sin(view.pitch)];
    const away = 6 * reach;
    const [w, h] = [canvas.clientWidth, canvas.clientHeight];
    const scale = ((0.45 * Math.min(w * 0.75, h)) / reach) * view.zoom;
    return ([x, y, z]) => {
      const [dx, dy, dz] = [x - target[0], y - target[1], z - target[2]];
      const right = -sy * dx + cy * dy;
      const out = cp * (cy * dx + sy * dy) + sp * dz;
      const up = -sp * (cy * dx + sy * dy) + cp * dz;
      const near = away / (away - out);
      return [0.5 * w + scale * near * right, 0.5 * h - scale * near * up, out];
    };
  }

  function colours() {
    const style = getComputedStyle(root);
    const of = (name) => style.getPropertyValue(`--${name}`).trim();
    return Object.fromEntries(["ink", "paper", "soft", "rule", "panel", "red", "green", "blue", "grey", "ochre"].map((n) => [n, of(n)]));
  }

  function polygon(places) {
    pen.beginPath();
    places.forEach(([x, y], i) => (i ? pen.lineTo(x, y) : pen.moveTo(x, y)));
    pen.closePath();
  }

  function stroke(from, to, colour, width, alpha) {
    pen.globalAlpha = alpha;
    pen.strokeStyle = colour;
    pen.lineWidth = width;
    pen.beginPath();
    pen.moveTo(from[0], from[1]);
    pen.lineTo(to[0], to[1]);
    pen.stroke();
    pen.globalAlpha = 1;
  }

  function ground(project, c) {
    const step = 0.25 * 2 ** Math.round(Math.log2(reach));
    const half = Math.ceil((1.7 * reach) / step);
    const [ox, oy] = [Math.round(target[0] / step) * step, Math.round(target[1] / step) * step];
    const corner = (i, j) => project([ox + i * step, oy + j * step, 0]);
    polygon([corner(-half, -half), corner(half, -half), corner(half, half), corner(-half, half)]);
    pen.fillStyle = c.paper;
    pen.fill();
    for (let i = -half; i <= half; i += 1) {
      stroke(corner(i, -half), corner(i, half), c.rule, 1, 1);
      stroke(corner(-half, i), corner(half, i), c.rule, 1, 1);
    }
  }

  // The outline of points in the plane.
  function hull(places) {
    const sorted = [...places].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
    const side = (list) => {
      const out = [];
      for (const p of list) {
        while (out.length > 1) {
          const [a, b] = out.slice(-2);
          if ((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) > 0) break;
          out.pop();
        }
        out.push(p);
      }
      return out.slice(0, -1);
    };
    return [...side(sorted), ...side(sorted.reverse())];
  }

  function shadow(project, world, c) {
    polygon(hull(world.map(([x, y]) => [x, y])).map(([x, y]) => project([x, y, 0])));
    pen.globalAlpha = 0.1;
    pen.fillStyle = c.ink;
    pen.fill();
    pen.globalAlpha = 1;
  }

  const tracks = strikes.slice(0, 200).flatMap(([t, struck]) => {
    const pose = poseAt(t);
    return struck.map((i) => placed(pose, points[i]));
  });

  function marks(project, c) {
    for (const place of tracks) {
      const [x, y] = project([place[0], place[1], 0]);
      pen.globalAlpha = 0.5;
      pen.strokeStyle = c.red;
      pen.lineWidth = 1.2;
      pen.beginPath();
      pen.ellipse(x, y, 5, 5 * Math.max(Math.abs(Math.sin(view.pitch)), 0.15), 0, 0, 7);
      pen.stroke();
    }
    pen.globalAlpha = 1;
  }

  function path(project, c) {
    pen.strokeStyle = c.blue;
    pen.globalAlpha = 0.55;
    pen.lineWidth = 1.3;
    pen.beginPath();
    const every = Math.max(1, Math.floor(samples.length / 600));
    for (let i = 0; i < samples.length && samples[i][0] <= now; i += every) {
      const [x, y] = project(samples[i].slice(1, 4));
      if (i) pen.lineTo(x, y);
      else pen.moveTo(x, y);
    }
    pen.stroke();
    pen.globalAlpha = 1;
  }

  // Faces from the back: those that look away are seen through the others.
  function body(project, world, c) {
    const seen = world.map(project);
    const drawn = faces.map((face) => {
      const places = face.map((i) => seen[i]);
      let area = 0;
      places.forEach(([x, y], i) => {
        const [u, v] = places[(i + 1) % places.length];
        area += x * v - u * y;
      });
      const [a, b, d] = face.map((i) => world[i]);
      const [p, q] = [b.map((x, k) => x - a[k]), d.map((x, k) => x - a[k])];
      const n = [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]];
      const length = Math.hypot(...n) || 1;
      const light = (0.35 * n[0] - 0.5 * n[1] + 0.79 * n[2]) / length;
      return { places, front: area < 0, light, depth: places.reduce((s, x) => s + x[2], 0) / places.length };
    });
    drawn.sort((a, b) => a.front - b.front || a.depth - b.depth);
    for (const { places, front, light } of drawn) {
      polygon(places);
      pen.fillStyle = c.ink;
      pen.globalAlpha = front ? 0.2 - 0.13 * light : 0.03;
      pen.fill();
      pen.globalAlpha = front ? 0.95 : 0.28;
      pen.strokeStyle = c.ink;
      pen.lineWidth = front ? 1.8 : 1;
      pen.lineJoin = "round";
      pen.setLineDash(front ? [] : [4, 4]);
      pen.stroke();
      pen.setLineDash([]);
    }
    pen.globalAlpha = 1;
    for (const [i, j] of lines) stroke(seen[i], seen[j], c.ink, 2.4, 0.9);
  }

  // Names at the first place beside their point that is free; those of points that touch come first, and a name without a place is left out.
  function pointNames(project, pose, c) {
    pen.font = "600 13px system-ui, sans-serif";
    pen.lineWidth = 3;
    pen.strokeStyle = c.panel;
    pen.fillStyle = c.ink;
    const taken = [];
    const order = points.map((_, i) => i).sort((a, b) => pose.held.includes(b) - pose.held.includes(a) || a - b);
    for (const i of order) {
      const [x, y] = project(placed(pose, points[i]));
      const width = pen.measureText(names[i]).width;
      const places = [[x + 9, y - 8], [x - 9 - width, y - 8], [x + 9, y + 17], [x - 9 - width, y + 17]];
      const free = ([u, v]) => taken.every(([a, b, w]) => u > a + w + 2 || a > u + width + 2 || Math.abs(v - b) > 13);
      const at = places.find(free);
      if (!at) continue;
      taken.push([at[0], at[1], width]);
      pen.strokeText(names[i], at[0], at[1]);
      pen.fillText(names[i], at[0], at[1]);
    }
  }

  function contacts(project, pose, c) {
    const flash = 0.02 * span;
    const hit = new Set(strikes.filter(([t]) => t <= now + 1e-12 && now - t < flash).flatMap(([, struck]) => struck));
    points.forEach((r, i) => {
      const [x, y] = project(placed(pose, r));
      const held = pose.held.includes(i);
      pen.beginPath();
      pen.arc(x, y, held ? 5.5 : 4.5, 0, 7);
      pen.fillStyle = hit.has(i) ? c.red : held ? c.green : c.panel;
      pen.fill();
      pen.strokeStyle = hit.has(i) ? c.red : held ? c.green : c.grey;
      pen.lineWidth = 2;
      pen.stroke();
      if (hit.has(i)) {
        pen.beginPath();
        pen.arc(x, y, 11, 0, 7);
        pen.stroke();
      }
    });
    if (!named || named.checked) pointNames(project, pose, c);
    const [x, y] = project(pose.at);
    pen.beginPath();
    pen.arc(x, y, 3, 0, 7);
    pen.fillStyle = c.blue;
    pen.fill();
  }

  function draw() {
    const ratio = window.devicePixelRatio || 1;
    const [w, h] = [Math.round(canvas.clientWidth * ratio), Math.round(canvas.clientHeight * ratio)];
    if (canvas.width !== w || canvas.height !== h) [canvas.width, canvas.height] = [w, h];
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.clearRect(0, 0, w, h);
    const c = colours();
    const project = camera();
    const pose = poseAt(now);
    const world = corners.map((corner) => placed(pose, corner));
    ground(project, c);
    shadow(project, world, c);
    marks(project, c);
    body(project, world, c);
    path(project, c);
    contacts(project, pose, c);
  }

  function turn(yaw, pitch) {
    view.yaw += yaw;
    view.pitch = Math.min(Math.max(view.pitch + pitch, -0.3), 1.55);
    draw();
  }

  function nearer(factor) {
    view.zoom = Math.min(Math.max(view.zoom * factor, 0.4), 12);
    draw();
  }

  function putBack() {
    Object.assign(view, home);
    draw();
  }

  let held = null;
  canvas.addEventListener("pointerdown", (event) => {
    held = [event.clientX, event.clientY];
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener("pointermove", (event) => {
    if (!held) return;
    turn(-(event.clientX - held[0]) * 0.008, (event.clientY - held[1]) * 0.008);
    held = [event.clientX, event.clientY];
  });
  for (const name of ["pointerup", "pointercancel"]) canvas.addEventListener(name, () => (held = null));
  canvas.addEventListener("dblclick", putBack);
  canvas.addEventListener(
    "wheel",
    (event) => {
      // The wheel alone scrolls the page.
      if (!event.ctrlKey) return;
      event.preventDefault();
      nearer(Math.exp(-0.004 * event.deltaY));
    },
    { passive: false },
  );
  canvas.addEventListener("keydown", (event) => {
    const actions = {
      ArrowLeft: () => turn(0.08, 0),
      ArrowRight: () => turn(-0.08, 0),
      ArrowUp: () => turn(0, 0.08),
      ArrowDown: () => turn(0, -0.08),
      "+": () => nearer(1.15),
      "=": () => nearer(1.15),
      "-": () => nearer(1 / 1.15),
      0: putBack,
    };
    const action = actions[event.key];
    if (!action || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    event.stopPropagation();
    action();
  });
  window.addEventListener("resize", draw);
  window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", draw);
  return (t) => {
    now = t;
    draw();
  };
}
