// Draws a body in space on its plane, or among plates and walls; z is up, and the view is turned by dragging.
// `poseAt(t)` gives its place, the attitude as a quaternion, the points that are held and where else it touches; what is returned draws an instant.
function solidView(root, canvas, numbers, poseAt, named, view) {
  "use strict";
  const { corners, faces, lines, points, names, samples, stages, strikes } = numbers;
  const seams = new Set((numbers.seams ?? []).map(String));
  const numberOf = numbers.numbers ?? faces.map((_, i) => i);
  // Of every corner of the drawing the point that it is at: round corners are drawn with several.
  const apart = (a, b) => Math.hypot(...a.map((x, k) => x - b[k]));
  const nearest = corners.map((r) => points.reduce((best, p, i) => (apart(r, p) < apart(r, points[best]) ? i : best), 0));
  // Of a rounded body there are several corners about a point; an inner corner is at none.
  const least = points.map((p) => Math.min(...corners.map((r) => apart(r, p))));
  const owner = nearest.map((i, k) => (points.length && apart(corners[k], points[i]) <= 1.5 * least[i] + 1e-4 ? i : undefined));
  const pen = canvas.getContext("2d");
  const span = Math.max(samples[samples.length - 1][0] - samples[0][0], 1e-12);
  const plates = solidPlates(pen, numbers.plates ?? []);
  // Plates are looked at as they are drawn: x to the right.
  const home = plates.any ? { yaw: -1.25, pitch: 0.34, zoom: 1 } : { yaw: -0.95, pitch: 0.42, zoom: 1 };
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

  // Places of the body on its way: few of many.
  const way = (() => {
    const every = Math.max(1, Math.floor(samples.length / 60));
    return samples.filter((_, i) => i % every === 0 || i === samples.length - 1).map((sample) => sample.slice(1, 4));
  })();

  const { boxes, along, lens, camera, hull, area } = solidCamera(canvas, view, plates, way, target, reach);

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

  function sides(ends) {
    pen.beginPath();
    for (const [a, b] of ends) {
      pen.moveTo(a[0], a[1]);
      pen.lineTo(b[0], b[1]);
    }
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

  function shadow(project, world, c) {
    polygon(hull(world.map(([x, y]) => [x, y])).map(([x, y]) => project([x, y, 0])));
    pen.globalAlpha = 0.1;
    pen.fillStyle = c.ink;
    pen.fill();
    pen.globalAlpha = 1;
  }

  const tracks = strikes.slice(0, 200).flatMap(([t, struck, places], k) => {
    const pose = poseAt(t);
    return [...struck.map((i) => placed(pose, points[i])), ...(places ?? [])].map((at) => [...at, k + 1]);
  });

  // Where stages begin, and at the end: what a picture that stands still shows of the way. Those that would hide each other are left out.
  const ghosts = (() => {
    if (!plates.any) return [];
    const shown = [];
    for (const t of [...stages.map((s) => s[2]), ...strikes.map(([t]) => t), samples[samples.length - 1][0]]) {
      const pose = poseAt(t);
      const close = (other) => Math.hypot(...other.at.map((x, k) => x - pose.at[k])) < 1.2;
      if (shown.length < 16 && !shown.some(close)) shown.push(pose);
    }
    return shown.map((pose) => corners.map((corner) => placed(pose, corner)));
  })();

  function ghost(project, world, c) {
    polygon(hull(world.map((at) => project(at).slice(0, 2))));
    pen.fillStyle = c.ink;
    pen.globalAlpha = 0.04;
    pen.fill();
    pen.strokeStyle = c.ink;
    pen.lineWidth = 1;
    pen.globalAlpha = 0.3;
    pen.stroke();
    pen.globalAlpha = 1;
  }

  // A ring where it strikes; among plates with the number of the strike, where that is not on another.
  function marks(project, c) {
    const numbered = [];
    pen.font = "10px system-ui, sans-serif";
    for (const place of tracks) {
      const [x, y] = project(plates.any ? place : [place[0], place[1], 0]);
      pen.globalAlpha = 0.5;
      pen.strokeStyle = c.red;
      pen.lineWidth = 1.2;
      pen.beginPath();
      pen.ellipse(x, y, 5, 5 * Math.max(Math.abs(Math.sin(view.pitch)), 0.15), 0, 0, 7);
      pen.stroke();
      if (!plates.any || numbered.some(([u, v]) => Math.abs(u - x) < 11 && Math.abs(v - y) < 11)) continue;
      numbered.push([x, y]);
      pen.globalAlpha = 1;
      pen.fillStyle = c.red;
      pen.fillText(String(place[3]), x - 3, y + 14);
    }
    pen.globalAlpha = 1;
  }

  function path(project, c) {
    const every = Math.max(1, Math.floor(samples.length / 600));
    const line = (until, alpha) => {
      pen.strokeStyle = c.blue;
      pen.globalAlpha = alpha;
      pen.lineWidth = 1.3;
      pen.beginPath();
      for (let i = 0; i < samples.length && samples[i][0] <= until; i += every) {
        const [x, y] = project(samples[i].slice(1, 4));
        if (i) pen.lineTo(x, y);
        else pen.moveTo(x, y);
      }
      pen.stroke();
      pen.globalAlpha = 1;
    };
    if (plates.any) line(Infinity, 0.25);
    line(now, 0.55);
  }

  // Faces from the back: those that look away are seen through the others.
  function body(project, world, c, thin) {
    const seen = world.map(project);
    const drawn = faces.map((face) => {
      const places = face.map((i) => seen[i]);
      const [a, b, d] = face.map((i) => world[i]);
      const [p, q] = [b.map((x, k) => x - a[k]), d.map((x, k) => x - a[k])];
      const n = [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]];
      const length = Math.hypot(...n) || 1;
      const light = (0.35 * n[0] - 0.5 * n[1] + 0.79 * n[2]) / length;
      const edges = face.map((i, k) => [i, face[(k + 1) % face.length]]).filter((side) => !seams.has(String(side)));
      return { places, edges, front: area(places) < 0, light, depth: places.reduce((s, x) => s + x[2], 0) / places.length };
    });
    drawn.sort((a, b) => a.front - b.front || a.depth - b.depth);
    for (const { places, edges, front, light } of drawn) {
      polygon(places);
      if (front && plates.any) {
        pen.fillStyle = c.panel;
        pen.globalAlpha = 0.6;
        pen.fill();
      }
      pen.fillStyle = c.ink;
      pen.globalAlpha = front ? 0.2 - 0.13 * light : 0.03;
      pen.fill();
      pen.globalAlpha = front ? 0.95 : 0.28;
      pen.strokeStyle = c.ink;
      pen.lineWidth = (front ? 1.8 : 1) * (thin ? 0.65 : 1);
      pen.lineJoin = "round";
      pen.setLineDash(front ? [] : [4, 4]);
      if (edges.length < places.length) sides(edges.map(([i, j]) => [seen[i], seen[j]]));
      // A small body with its far sides dashed is a tangle.
      if (front || !thin) pen.stroke();
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

  function dot(x, y, size, colour, filled, c) {
    pen.beginPath();
    pen.arc(x, y, size, 0, 7);
    pen.fillStyle = filled ? colour : c.panel;
    pen.fill();
    pen.strokeStyle = colour;
    pen.lineWidth = plates.any ? 1 : 2;
    pen.stroke();
  }

  function ring(x, y, c) {
    pen.beginPath();
    pen.arc(x, y, 11, 0, 7);
    pen.strokeStyle = c.red;
    pen.lineWidth = 2;
    pen.stroke();
  }

  function contacts(project, pose, c) {
    const flash = 0.02 * span;
    const fresh = strikes.filter(([t]) => t <= now + 1e-12 && now - t < flash);
    const hit = new Set(fresh.flatMap(([, struck]) => struck));
    const large = plates.any ? 3.4 : 5.5;
    points.forEach((r, i) => {
      const held = pose.held.includes(i);
      // Among plates a body is small: of its points those are shown that touch.
      if (plates.any && !held && !hit.has(i)) return;
      const [x, y] = project(placed(pose, r));
      const colour = hit.has(i) ? c.red : held ? c.green : c.grey;
      dot(x, y, held ? large : large - 1, colour, held || hit.has(i), c);
      if (hit.has(i)) ring(x, y, c);
    });
    for (const r of pose.also ?? []) dot(...project(placed(pose, r)).slice(0, 2), large, c.green, true, c);
    for (const place of fresh.flatMap(([, , places]) => places ?? [])) ring(...project(place).slice(0, 2), c);
    if (!plates.any && (!named || named.checked)) pointNames(project, pose, c);
    const [x, y] = project(pose.at);
    pen.beginPath();
    pen.arc(x, y, plates.any ? 2.2 : 3, 0, 7);
    pen.fillStyle = c.blue;
    pen.fill();
  }

  // The numbers of the faces that are seen, then those of their corners where there is room.
  function numbersOn(project, world, c) {
    const seen = world.map(project);
    const taken = [];
    const put = (text, x, y, font, colour) => {
      pen.font = font;
      const half = 0.5 * pen.measureText(text).width;
      const box = [x - half, y - 6, x + half, y + 6];
      if (taken.some(([p, q, r, t]) => box[0] < r + 2 && p < box[2] + 2 && box[1] < t + 1 && q < box[3] + 1)) return;
      taken.push(box);
      pen.lineWidth = 3;
      pen.strokeStyle = c.panel;
      pen.strokeText(text, x - half, y + 5);
      pen.fillStyle = colour;
      pen.fillText(text, x - half, y + 5);
    };
    const front = faces.map((face, i) => [i, face.map((k) => seen[k]), area(face.map((k) => seen[k]))]);
    const shown = front.filter(([i, , size]) => numberOf[i] !== undefined && size < -420).sort((a, b) => a[2] - b[2]);
    // A face of several pieces has its number on the largest of them.
    const told = new Set();
    for (const [i, places] of shown.filter(([i]) => !told.has(numberOf[i]) && told.add(numberOf[i]))) {
      const middle = [0, 1].map((k) => places.reduce((sum, at) => sum + at[k], 0) / places.length);
      put(String(numberOf[i]), ...middle, "700 15px system-ui, sans-serif", c.blue);
    }
    const centre = [0, 1].map((k) => seen.reduce((sum, at) => sum + at[k], 0) / seen.length);
    const named = new Map();
    for (const k of front.filter(([, , size]) => size < 0).flatMap(([face]) => faces[face])) {
      if (owner[k] !== undefined && !named.has(owner[k])) named.set(owner[k], k);
    }
    for (const [i, k] of named) {
      const out = [seen[k][0] - centre[0], seen[k][1] - centre[1]];
      const far = Math.hypot(...out) || 1;
      put(names[i], seen[k][0] + (11 * out[0]) / far, seen[k][1] + (11 * out[1]) / far, "11px system-ui, sans-serif", c.soft);
    }
  }

  // The body alone as it is now, large enough for the numbers of its faces.
  function alone(box, pose, world, c) {
    const [left, top, right, bottom] = box;
    const size = 0.36 * Math.min(right - left, bottom - top);
    const project = lens(box, along(pose.at), 6, size, [0, 0]);
    pen.fillStyle = c.panel;
    pen.fillRect(left, top, right - left, bottom - top);
    body(project, world, c);
    if (!named || named.checked) numbersOn(project, world, c);
    contacts(project, pose, c);
  }

  function amongPlates(box, alone, project, world, pose, c) {
    const eye = [Math.cos(view.yaw) * Math.cos(view.pitch), Math.sin(view.yaw) * Math.cos(view.pitch), Math.sin(view.pitch)];
    const [behind, before] = plates.ordered(eye.map((x, k) => target[k] + 1e3 * reach * x), pose.at);
    plates.draw(behind, false, project, c);
    plates.shadow(project, world, pose.at, hull, c);
    for (const other of ghosts) ghost(project, other, c);
    return () => {
      plates.draw(before, true, project, c);
      plates.names(project, way, box, alone ? [alone] : [], c);
    };
  }

  function draw() {
    const ratio = window.devicePixelRatio || 1;
    const [w, h] = [Math.round(canvas.clientWidth * ratio), Math.round(canvas.clientHeight * ratio)];
    if (canvas.width !== w || canvas.height !== h) [canvas.width, canvas.height] = [w, h];
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.clearRect(0, 0, w, h);
    const c = colours();
    const pose = poseAt(now);
    const box = boxes();
    const project = camera(box.scene, pose);
    const world = corners.map((corner) => placed(pose, corner));
    const last = plates.any && amongPlates(box.scene, box.alone, project, world, pose, c);
    if (!plates.any) {
      ground(project, c);
      shadow(project, world, c);
    }
    marks(project, c);
    body(project, world, c, plates.any);
    path(project, c);
    contacts(project, pose, c);
    if (last) last();
    if (box.alone) alone(box.alone, pose, world, c);
  }

  function turn(yaw, pitch) {
    view.yaw += yaw;
    view.pitch = Math.min(Math.max(view.pitch + pitch, plates.any ? -1.55 : -0.3), 1.55);
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
  for (const media of ["(prefers-color-scheme: dark)", "print"]) window.matchMedia(media).addEventListener("change", draw);
  return (t) => {
    now = t;
    draw();
  };
}
