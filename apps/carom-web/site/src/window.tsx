// The window of a picture: how it is moved, and how it follows the room that there is.

import type { RefObject } from "preact";
import { useEffect } from "preact/hooks";
import type { Pair, Window } from "./engine/protocol";
import { doc, look, open, refit, size, windowNow } from "./state";

export const ZOOM = 1.2;
/** Pixels of a metre, at least and at most. */
const LEAST_SCALE = 30;
const MOST_SCALE = 200_000;

export const metres = (window: Window, [x, y]: Pair): Pair => [
  window.low[0] + x / window.scale,
  window.low[1] + (window.size[1] - y) / window.scale,
];

/** The same middle at another scale. */
export function zoomed(window: Window, by: number, [x, y]: Pair): Window {
  const [at, scale] = [metres(window, [x, y]), Math.min(MOST_SCALE, Math.max(LEAST_SCALE, window.scale * by))];
  return { ...window, scale, low: [at[0] - x / scale, at[1] - (window.size[1] - y) / scale] };
}

export const shifted = (window: Window, [dx, dy]: Pair): Window => ({
  ...window,
  low: [window.low[0] - dx / window.scale, window.low[1] + dy / window.scale],
});

function around(by: number): void {
  const window = windowNow();
  if (window !== undefined) look(zoomed(window, by, [window.size[0] / 2, window.size[1] / 2]));
}

/** Nearer, farther, and all of it. */
export function Zoom() {
  return (
    <div class="zoom">
      <button type="button" aria-label="Zoom in" onClick={() => around(ZOOM)}>
        +
      </button>
      <button type="button" aria-label="Zoom out" onClick={() => around(1 / ZOOM)}>
        −
      </button>
      <button type="button" onClick={() => void open(doc.peek(), "replace")}>
        Fit
      </button>
    </div>
  );
}

/** Keeps the picture as large as the room that it has. */
export function useFitting(picture: RefObject<SVGSVGElement | null>): void {
  useEffect(() => {
    const box = picture.current?.parentElement;
    if (box === null || box === undefined) return undefined;
    const watch = new ResizeObserver(() => {
      // In a view that is not shown it has no size.
      if (box.clientWidth === 0) return;
      const next: Pair = [Math.max(320, Math.round(box.clientWidth)), Math.max(200, Math.round(box.clientHeight))];
      if (next[0] === size.peek()[0] && next[1] === size.peek()[1]) return;
      size.value = next;
      void refit();
    });
    watch.observe(box);
    return () => watch.disconnect();
  }, []);
}
