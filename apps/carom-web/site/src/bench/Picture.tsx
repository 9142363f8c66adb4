// The feeder to scale: its plates and its part can be dragged, the motion is played below.

import { signal, useSignal } from "@preact/signals";
import { useEffect, useLayoutEffect, useRef } from "preact/hooks";
import { type Player, player } from "../../../../../crates/carom-figure/src/player.js";
import type { Doc, Grip, Pair, Window } from "../engine/protocol";
import { metres, shifted, useFitting, ZOOM, Zoom, zoomed } from "../window";
import { polygon } from "../parts";
import { add, another, doc, drag, drop, engine, look, mayDiscard, moved, remove, restore, shown, size, whole, windowNow } from "../state";

/** Steps that values snap to: lengths [m] and angles [rad]; with shift ten times finer. */
const SNAP: Pair = [1e-3, Math.PI / 360];
const FINE: Pair = [1e-4, Math.PI / 3600];
/** The shortest stroke that draws something [px]. */
const LEAST = 12;

/** The player, for who wants to go to an instant. */
export const playing = signal<Player | undefined>(undefined);

interface Held {
  grip: Grip;
  from: Doc;
  window: Window;
  /** From the pointer to the grip [px]. */
  off: Pair;
}

export function Picture() {
  const picture = useRef<SVGSVGElement>(null);
  const scene = useRef<SVGGElement>(null);
  const root = useRef<HTMLDivElement>(null);
  const held = useRef<Held | undefined>(undefined);
  const pan = useRef<{ at: Pair; window: Window } | undefined>(undefined);
  const controlled = useRef("");
  const grabbed = useSignal(false);
  /** What the next stroke on the paper draws, and the stroke; of a part the corners, one by one. */
  const tool = useSignal<"plate" | "wall" | "part" | undefined>(undefined);
  const corners = useSignal<Pair[]>([]);
  const stroke = useSignal<[Pair, Pair] | undefined>(undefined);
  /** The plate or wall whose ring was held last. */
  const chosen = useSignal<{ obstacle: number; name: string } | undefined>(undefined);

  useEffect(() => {
    const escape = (event: KeyboardEvent) => {
      if (event.key !== "Escape") return;
      const dragged = held.current !== undefined;
      [held.current, pan.current, grabbed.value, tool.value, stroke.value, corners.value] = [undefined, undefined, false, undefined, undefined, []];
      if (dragged) void engine.idle().then(restore);
    };
    addEventListener("keydown", escape);
    return () => removeEventListener("keydown", escape);
  }, []);

  useFitting(picture);
  useEffect(() => {
    [chosen.value, tool.value, corners.value] = [undefined, undefined, []];
  }, [doc.value.name]);
  useEffect(() => () => (playing.value = undefined), []);

  const { seen } = shown.value;
  const controls = whole.value.controls ?? "";
  // Before the frame, not after it: the path is shown with the pointer.
  useLayoutEffect(() => {
    const page = root.current?.closest(".studio");
    if (seen === undefined || scene.current === null || controls === "" || page == null) return;
    scene.current.innerHTML = seen.scene;
    // Other controls want a player of their own.
    if (controlled.current !== controls) playing.value = player(page);
    controlled.current = controls;
    playing.peek()?.load(seen.motion);
    // Seen in the browser's own tools: from the pointer to the path that the next frame shows.
    if (moved.at > 0) performance.measure("carom-path", { start: moved.at });
    moved.at = 0;
  }, [seen, controls]);

  const place = (event: PointerEvent | WheelEvent): Pair => {
    const box = picture.current?.getBoundingClientRect();
    return [event.clientX - (box?.left ?? 0), event.clientY - (box?.top ?? 0)];
  };

  const grab = (event: PointerEvent, grip: Grip) => {
    const window = windowNow();
    if (window === undefined) return;
    event.stopPropagation();
    if (tool.value !== undefined || !mayDiscard()) return;
    const { obstacle } = grip.held;
    chosen.value = obstacle === null ? undefined : { obstacle, name: grip.label.split(",")[0] ?? "" };
    const [x, y] = place(event);
    held.current = { grip, from: doc.peek(), window, off: [grip.at[0] - x, grip.at[1] - y] };
    picture.current?.setPointerCapture(event.pointerId);
    grabbed.value = true;
  };

  const move = (event: PointerEvent) => {
    const [x, y] = place(event);
    if (stroke.value !== undefined) {
      stroke.value = [stroke.value[0], [x, y]];
    } else if (held.current !== undefined) {
      const { grip, from, window, off } = held.current;
      const to = metres(window, [x + off[0], y + off[1]]);
      drag(from, { drag: { grip: grip.held, to, snap: event.shiftKey ? FINE : SNAP } });
    } else if (pan.current !== undefined) {
      const { at, window } = pan.current;
      look(shifted(window, [x - at[0], y - at[1]]));
    }
  };

  /** What was drawn becomes a plate or a wall; a mere click draws nothing. */
  const drawn = async (table: "plate" | "wall", [from, to]: [Pair, Pair]) => {
    const window = windowNow();
    [tool.value, stroke.value] = [undefined, undefined];
    if (window === undefined || Math.hypot(to[0] - from[0], to[1] - from[1]) < LEAST) return;
    await add(table, metres(window, from), metres(window, to), SNAP[0]);
  };

  /** By the keyboard a plate or wall comes to the middle of the picture, to be moved from there. */
  const take = (table: "plate" | "wall", event: MouseEvent) => {
    const [w, h] = size.peek();
    const half: Pair = table === "plate" ? [60, 25] : [0, 60];
    if (event.detail === 0) void drawn(table, [[w / 2 - half[0], h / 2 - half[1]], [w / 2 + half[0], h / 2 + half[1]]]);
    else tool.value = tool.value === table ? undefined : table;
  };

  /** One more corner of the part; the first one again closes its outline. */
  const corner = async (at: Pair) => {
    const first = corners.value[0];
    const closes = first !== undefined && Math.hypot(at[0] - first[0], at[1] - first[1]) < LEAST;
    if (!closes) {
      corners.value = [...corners.value, at];
      return;
    }
    const window = windowNow();
    const outline = corners.value;
    [tool.value, corners.value] = [undefined, []];
    if (window !== undefined && outline.length > 2) await another(polygon(outline.map((place) => metres(window, place))));
  };

  const release = () => {
    if (stroke.value !== undefined && (tool.value === "plate" || tool.value === "wall")) {
      void drawn(tool.value, stroke.value);
      return;
    }
    const { current } = held;
    [held.current, pan.current, grabbed.value] = [undefined, undefined, false];
    if (current !== undefined) void drop(current.from);
  };

  const push = async (event: KeyboardEvent, grip: Grip) => {
    const step: Record<string, Pair> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
    const [way, window] = [step[event.key], windowNow()];
    if (way === undefined || window === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    const snap = event.shiftKey ? FINE : SNAP;
    const pixels = 2 * snap[0] * window.scale;
    const to = metres(window, [grip.at[0] + way[0] * pixels, grip.at[1] + way[1] * pixels]);
    const from = doc.peek();
    drag(from, { drag: { grip: grip.held, to, snap } });
    await drop(from);
  };

  const [width, height] = shown.value.window?.size ?? size.value;
  const grips = seen?.grips ?? [];
  const drawable = shown.value.kind === "scene";
  return (
    <div class="player" id="player" ref={root} role="group" aria-label="The feeder and its part">
      <div class={`paper${grabbed.value ? " grabbed" : ""}${tool.value === undefined ? "" : " drawing"}`}>
        <svg
          ref={picture}
          class="fig scene layout"
          viewBox={`0 0 ${width} ${height}`}
          width={width}
          height={height}
          aria-label={seen?.words ?? "The feeder"}
          role="group"
          onPointerDown={(event) => {
            const window = windowNow();
            if (window === undefined) return;
            if (tool.value === "part") {
              void corner(place(event));
              return;
            }
            if (tool.value === undefined) pan.current = { at: place(event), window };
            else stroke.value = [place(event), place(event)];
            event.currentTarget.setPointerCapture(event.pointerId);
          }}
          onPointerMove={move}
          onPointerUp={release}
          onPointerCancel={release}
          onWheel={(event) => {
            const window = windowNow();
            if (window === undefined) return;
            event.preventDefault();
            look(zoomed(window, event.deltaY < 0 ? ZOOM : 1 / ZOOM, place(event)));
          }}
        >
          <g ref={scene} aria-hidden="true" />
          {stroke.value !== undefined && (
            <line class="stroke" x1={stroke.value[0][0]} y1={stroke.value[0][1]} x2={stroke.value[1][0]} y2={stroke.value[1][1]} />
          )}
          {corners.value.length > 0 && (
            <g class="outline-drawn">
              <polyline class="stroke" points={corners.value.map((at) => at.join(",")).join(" ")} />
              <circle class="grip" cx={corners.value[0]?.[0]} cy={corners.value[0]?.[1]} r={LEAST} />
            </g>
          )}
          <g class="grips">
            {grips.map((grip) => (
              <circle
                key={`${grip.held.obstacle}-${grip.held.hold}`}
                class={`grip ${grip.held.hold}`}
                data-grip={`${grip.held.obstacle ?? "part"}-${grip.held.hold}`}
                cx={grip.at[0]}
                cy={grip.at[1]}
                r={grip.held.hold === "middle" ? 8 : 6}
                tabindex={0}
                role="button"
                aria-label={`Move ${grip.label} with the arrow keys`}
                onFocus={() => {
                  const { obstacle } = grip.held;
                  if (obstacle !== null) chosen.value = { obstacle, name: grip.label.split(",")[0] ?? "" };
                }}
                onPointerDown={(event) => grab(event, grip)}
                onKeyDown={(event) => void push(event, grip)}
              >
                <title>
                  {grip.label}: drag it, or use the arrow keys (shift: finer). It changes {grip.moves.join(", ")}.
                </title>
              </circle>
            ))}
          </g>
        </svg>
        <div class="tools">
          {drawable && (["plate", "wall"] as const).map((table) => (
            <button
              key={table}
              type="button"
              id={`add-${table}`}
              aria-pressed={tool.value === table}
              title={`Then draw the ${table} on the paper, from one end to the other`}
              onClick={(event) => take(table, event)}
            >
              + {table}
            </button>
          ))}
          {drawable && (
            <button
              type="button"
              id="draw-part"
              aria-pressed={tool.value === "part"}
              title="Then click its corners on the paper, and the first one again. By the keyboard: write vertices into the file."
              onClick={() => ([tool.value, corners.value] = [tool.value === "part" ? undefined : "part", []])}
            >
              Draw the part
            </button>
          )}
          {tool.value === "part" && <span class="note">{corners.value.length < 3 ? "click its corners" : "click the first corner again to close it"}</span>}
          {chosen.value !== undefined && (
            <button type="button" id="remove" onClick={() => chosen.value !== undefined && void remove(chosen.value.obstacle).then(() => (chosen.value = undefined))}>
              Remove {chosen.value.name}
            </button>
          )}
        </div>
        <Zoom />
      </div>
      <div class="clockwork" dangerouslySetInnerHTML={{ __html: controls }} />
    </div>
  );
}
