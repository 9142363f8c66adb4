// Parts to begin with: the keys of `[part]`, each a kind that the scene file knows.

import type { Pair } from "./engine/protocol";

export const PARTS: [string, string][] = [
  ["rod", 'shape = "rod"\nlength = "100 mm"\nmass = "0.3 kg"'],
  ["box", 'shape = "box"\nlength = "80 mm"\nheight = "12 mm"\nmass = "0.2 kg"'],
  ["disc", 'shape = "disc"\nradius = "20 mm"\nmass = "0.1 kg"'],
  ["polygon", 'shape = "polygon"\nvertices = [["0 mm", "0 mm"], ["60 mm", "0 mm"], ["45 mm", "20 mm"], ["0 mm", "20 mm"]]\nmass = "0.1 kg"'],
  ["bolt M8 × 30", 'shape = "bolt"\nsize = "M8 x 30"\ndensity = "7.85 g/cm^3"'],
  ["washer M8", 'shape = "washer"\nsize = "M8"\ndensity = "7.85 g/cm^3"'],
  ["pin 6 × 30", 'shape = "pin"\nsize = "6 x 30"\ndensity = "7.85 g/cm^3"'],
  ["cap", 'shape = "cap"\ndiameter = "30 mm"\nheight = "12 mm"\nwall = "1.2 mm"\ncorner_radius = "1.5 mm"\ndensity = "0.95 g/cm^3"'],
  ["bracket", 'shape = "bracket"\nlegs = ["60 mm", "40 mm"]\nthickness = "6 mm"\nmass = "0.1 kg"'],
];

/** A part that a file draws. */
export const drawnBy = (file: string): string => `shape = "outline"\nfile = ${JSON.stringify(file)}\nmass = "0.1 kg"`;

/** A body whose surface a file draws: let go askew, a little above its plane. */
export const thrown = (file: string): string =>
  `file = ${JSON.stringify(file)}\nunit = "mm"\ndensity = "7800 kg/m^3"\naxis = [1, 0, 0]\nturn = "30 deg"\nheight = "2 mm"`;

/** A part by its corners [m], in whole millimetres from the first one. */
export function polygon(corners: Pair[]): string {
  const [x0, y0] = corners[0] ?? [0, 0];
  const millimetres = (value: number) => `"${Math.round(1e3 * value)} mm"`;
  // Counter-clockwise, as outlines are written.
  const twice = corners.reduce((sum, [x, y], i) => {
    const [u, v] = corners[(i + 1) % corners.length] ?? [0, 0];
    return sum + x * v - u * y;
  }, 0);
  const ordered = twice < 0 ? [...corners].reverse() : corners;
  const vertices = ordered.map(([x, y]) => `[${millimetres(x - x0)}, ${millimetres(y - y0)}]`);
  return `shape = "polygon"\nvertices = [${vertices.join(", ")}]\nmass = "0.1 kg"`;
}
