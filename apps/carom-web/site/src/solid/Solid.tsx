// A body in space: its motion in a view that can be turned, and its tilt against time.

import { useLayoutEffect, useRef } from "preact/hooks";
import { solidPlayer } from "../../../../../crates/carom-figure/src/solid.js";
import { shown } from "../state";

/** From where it is seen: this stays while the body changes. */
const view = {};

export function Solid() {
  const page = useRef<HTMLDivElement>(null);
  const { solid } = shown.value;
  useLayoutEffect(() => {
    if (page.current === null || solid === undefined) return;
    page.current.innerHTML = solid.player + solid.chart;
    // The rows of the strikes stand beside it.
    const studio = page.current.closest(".studio");
    if (studio !== null) solidPlayer(studio, solid.motion, view);
  }, [solid]);
  return <div class="in-space" ref={page} />;
}
