// How a drop ends over two quantities: boundaries sharpen as they come; the outcome under the pointer is computed there and then.

import { signal, useSignal, useSignalEffect } from "@preact/signals";
import { Engine, EngineDied } from "../engine/engine";
import type { Doc, Pair, Quantity, Side } from "../engine/protocol";
import { Team } from "../engine/team";
import { rangeOf } from "../ranges";
import { Work } from "../Work";
import { doc, moveTo, whole } from "../state";
import { tab } from "../tabs";

/** Cells of an axis, halvings of a cell and accuracy, each finer than the one before. */
const LEVELS = [
  { cells: 12, depth: 0, accuracy: 1e-3 },
  { cells: 32, depth: 2, accuracy: 1e-4 },
  { cells: 80, depth: 3, accuracy: 1e-6 },
];

interface Drawn {
  html: string;
  axes: [Side, Side];
  of: Doc;
  level: number;
}

const drawer = new Team();
const asker = new Engine("carom-whole.wasm");
const drawn = signal<Drawn | undefined>(undefined);
const running = signal(false);
const wrong = signal("");
const there = signal("");

async function draw(axes: [Side, Side]): Promise<void> {
  const of = doc.peek();
  drawer.stop();
  [running.value, wrong.value, there.value] = [true, "", ""];
  try {
    for (const [level, { cells, depth, accuracy }] of LEVELS.entries()) {
      const reply = await drawer.study(of, { map: { axes, cells, depth, accuracy } });
      if (reply.failure !== undefined) {
        wrong.value = [reply.failure.message, ...reply.failure.problems.map(({ message }) => message)].join(": ");
        break;
      }
      drawn.value = { html: reply.html ?? "", axes, of, level };
    }
  } catch (error) {
    // Who stopped it says what runs now.
    if (error instanceof EngineDied && error.message === "stopped") return;
    wrong.value = String(error);
  }
  running.value = false;
}

function stop(): void {
  drawer.stop();
  running.value = false;
}

/** The values under a pointer, SI; undefined outside of the plane. */
function valuesAt(event: MouseEvent): Record<string, number> | undefined {
  const plane = (event.currentTarget as Element).querySelector("rect.axis")?.getBoundingClientRect();
  const now = drawn.peek();
  if (plane === undefined || now === undefined) return undefined;
  const shares: Pair = [(event.clientX - plane.left) / plane.width, (plane.bottom - event.clientY) / plane.height];
  if (shares.some((share) => share < 0 || share > 1)) return undefined;
  const value = ({ from, to }: Side, share: number) => from + share * (to - from);
  return { [now.axes[0].path]: value(now.axes[0], shares[0]), [now.axes[1].path]: value(now.axes[1], shares[1]) };
}

function quantityOf(path: string): Quantity | undefined {
  return whole.peek().quantities?.find((quantity) => quantity.path === path);
}

const shownValue = (path: string, value: number): string => {
  const quantity = quantityOf(path);
  return `${Number((value / (quantity?.si ?? 1)).toPrecision(4))} ${quantity?.unit ?? ""}`.trim();
};

function hover(event: MouseEvent): void {
  const [values, now] = [valuesAt(event), drawn.peek()];
  if (values === undefined || now === undefined) return;
  const where = Object.entries(values)
    .map(([path, value]) => `${quantityOf(path)?.label ?? path} ${shownValue(path, value)}`)
    .join(", ");
  asker.latest(
    now.of,
    { study: { at: { values } } },
    ({ headline, failure }) => {
      const what = headline === undefined ? (failure?.problems[0]?.message ?? failure?.message ?? "") : `${headline.word}${headline.plate === null ? "" : ` on “${headline.plate}”`}`;
      there.value = `${where}: ${what}`;
    },
    () => (there.value = where),
  );
}

async function load(event: MouseEvent): Promise<void> {
  const values = valuesAt(event);
  if (values === undefined) return;
  // As many digits as a pixel tells.
  const short = Object.fromEntries(
    Object.entries(values).map(([path, value]) => {
      const si = quantityOf(path)?.si ?? 1;
      return [path, Number((value / si).toPrecision(4)) * si];
    }),
  );
  if (await moveTo(short)) tab.value = "motion";
}

