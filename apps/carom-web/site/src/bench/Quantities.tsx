// Every number of the scene: with unit and tolerance as it is written, and how far it may move before the verdict flips.

import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import type { Limit, Quantity } from "../engine/protocol";
import { PARTS } from "../parts";
import { another, doc, failure, limits, typed, whole, write } from "../state";

/** The table that a path belongs to, and its key there. */
function split(path: string): [string, string] {
  const parts = path.split(".");
  const head = parts[0] ?? "";
  if (parts.length === 1) return ["scene", path];
  const named = head === "plate" || head === "wall";
  const table = named ? parts.slice(0, 2).join(" ") : head;
  return [table, parts.slice(named ? 2 : 1).join(" ").replaceAll("_", " ")];
}

function groups(quantities: Quantity[]): [string, Quantity[]][] {
  const found = new Map<string, Quantity[]>();
  for (const quantity of quantities) {
    const [table] = split(quantity.path);
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

/** The zone in which the verdict holds, green; beyond it red where it flips, grey where nothing can be drawn or was searched. */
function Zone({ quantity, limit }: { quantity: Quantity; limit: Limit }) {
  const { value } = quantity;
  const flips = [limit.low_end === "flips", limit.high_end === "flips"];
  const reach = Math.max(value - limit.low_kept, 0.05 * Math.abs(value), 1e-9);
  const ahead = Math.min(Math.max(limit.high_kept - value, 0.05 * Math.abs(value), 1e-9), 4 * Math.max(reach, Math.abs(value)));
  const [from, to] = [value - 1.25 * reach, value + 1.25 * ahead];
  const share = (at: number) => Math.min(100, Math.max(0, (100 * (at - from)) / (to - from)));
  const [low, high] = [share(limit.low_kept), share(Math.min(limit.high_kept, to))];
  return (
    <div class="zone">
      <svg viewBox="0 0 100 6" preserveAspectRatio="none" aria-hidden="true">
        <rect class={flips[0] ? "flips" : "open"} x="0" y="1" width={low} height="4" />
        <rect class="holds" x={low} y="1" width={Math.max(0, high - low)} height="4" />
        <rect class={flips[1] ? "flips" : "open"} x={high} y="1" width={Math.max(0, 100 - high)} height="4" />
      </svg>
      <input
        type="range"
        min={from}
        max={to}
        step={(to - from) / 400}
        value={value}
        aria-label={`${quantity.label}: ${limitWords(quantity, limit)}`}
        title={limitWords(quantity, limit)}
        onChange={(event) => {
          const chosen = Number((Number(event.currentTarget.value) / quantity.si).toPrecision(4));
          void write(quantity.path, withNumber(quantity.text, chosen));
        }}
      />
    </div>
  );
}

/** What was typed with another number in front; its unit and tolerance stay. */
function withNumber(text: string, number: number): string {
  return /-?\d/.test(text) && !text.startsWith("{") ? text.replace(/-?\d+(\.\d+)?(e-?\d+)?/i, String(number)) : String(number);
}

function Field({ quantity }: { quantity: Quantity }) {
  const { path, text, written } = quantity;
  const draft = useSignal(text);
  useEffect(() => {
    draft.value = text;
  }, [text, doc.value.text]);
  const wrong = failure.value?.tried === path ? failure.value : undefined;
  const limit = limits.value.get(path);
  const keep = (value: string) => {
    draft.value = value;
    if (value.trim() !== text) void write(path, value);
  };
  const id = `quantity-${path}`;
  return (
    <div class={`quantity${written ? "" : " default"}`}>
      <label for={id}>{split(path)[1]}</label>
      <input
        id={id}
        value={draft}
        spellcheck={false}
        autocomplete="off"
        aria-invalid={wrong !== undefined}
        aria-describedby={wrong === undefined ? undefined : `${id}-wrong`}
        onInput={(event) => (draft.value = event.currentTarget.value)}
        onBlur={(event) => keep(event.currentTarget.value)}
        onKeyDown={(event) => {
          if (event.key === "Enter") keep(event.currentTarget.value);
          if (event.key === "Escape") draft.value = text;
          const by = { ArrowUp: 1, ArrowDown: -1 }[event.key];
          if (by === undefined || text.startsWith("{")) return;
          event.preventDefault();
          const step = quantity.unit === "" ? 0.01 : 1;
          keep(stepped(event.currentTarget.value, by * step * (event.shiftKey ? 10 : 1)));
        }}
      />
      {limit !== undefined && <Zone quantity={quantity} limit={limit} />}
      {wrong !== undefined && (
        <ul class="wrong" id={`${id}-wrong`} role="alert">
          {wrong.problems.map((problem) => (
            <li key={problem.message}>
              {problem.path === path ? "" : `${problem.path} `}
              {problem.message}
              {problem.help === null ? "" : ` (${problem.help})`}
            </li>
          ))}
          {wrong.problems.length === 0 && <li>{wrong.message}</li>}
        </ul>
      )}
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
      {wrong !== undefined && (
        <ul class="wrong" role="alert">
          {wrong.problems.map(({ path, message }) => (
            <li key={path + message}>
              {path} {message}
            </li>
          ))}
          {wrong.problems.length === 0 && <li>{wrong.message}</li>}
        </ul>
      )}
    </div>
  );
}

/** The scene as its file has it. */
function Source() {
  const draft = useSignal(doc.value.text);
  useEffect(() => {
    draft.value = doc.value.text;
  }, [doc.value.text]);
  const wrong = failure.value?.tried === "text" ? failure.value : undefined;
  return (
    <details class="source">
      <summary>The scene as text</summary>
      <textarea
        aria-label="The scene as text"
        spellcheck={false}
        rows={18}
        value={draft}
        aria-invalid={wrong !== undefined}
        onInput={(event) => (draft.value = event.currentTarget.value)}
        onBlur={(event) => {
          if (event.currentTarget.value !== doc.peek().text) void typed(event.currentTarget.value);
        }}
      />
    </details>
  );
}

/** What is wrong with a scene as a whole, each problem with its line. */
function Problems() {
  const wrong = failure.value;
  if (wrong === undefined || (wrong.tried !== "" && wrong.tried !== "text")) return null;
  return (
    <div class="problems" role="alert">
      <p>{wrong.problems.length === 0 ? wrong.message : `${wrong.message}: the picture shows the scene before.`}</p>
      <ul>
        {wrong.problems.map((problem, number) => (
          <li key={`${problem.path}-${problem.message}`}>
            {wrong.lines[number] == null ? "" : `line ${wrong.lines[number]}: `}
            <b>{problem.path}</b> {problem.message}
            {problem.help === null ? "" : ` (${problem.help})`}
          </li>
        ))}
      </ul>
    </div>
  );
}

export function Quantities() {
  const quantities = whole.value.quantities ?? [];
  return (
    <section class="quantities" aria-label="Quantities of the scene">
      <Problems />
      {groups(quantities).map(([table, own]) => (
        <fieldset key={table}>
          <legend>{table}</legend>
          {table === "part" && <Kind />}
          {own.map((quantity) => (
            <Field key={quantity.path} quantity={quantity} />
          ))}
        </fieldset>
      ))}
      <p class="note">
        Green: the verdict stays while this quantity moves alone. Red: it flips. Grey: nothing can be drawn there, or it was not searched.
        Pale values are defaults that the file does not write.
      </p>
      <Source />
    </section>
  );
}
