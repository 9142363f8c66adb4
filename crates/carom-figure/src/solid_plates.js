// Plates and walls among which a body moves, for the view that draws it. What is cut has an open edge: it goes on beyond the picture.
// A plate is [name, corners, for each side whether it is cut].
function solidPlates(pen, given) {
  "use strict";
  const minus = (a, b) => a.map((x, k) => x - b[k]);
  const dot = (a, b) => a.reduce((sum, x, k) => sum + x * b[k], 0);
  const cross = ([a, b, c], [x, y, z]) => [b * z - c * y, c * x - a * z, a * y - b * x];
  const middle = (places) => places[0].map((_, k) => places.reduce((sum, at) => sum + at[k], 0) / places.length);

  const plates = given.map(([name, corners, cut]) => {
    const centre = middle(corners);
    // Newell's: of all corners, so that two that are close do no harm.
    const normal = corners.reduce((sum, a, i) => {
      const b = corners[(i + 1) % corners.length];
      return cross(minus(a, centre), minus(b, centre)).map((x, k) => x + sum[k]);
    }, [0, 0, 0]);
    const size = Math.hypot(...normal) || 1;
    return { name, corners, cut, centre, normal: normal.map((x) => x / size) };
  });

  const over = (plate, place) => dot(plate.normal, minus(place, plate.centre));

  // What hides what: a plate is before the body where its plane is between the body and the eye.
  function ordered(eye, body) {
    const far = (plate) => Math.hypot(...minus(plate.centre, eye));
    const sorted = [...plates].sort((a, b) => far(b) - far(a));
    const before = (plate) => over(plate, eye) * over(plate, body) < 0;
    return [sorted.filter((plate) => !before(plate)), sorted.filter(before)];
  }

  function outline(places) {
    pen.beginPath();
    places.forEach(([x, y], i) => (i ? pen.lineTo(x, y) : pen.moveTo(x, y)));
    pen.closePath();
  }

  function draw(some, before, project, c) {
    for (const { corners, cut, normal } of some) {
      const seen = corners.map(project);
      // What has no edge of its own in the picture, as the walls of a groove, is to hide least.
      const share = cut.every((is) => is) && Math.abs(normal[2]) < 0.1 ? 0.45 : 1;
      const light = Math.abs(0.35 * normal[0] - 0.5 * normal[1] + 0.79 * normal[2]);
      outline(seen);
      if (!before) {
        pen.globalAlpha = 0.55 * share;
        pen.fillStyle = c.panel;
        pen.fill();
      }
      pen.globalAlpha = share * (before ? 0.12 : 0.4 - 0.14 * light);
      pen.fillStyle = c.grey;
      pen.fill();
      seen.forEach(([x, y], i) => {
        const [u, v] = seen[(i + 1) % seen.length];
        pen.beginPath();
        pen.moveTo(x, y);
        pen.lineTo(u, v);
        pen.globalAlpha = cut[i] ? 0.75 : 0.9;
        pen.strokeStyle = cut[i] ? c.grey : c.soft;
        pen.lineWidth = cut[i] ? 1.2 : 1.7;
        pen.setLineDash(cut[i] ? [1.5, 4.5] : []);
        pen.stroke();
      });
      pen.setLineDash([]);
      pen.globalAlpha = 1;
    }
  }

  // The plate straight below a place, and how to get down to it.
  function below(place) {
    const drop = (plate, [x, y]) => {
      const [p, q] = [x - plate.centre[0], y - plate.centre[1]];
      return plate.centre[2] - (plate.normal[0] * p + plate.normal[1] * q) / plate.normal[2];
    };
    const carries = (plate) => {
      if (Math.abs(plate.normal[2]) < 0.1 || drop(plate, place) > place[2]) return false;
      const signs = plate.corners.map(([x, y], i) => {
        const [u, v] = plate.corners[(i + 1) % plate.corners.length];
        return (u - x) * (place[1] - y) - (v - y) * (place[0] - x);
      });
      return signs.every((s) => s >= 0) || signs.every((s) => s <= 0);
    };
    const found = plates.filter(carries).sort((a, b) => drop(b, place) - drop(a, place))[0];
    return found && { plate: found, onto: ([x, y]) => [x, y, drop(found, [x, y])] };
  }

  // The shadow of a body that the sun in the zenith throws on the plate below it.
  function shadow(project, world, centre, hull, c) {
    const on = below(centre);
    if (!on) return;
    pen.save();
    outline(on.plate.corners.map(project));
    pen.clip();
    outline(hull(world.map((at) => project(on.onto(at)).slice(0, 2))));
    pen.globalAlpha = 0.16;
    pen.fillStyle = c.ink;
    pen.fill();
    pen.restore();
  }

  // Names where they are farthest from the way of the body; `taken` are boxes in which something stands already.
  function names(project, way, [left, top, right, bottom], taken, c) {
    pen.font = "600 13px system-ui, sans-serif";
    pen.lineWidth = 4;
    pen.lineJoin = "round";
    pen.strokeStyle = c.panel;
    pen.fillStyle = c.soft;
    const avoided = way.map(project);
    for (const { name, corners } of plates.filter((plate) => plate.name)) {
      const seen = corners.map(project);
      const centre = middle(seen);
      const width = pen.measureText(name).width;
      const inwards = (at, share) => at.map((x, k) => x + share * (centre[k] - x));
      const spots = seen.flatMap((at, i) => {
        const next = seen[(i + 1) % seen.length];
        const along = (u) => at.map((x, k) => x + u * (next[k] - x));
        return [0, 0.25, 0.5, 0.75].map((u) => inwards(along(u), 0.28));
      });
      const boxes = spots.map(([x, y]) => [x - 0.5 * width, y - 7, x + 0.5 * width, y + 7]);
      const room = ([a, b, u, v]) => {
        if (a < left + 4 || b < top + 4 || u > right - 4 || v > bottom - 4) return -1;
        if (taken.some(([p, q, r, s]) => a < r + 4 && p < u + 4 && b < s + 3 && q < v + 3)) return -1;
        const apart = ([x, y]) => Math.hypot(Math.max(a - x, x - u, 0), Math.max(b - y, y - v, 0));
        return Math.min(60, ...avoided.map(apart));
      };
      const best = boxes.reduce((a, b) => (room(b) > room(a) + 1 ? b : a));
      if (room(best) < 0) continue;
      taken.push(best);
      pen.strokeText(name, best[0], best[3] - 3);
      pen.fillText(name, best[0], best[3] - 3);
    }
  }

  return { any: plates.length > 0, corners: plates.flatMap((plate) => plate.corners), ordered, draw, shadow, names };
}
