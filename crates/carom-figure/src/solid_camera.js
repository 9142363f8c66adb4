// From where a body is seen: `view` has the angles and how near it is, `target` is looked at, `reach` is how far about it there is something to see.
// Among plates all of them and the way of the body are to be seen.
function solidCamera(canvas, view, plates, way, target, reach) {
  "use strict";
  // Along the view: to the right, up, and out of it towards the eye.
  function along(to) {
    const [cy, sy, cp, sp] = [Math.cos(view.yaw), Math.sin(view.yaw), Math.cos(view.pitch), Math.sin(view.pitch)];
    return ([x, y, z]) => {
      const [dx, dy, dz] = [x - to[0], y - to[1], z - to[2]];
      return [-sy * dx + cy * dy, -sp * (cy * dx + sy * dy) + cp * dz, cp * (cy * dx + sy * dy) + sp * dz];
    };
  }

  // A box [left, top, right, bottom] with what is seen of a place in it: `scale` pixels for the body's size, `at` in its middle.
  function lens([left, top, right, bottom], looked, away, scale, at) {
    return (place) => {
      const [x, y, out] = looked(place);
      const near = away / (away - out);
      return [
        0.5 * (left + right) + scale * (near * x - at[0]),
        0.5 * (top + bottom) - scale * (near * y - at[1]),
        out,
      ];
    };
  }

  // A strip for the body alone, larger: to the right, or above where the picture is narrow.
  function boxes() {
    const [w, h] = [canvas.clientWidth, canvas.clientHeight];
    if (!plates.any) return { scene: [0, 0, w, h] };
    if (w < 560) return { scene: [0, 130, w, h], alone: [w - 150, 0, w, 130] };
    const strip = Math.min(0.25 * w, 260);
    return { scene: [0, 0, w - strip, h], alone: [w - strip, 0, w, Math.min(h, 1.15 * strip)] };
  }

  function camera(box, pose) {
    const [w, h] = [box[2] - box[0], box[3] - box[1]];
    const looked = along(target);
    if (!plates.any) {
      return lens(box, looked, 6 * reach, ((0.45 * Math.min(w * 0.75, h)) / reach) * view.zoom, [0, 0]);
    }
    // All of the way and of the plates is to be seen; who comes nearer looks at the body.
    const away = 4 * Math.max(...plates.corners.map((corner) => Math.hypot(...looked(corner))), reach);
    const flat = lens([0, 0, 0, 0], looked, away, 1, [0, 0]);
    const seen = [...plates.corners.map((corner) => [...flat(corner), 0]), ...way.map((at) => [...flat(at), 1])];
    const end = (k, sign) => sign * Math.max(...seen.map((at) => sign * at[k] + at[3]));
    const [left, right, top, bottom] = [end(0, -1), end(0, 1), end(1, -1), end(1, 1)];
    const scale = Math.min((w - 44) / (right - left), (h - 44) / (bottom - top)) * view.zoom;
    const share = Math.max(0, 1 - 1 / view.zoom);
    const [x, y] = flat(pose.at);
    const all = [0.5 * (left + right), -0.5 * (top + bottom)];
    return lens(box, looked, away, scale, [all[0] + share * (x - all[0]), all[1] + share * (-y - all[1])]);
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

  // Twice the area on the canvas: below 0 where it is seen from outside.
  function area(places) {
    return places.reduce((sum, [x, y], i) => {
      const [u, v] = places[(i + 1) % places.length];
      return sum + x * v - u * y;
    }, 0);
  }

  return { boxes, along, lens, camera, hull, area };
}
