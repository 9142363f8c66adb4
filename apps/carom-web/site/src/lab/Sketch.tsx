// What is struck, to scale: contacts, normals and velocities can be pulled. How the bodies move is drawn as the walk goes on.

import { useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import type { Doc, Lab, LabGrip, Pair } from "../engine/protocol";
import { addContact, doc, drag, drop, engine, look, mayDiscard, removeContact, restore, shown, size, windowNow } from "../state";
import { shifted, useFitting, ZOOM, Zoom, zoomed } from "../window";
import { at, between, mixed } from "./Lab";

/** The head of an arrow: its length and half its width [px]. */
const HEAD: Pair = [10, 4.2];
/** A key moves a grip so far [px]. */
const PUSH: Pair = [4, 20];
const DIGITS = 3;
const NOISE = 1e-12;

function Arrow({ from, by }: { from: Pair; by: Pair }) {
  const length = Math.hypot(...by);
  if (length < 1) return null;
  const [x, y]: Pair = [by[0] / length, by[1] / length];
  const [tip, foot]: [Pair, Pair] = [
    [from[0] + by[0], from[1] + by[1]],
    [from[0] + by[0] - HEAD[0] * x, from[1] + by[1] - HEAD[0] * y],
  ];
  const aside: Pair = [-y * HEAD[1], x * HEAD[1]];
  return (
    <>
      <line class="shaft" x1={from[0]} y1={from[1]} x2={foot[0]} y2={foot[1]} />
      <path class="tip" d={`M${tip.join(" ")}L${foot[0] + aside[0]} ${foot[1] + aside[1]}L${foot[0] - aside[0]} ${foot[1] - aside[1]}Z`} />
    </>
  );
}

/** Velocity and spin of each body at this instant of the walk. */
function Moving({ lab, speed }: { lab: Lab; speed: number }) {
  const now = between(lab.motion, at.value);
  if (now === undefined) return null;
  const [before, after, share] = now;
  // What is so small beside the largest of the walk is what rounding left.
  const largest = (k: number[]) => Math.max(...lab.motion.flat().flatMap((body) => k.map((i) => Math.abs(body[i] ?? 0))));
  const [least, leastSpin] = [NOISE * largest([0, 1]), NOISE * largest([2])];
  return (
    <g class="velocity-arrow" aria-hidden="true">
      {lab.centres.map((centre, body) => {
        const [a, b] = [before[body], after[body]];
        if (a === undefined || b === undefined) return null;
        const [vx, vy, spin] = [0, 1, 2].map((k) => mixed(a[k] ?? 0, b[k] ?? 0, share)) as [number, number, number];
        const by: Pair = [vx * speed, -vy * speed];
        const size = Math.hypot(vx, vy);
        const turn = Math.abs(spin) <= leastSpin ? "" : `${spin > 0 ? "↺" : "↻"} ${Math.abs(spin).toPrecision(DIGITS)} 1/s`;
        return (
          <g key={body}>
            <Arrow from={centre} by={by} />
            <text class="velocity-name" x={centre[0] + by[0] + (by[0] < 0 ? -10 : 10)} y={centre[1] + by[1] + (by[1] > 0 ? 16 : -6)} text-anchor={by[0] < 0 ? "end" : "start"}>
              {size <= least ? "" : `${size.toPrecision(DIGITS)} m/s`}
            </text>
            <text class="velocity-name" x={centre[0] - 12} y={centre[1] + 18} text-anchor="end">
              {turn}
            </text>
          </g>
        );
      })}
    </g>
  );
}

export function Sketch({ lab }: { lab: Lab }) {
  const picture = useRef<SVGSVGElement>(null);
  const held = useRef<{ grip: LabGrip; from: Doc; off: Pair } | undefined>(undefined);
  const pan = useRef<{ at: Pair; window: NonNullable<ReturnType<typeof windowNow>> } | undefined>(undefined);
  const adding = useSignal(false);
  /** The contact whose ring was held last. */
  const chosen = useSignal<number | undefined>(undefined);
  useFitting(picture);
  useEffect(() => {
    [chosen.value, adding.value] = [undefined, false];
  }, [doc.value.name]);
  useEffect(() => {
    const escape = (event: KeyboardEvent) => {
      if (event.key !== "Escape") return;
      const dragged = held.current !== undefined;
      [held.current, pan.current, adding.value] = [undefined, undefined, false];
      if (dragged) void engine.idle().then(restore);
    };
    addEventListener("keydown", escape);
    return () => removeEventListener("keydown", escape);
  }, []);

  const place = (event: PointerEvent | WheelEvent): Pair => {
    const box = picture.current?.getBoundingClientRect();
    return [event.clientX - (box?.left ?? 0), event.clientY - (box?.top ?? 0)];
  };
  const grab = (event: PointerEvent, grip: LabGrip) => {
    event.stopPropagation();
    if (adding.value || !mayDiscard()) return;
    chosen.value = grip.contact ?? undefined;
    const [x, y] = place(event);
    held.current = { grip, from: doc.peek(), off: [grip.at[0] - x, grip.at[1] - y] };
    at.value = 0;
    picture.current?.setPointerCapture(event.pointerId);
  };
  const move = (event: PointerEvent) => {
    const [x, y] = place(event);
    if (held.current !== undefined) {
      const { grip, from, off } = held.current;
      drag(from, { pull: { pulled: grip.pulled, at: [x + off[0], y + off[1]], fine: event.shiftKey } });
    } else if (pan.current !== undefined) {
      look(shifted(pan.current.window, [x - pan.current.at[0], y - pan.current.at[1]]));
    }
  };
  const release = () => {
    const { current } = held;
    [held.current, pan.current] = [undefined, undefined];
    if (current !== undefined) void drop(current.from);
  };
  const push = async (event: KeyboardEvent, grip: LabGrip) => {
    const step: Record<string, Pair> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
    const way = step[event.key];
    if (way === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    const by = PUSH[event.shiftKey ? 0 : 1];
    const from = doc.peek();
    drag(from, { pull: { pulled: grip.pulled, at: [grip.at[0] + way[0] * by, grip.at[1] + way[1] * by], fine: event.shiftKey } });
    await drop(from);
  };
  const gone = async () => {
    if (chosen.value !== undefined && (await removeContact(chosen.value))) chosen.value = undefined;
  };

  const removable = lab.grips.find(({ contact, pulled }) => contact === chosen.value && pulled.key === "point");
  const window = shown.value.window;
  const [width, height] = window?.size ?? size.value;
  return (
    <div class={`paper${adding.value ? " drawing" : ""}`}>
      <svg
        ref={picture}
        class="fig sketch"
        viewBox={`0 0 ${width} ${height}`}
        width={width}
        height={height}
        role="group"
        aria-label={lab.words}
        onPointerDown={(event) => {
          const now = windowNow();
          if (now === undefined) return;
          if (adding.value) {
            [adding.value, chosen.value] = [false, undefined];
            void addContact(place(event));
          } else {
            pan.current = { at: place(event), window: now };
            event.currentTarget.setPointerCapture(event.pointerId);
          }
        }}
        onPointerMove={move}
        onPointerUp={release}
        onPointerCancel={release}
        onWheel={(event) => {
          const now = windowNow();
          if (now === undefined) return;
          event.preventDefault();
          look(zoomed(now, event.deltaY < 0 ? ZOOM : 1 / ZOOM, place(event)));
        }}
      >
        <g aria-hidden="true" dangerouslySetInnerHTML={{ __html: lab.sketch }} />
        <Moving lab={lab} speed={window?.speed ?? 0} />
        <g class="grips">
          {lab.grips.filter(({ pulled }) => pulled.key !== "velocity" || at.value === 0).map((grip) => (
            <circle
              key={`${grip.pulled.table}-${grip.pulled.key}`}
              class={`grip ${grip.pulled.key}`}
              data-grip={`${grip.pulled.table}-${grip.pulled.key}`}
              cx={grip.at[0]}
              cy={grip.at[1]}
              r={grip.pulled.key === "normal" ? 6 : 8}
              tabindex={0}
              role="button"
              aria-label={`Move the ${grip.label} with the arrow keys`}
              onFocus={() => (chosen.value = grip.contact ?? undefined)}
              onPointerDown={(event) => grab(event, grip)}
              onKeyDown={(event) => void push(event, grip)}
            >
              <title>{grip.label}: pull it, or use the arrow keys (shift: finer).</title>
            </circle>
          ))}
        </g>
      </svg>
      {lab.sketch === "" && <p class="note over">{lab.unseen}</p>}
      <div class="tools">
        <button
          type="button"
          disabled={lab.centres.length !== 1}
          id="add-contact"
          aria-pressed={adding.value}
          title="Then click the place where the body is touched"
          onClick={(event) => {
            // By the keyboard it comes below the middle, to be moved from there.
            if (event.detail === 0) void addContact([width / 2, height * 0.7]);
            else adding.value = !adding.value;
          }}
        >
          + contact
        </button>
        {removable !== undefined && (
          <button type="button" id="remove" onClick={() => void gone()}>
            Remove {removable.label}
          </button>
        )}
      </div>
      <Zoom />
    </div>
  );
}