function AxisField({ name, chosen, ends, onChange }: { name: string; chosen: string; ends: [string, string]; onChange: (path: string, ends: [string, string]) => void }) {
  const quantities = (whole.value.quantities ?? []).filter(({ number }) => number);
  const unit = quantities.find(({ path }) => path === chosen)?.unit ?? "";
  const pick = (path: string) => {
    const quantity = quantities.find((one) => one.path === path);
    if (quantity === undefined) return;
    const [from, to] = rangeOf(quantity).map((end) => String(Number((end / quantity.si).toPrecision(3))));
    onChange(path, [from ?? "", to ?? ""]);
  };
  return (
    <p class="controls">
      <label>
        {name}{" "}
        <select id={`map-${name}`} value={chosen} onChange={(event) => pick(event.currentTarget.value)}>
          <option value="">choose a quantity</option>
          {quantities.map(({ path, label }) => (
            <option key={path} value={path}>
              {label}
            </option>
          ))}
        </select>
      </label>
      <label>
        from <input value={ends[0]} onChange={(event) => onChange(chosen, [event.currentTarget.value, ends[1]])} />
      </label>
      <label>
        to <input value={ends[1]} onChange={(event) => onChange(chosen, [ends[0], event.currentTarget.value])} />
      </label>
      <span>{unit}</span>
    </p>
  );
}

export function MapView() {
  const sides = [useSignal<[string, [string, string]]>(["", ["", ""]]), useSignal<[string, [string, string]]>(["", ["", ""]])] as const;
  useSignalEffect(() => {
    if (drawn.peek() !== undefined && drawn.peek()?.of.text !== doc.value.text && running.peek()) stop();
  });
  const read = (): [Side, Side] | undefined => {
    const [x, y] = sides.map(({ value: [path, ends] }): Side | undefined => {
      const si = quantityOf(path)?.si ?? 1;
      const [from, to] = ends.map((end) => Number(end) * si);
      return path === "" || from === undefined || to === undefined || !(from < to) ? undefined : { path, from, to };
    });
    return x === undefined || y === undefined || x.path === y.path ? undefined : [x, y];
  };
  const axes = read();
  const now = drawn.value;
  const old = now !== undefined && now.of.text !== doc.value.text;
  return (
    <section class="map" aria-label="Map">
      {(["x", "y"] as const).map((name, k) => {
        const side = sides[k === 0 ? 0 : 1];
        return (
          <AxisField key={name} name={name} chosen={side.value[0]} ends={side.value[1]} onChange={(path, ends) => (side.value = [path, ends])} />
        );
      })}
      <p class="controls">
        <Work id="map-draw" label="Draw the map" running={running.value} disabled={axes === undefined} begin={() => axes !== undefined && void draw(axes)} stop={stop}>
          {running.value && `${now?.level === undefined ? "first" : "finer"} boundaries …`}
          {!running.value && axes === undefined && "choose two different quantities, and plain numbers with the first below the second"}
          {!running.value && axes !== undefined && now !== undefined && JSON.stringify(now.axes) !== JSON.stringify(axes) && "the map below is of other axes; "}
          {!running.value && now !== undefined && `drawn on ${LEVELS[now.level]?.cells} cells a side${old ? ", of the file before" : ""}`}
        </Work>
      </p>
      {wrong.value !== "" && (
        <p class="note warn" role="alert">
          {wrong}
        </p>
      )}
      {now === undefined && <p class="note">Choose two quantities. The map shows how it ends over them; a click takes the values under the pointer.</p>}
      <p class="there" aria-live="polite">
        {there}
      </p>
      {now !== undefined && (
        <div id="map-picture" onMouseMove={hover} onClick={(event) => void load(event)} dangerouslySetInnerHTML={{ __html: now.html }} />
      )}
    </section>
  );
}
