// The impact lab: what is struck, to scale and to be pulled, and below it the walk in impulse space, stage by stage.

import { signal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import type { Lab as Impact } from "../engine/protocol";
import { doc } from "../state";
import { Sketch } from "./Sketch";
import { Walk } from "./Walk";

/** How far the walk is: whole numbers are the ends of stages. */
export const at = signal(0);
/** Whether it goes on by itself. */
export const walking = signal(false);

/** Stages a second. */
const RATE = 0.8;

/** The two numbers beside an instant, and how far it is between them. */
export function between<T>(all: T[], instant: number): [T, T, number] | undefined {
  const first = Math.min(Math.floor(instant), all.length - 1);
  const [a, b] = [all[first], all[Math.min(first + 1, all.length - 1)]];
  return a === undefined || b === undefined ? undefined : [a, b, instant - first];
}

export const mixed = (a: number, b: number, share: number): number => a + (b - a) * share;

export function Lab({ lab }: { lab: Impact }) {
  const last = lab.motion.length - 1;
  if (at.peek() > last) at.value = last;
  useEffect(() => {
    // Another impact begins at its beginning.
    [at.value, walking.value] = [0, false];
  }, [doc.value.name]);
  useEffect(() => {
    if (!walking.value) return undefined;
    let [frame, before] = [0, performance.now()];
    const step = (now: number) => {
      at.value = Math.min(last, at.peek() + (RATE * (now - before)) / 1000);
      before = now;
      if (at.peek() < last) frame = requestAnimationFrame(step);
      else walking.value = false;
    };
    frame = requestAnimationFrame(step);
    return () => cancelAnimationFrame(frame);
  }, [walking.value, last]);
  return (
    <div class="lab" id="lab">
      <Sketch lab={lab} />
      <Walk lab={lab} />
    </div>
  );
}
