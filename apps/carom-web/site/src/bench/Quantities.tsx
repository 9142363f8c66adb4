// Every number of the scene: with unit and tolerance as it is written, and how far it may move before the verdict flips.

import { useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import type { Doc, Limit, Quantity } from "../engine/protocol";
import { PARTS } from "../parts";
import { Wrong } from "../Problems";
import { another, broken, doc, failure, type Found, limits, moveTo, preview, typed, whole, write } from "../state";

/** The table that a quantity belongs to, and its key there. */
function split({ path, label }: Quantity): [string, string] {
  const [group, own] = label.split(": ");
  if (group !== undefined && own !== undefined) return [group, own];
  const parts = path.split(".");
  const head = parts[0] ?? "";
  if (parts.length === 1) return [whole.value.kind ?? "scene", path.replaceAll("_", " ")];
  const named = head === "plate" || head === "wall";
  const table = named ? parts.slice(0, 2).join(" ") : head;
  return [table, parts.slice(named ? 2 : 1).join(" ").replaceAll("_", " ")];
}

/** Limits and tolerances are a scene's. */
const ofScene = (): boolean => (whole.value.kind ?? "scene") === "scene";

function groups(quantities: Quantity[]): [string, Quantity[]][] {
  const found = new Map<string, Quantity[]>();
  for (const quantity of quantities) {
    const [table] = split(quantity);
    found.set(table, [...(found.get(table) ?? []), quantity]);
  }
  return [...found];
}

/** A typed number one step further. */
function stepped(text: string, by: number): string {
  return text.replace(/-?\d+(\.\d+)?/, (number) => {
    const digits = number.split(".")[1]?.length ?? 0;
    return (Number(number) + by).toFixed(Math.max(digits, by % 1 === 0 ? 0 : 2));
  });
}

const shownNumber = (quantity: Quantity, value: number): string => `${Number((value / quantity.si).toPrecision(5))} ${quantity.unit}`;

function limitWords(quantity: Quantity, limit: Limit): string {
  const low = limit.low_end === "flips" ? `flips below ${shownNumber(quantity, limit.low_kept)}` : "does not flip below";
  const high = limit.high_end === "flips" ? `flips above ${shownNumber(quantity, limit.high_kept)}` : "does not flip above";
  return `${low}, ${high}`;
}

/** What a slider reaches: beyond each end at which the verdict flips a little, and never beyond what can be drawn. */
function reach(quantity: Quantity, { limit, value }: Found): [number, number] {
  const flips = [limit.low_end === "flips" ? value - limit.low_kept : 0, limit.high_end === "flips" ? limit.high_kept - value : 0];
  const usual = Math.max(flips[0] ?? 0, flips[1] ?? 0, 0.5 * Math.abs(value)) || 0.1;
  const end = (sign: 1 | -1, how: Limit["low_end"], kept: number) => {
    if (how === "no_such_feeder") return Math.abs(kept - value) < 4 * usual ? kept : value + sign * 2 * usual;
    if (how === "flips") return kept + sign * 0.3 * Math.max(Math.abs(kept - value), 0.1 * usual);
    return value + sign * usual;
  };
  const [least, most] = quantity.allowed;
  return [
    Math.max(end(-1, limit.low_end, limit.low_kept), least ?? Number.NEGATIVE_INFINITY),
    Math.min(end(1, limit.high_end, limit.high_kept), most ?? Number.POSITIVE_INFINITY),
  ];
}

/** The zone in which the verdict holds, green; beyond it red where it flips, grey where nothing can be drawn or was searched. */
function Zone({ quantity, found }: { quantity: Quantity; found: Found }) {
  const { limit } = found;
  const [low, high] = reach(quantity, found);
  const share = (at: number) => (high > low ? Math.min(100, Math.max(0, (100 * (at - low)) / (high - low))) : 0);
  const [holds, ends] = [share(limit.low_kept), share(limit.high_kept)];
  const stale = found.text !== doc.value.text;
  return (
    <div class={`zone${stale ? " stale" : ""}`}>
      <svg viewBox="0 0 100 6" preserveAspectRatio="none" aria-hidden="true">
        <rect class={limit.low_end === "flips" ? "flips" : "open"} x="0" y="1" width={holds} height="4" />
        <rect class="holds" x={holds} y="1" width={Math.max(0, ends - holds)} height="4" />
        <rect class={limit.high_end === "flips" ? "flips" : "open"} x={ends} y="1" width={Math.max(0, 100 - ends)} height="4" />
      </svg>
      <Thumb quantity={quantity} ends={[low, high]} digits={4} words={limitWords(quantity, limit)} />
    </div>
  );
}

/** What a slider says, to so many digits in the unit of drawings, SI. The engine writes it in the unit that the file has. */
function valueAt(quantity: Quantity, input: HTMLInputElement, digits: number): Record<string, number> {
  return { [quantity.path]: Number((Number(input.value) / quantity.si).toPrecision(digits)) * quantity.si };
}

/** What a slider without limits reaches: the interval that is allowed, or as much again on both sides. */
function around({ value, allowed: [least, most], si, unit }: Quantity): [number, number] {
  const span = unit === "" ? Math.max(Math.abs(value), 0.5) : Math.abs(value) || si;
  return [Math.max(value - span, least ?? Number.NEGATIVE_INFINITY), Math.min(value + span, most ?? Number.POSITIVE_INFINITY)];
}

/** A slider between two ends: what comes of it is shown at once, and written when it is let go. `held` hears whether it is moved. */
function Thumb(props: { quantity: Quantity; ends: [number, number]; digits: number; words: string; held?: (held: boolean) => void }) {
  const { quantity, ends: [low, high], digits, words, held = () => undefined } = props;
  const from = useRef<Doc | undefined>(undefined);
  return (
    <input
      type="range"
      min={low}
      max={high}
      step={(high - low) / 400}
      value={quantity.value}
      aria-label={`${quantity.label}: ${words}`}
      title={words}
      onInput={(event) => {
        held(true);
        from.current ??= doc.peek();
        preview(from.current, valueAt(quantity, event.currentTarget, digits));
      }}
      onChange={(event) => {
        held(false);
        from.current = undefined;
        void moveTo(valueAt(quantity, event.currentTarget, digits), quantity.path);
      }}
    />
  );
}

/** A slider of a value without limits. */
function Slider({ quantity }: { quantity: Quantity }) {
  const held = useRef(false);
  const ends = useRef<[number, number]>([0, 1]);
  // While it is moved its ends stay.
  if (!held.current) ends.current = around(quantity);
  return (
    <div class="zone plain">
      <Thumb quantity={quantity} ends={ends.current} digits={3} words={quantity.about} held={(now) => (held.current = now)} />
    </div>
  );
}

function Field({ quantity }: { quantity: Quantity }) {
  const { path, text, written } = quantity;
  const draft = useSignal(text);
  // What is being typed stays, whatever answer comes meanwhile.
  const typing = useRef(false);
  useEffect(() => {
    if (!typing.current && failure.peek()?.tried !== path) draft.value = text;
  }, [text, doc.value.text]);
  const wrong = failure.value?.tried === path ? failure.value : undefined;
  const found = limits.value.get(path);
  const keep = (value: string) => {
    typing.current = false;
    // An emptied field takes back what it had, or where the file may leave it out its line goes.
    const goes = value.trim() === "" && !ofScene();
    draft.value = value.trim() === "" && !goes ? text : value;
    if ((goes || value.trim() !== "") && value.trim() !== text) void write(path, value);
    // What the file has already is right again.
    else if (failure.peek()?.tried === path) failure.value = undefined;
  };
  const id = `quantity-${path}`;
  return (
    <div class={`quantity${written ? "" : " default"}`}>
      <label for={id} title={quantity.about}>
        {split(quantity)[1]}
      </label>
      {quantity.choices.length > 0 ? (
        <select id={id} value={text} onChange={(event) => void write(path, event.currentTarget.value)}>
          {quantity.choices.map((word) => (
            <option key={word}>{word}</option>
          ))}
        </select>
      ) : (
        <input
          id={id}
          value={draft}
          spellcheck={false}
          autocomplete="off"
          aria-invalid={wrong !== undefined}
          aria-describedby={wrong === undefined ? undefined : `${id}-wrong`}
          onInput={(event) => {
            typing.current = true;
            draft.value = event.currentTarget.value;
          }}
          onBlur={(event) => keep(event.currentTarget.value)}
          onKeyDown={(event) => {
            if (event.key === "Enter") keep(event.currentTarget.value);
            if (event.key === "Escape") [typing.current, draft.value] = [false, text];
            const by = { ArrowUp: 1, ArrowDown: -1 }[event.key];
            if (by === undefined || !quantity.number || text.startsWith("{")) return;
            event.preventDefault();
            const step = quantity.unit === "" ? 0.01 : 1;
            keep(stepped(event.currentTarget.value, by * step * (event.shiftKey ? 10 : 1)));
          }}
        />
      )}
      {found !== undefined && <Zone quantity={quantity} found={found} />}
      {!ofScene() && quantity.number && written && !text.startsWith("{") && <Slider quantity={quantity} />}
      <Wrong failure={wrong} id={`${id}-wrong`} own={path} />
    </div>
  );
}

/** Another kind of part, to begin with. */
function Kind() {
  const wrong = failure.value?.tried === "part" ? failure.value : undefined;
  return (
    <div class="quantity">
      <label for="part-kind">kind</label>
      <select
        id="part-kind"
        value=""
        onChange={(event) => {
          const lines = PARTS[Number(event.currentTarget.value)]?.[1];
          event.currentTarget.value = "";
          if (lines !== undefined) void another(lines);
        }}
      >
        <option value="">another part …</option>
        {PARTS.map(([label], number) => (
          <option key={label} value={number}>
            {label}
          </option>
        ))}
      </select>
      <Wrong failure={wrong} />
    </div>
  );
}

/** The scene as its file has it: what is typed counts after a moment. */
function Source() {
  const draft = useSignal(doc.value.text);
  const later = useRef<ReturnType<typeof setTimeout> | undefined>(undefined);
  const box = useRef<HTMLDetailsElement>(null);
  const shownText = broken.value ?? doc.value.text;
  const wrong = broken.value !== undefined;
  useEffect(() => {
    // Text with problems is seen; it is closed again by who reads it.
    if (wrong && box.current !== null) box.current.open = true;
  }, [wrong]);
  useEffect(() => {
    draft.value = shownText;
  }, [shownText]);
  const now = (text: string) => {
    clearTimeout(later.current);
    if (text !== shownText) void typed(text);
  };
  return (
    <details class="source" ref={box}>
      <summary>The file as text</summary>
      <textarea
        aria-label="The file as text"
        spellcheck={false}
        rows={18}
        value={draft}
        aria-invalid={wrong}
        onInput={(event) => {
          const text = event.currentTarget.value;
          draft.value = text;
          clearTimeout(later.current);
          later.current = setTimeout(() => now(text), 700);
        }}
        onBlur={(event) => now(event.currentTarget.value)}
      />
    </details>
  );
}

export function Quantities() {
  const quantities = whole.value.quantities ?? [];
  return (
    <section class="quantities" aria-label="Quantities">
      {groups(quantities).map(([table, own]) => (
        <fieldset key={table}>
          <legend>{table}</legend>
          {table === "part" && ofScene() && <Kind />}
          {own.map((quantity) => (
            <Field key={quantity.path} quantity={quantity} />
          ))}
        </fieldset>
      ))}
      {!ofScene() && <p class="note">Pale values count where nothing else in the file says them.</p>}
      {ofScene() && <p class="note">
        Green: the verdict stays while this quantity moves alone. Red: it flips; further away it may hold again. Grey: nothing can be drawn there,
        or it was not searched. Pale values are defaults that the file does not write.
      </p>}
      <Source />
    </section>
  );
}
