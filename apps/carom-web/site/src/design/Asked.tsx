// What a design may choose, must keep and aims at: the table `[design]` of the scene, and what is wanted on each plate.

import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import type { DesignAsked, Quantity } from "../engine/protocol";
import { rangeOf } from "../ranges";
import { designAsked, doc, failure, want, whole } from "../state";

const WANTS: [string, string][] = [
  ["", "nothing"],
  ["turned", "turned"],
  ["same", "same side"],
  ["any", "any side"],
];

interface Range {
  path: string;
  from: string;
  to: string;
}

/** The table as text, with one thing changed. */
function linesOf(asked: DesignAsked, ranges: Range[], quantities: Quantity[]): string {
  const unit = (path: string) => {
    const own = quantities.find((quantity) => quantity.path === path)?.unit ?? "";
    return own === "" || own === "count" ? "" : ` ${own}`;
  };
  const free = ranges.map(({ path, from, to }) => `${JSON.stringify(path)} = ${JSON.stringify(`${from}..${to}${unit(path)}`)}`);
  const limits = asked.limits.filter(({ text }) => text.trim() !== "").map(({ key, text }) => `${key} = ${Number.isFinite(Number(text)) ? text : JSON.stringify(text)}`);
  return [
    `free = { ${free.join(", ")} }`,
    ...limits,
    ...(asked.forbid_walls ? ["forbid_walls = true"] : []),
    ...(asked.aim === asked.aims[0] ? [] : [`aim = ${JSON.stringify(asked.aim)}`]),
  ].join("\n");
}

/** A field that counts when it is left. */
function Field({ label, value, onKeep }: { label: string; value: string; onKeep: (text: string) => void }) {
  const draft = useSignal(value);
  useEffect(() => {
    draft.value = value;
  }, [value, doc.value.text]);
  const keep = () => {
    if (draft.value.trim() !== value) onKeep(draft.value.trim());
    // What the file has already is right again.
    else if (failure.peek()?.tried === "design") failure.value = undefined;
  };
  return (
    <input
      aria-label={label}
      value={draft}
      autocomplete="off"
      onInput={(event) => (draft.value = event.currentTarget.value)}
      onBlur={keep}
      onKeyDown={(event) => event.key === "Enter" && keep()}
    />
  );
}

function Wants({ asked }: { asked: DesignAsked }) {
  return (
    <fieldset>
      <legend>What is wanted</legend>
      {asked.wants.map(([plate, word], number) => (
        <label class="row" key={plate}>
          <span>on {plate}</span>
          <select value={word} onChange={(event) => void want(number, event.currentTarget.value)}>
            {WANTS.map(([value, label]) => (
              <option key={value} value={value}>
                {label}
              </option>
            ))}
            {!WANTS.some(([value]) => value === word) && <option value={word}>face {word}</option>}
          </select>
        </label>
      ))}
    </fieldset>
  );
}

export function Asked() {
  const { design: asked, quantities = [] } = whole.value;
  if (asked === undefined) return null;
  const shown = (path: string, value: number) => {
    const si = quantities.find((quantity) => quantity.path === path)?.si ?? 1;
    return String(Number((value / si).toPrecision(10)));
  };
  const ranges: Range[] = asked.free.map(({ path, from, to }) => ({ path, from: shown(path, from), to: shown(path, to) }));
  const keep = (changed: Partial<DesignAsked>, free = ranges) => void designAsked(linesOf({ ...asked, ...changed }, free, quantities));
  const chosen = (path: string) => {
    const quantity = quantities.find((own) => own.path === path);
    if (quantity === undefined) return;
    const [from, to] = rangeOf(quantity).map((end) => String(Number((end / quantity.si).toPrecision(3))));
    keep({}, [...ranges, { path, from: from ?? "", to: to ?? "" }]);
  };
  const moved = (path: string, end: "from" | "to", text: string) =>
    keep({}, ranges.map((range) => (range.path === path ? { ...range, [end]: text } : range)));
  return (
    <div class="asked">
      <Wants asked={asked} />
      <fieldset>
        <legend>What may be chosen</legend>
        {ranges.map((range) => {
          const own = quantities.find(({ path }) => path === range.path);
          const label = own?.label ?? range.path;
          return (
            <div class="row" key={range.path}>
              <span>{label}</span>
              <span>
                <Field label={`${label} at least`} value={range.from} onKeep={(text) => moved(range.path, "from", text)} /> to{" "}
                <Field label={`${label} at most`} value={range.to} onKeep={(text) => moved(range.path, "to", text)} />{" "}
                {own === undefined || own.unit === "count" ? "" : own.unit}{" "}
                <button type="button" aria-label={`${label} stays as it is`} title="stays as it is" onClick={() => keep({}, ranges.filter(({ path }) => path !== range.path))}>
                  ×
                </button>
              </span>
            </div>
          );
        })}
        <select id="choose" aria-label="One more quantity that may be chosen" value="" onChange={(event) => chosen(event.currentTarget.value)}>
          <option value="">one more quantity …</option>
          {quantities
            .filter(({ path, written }) => written && !ranges.some((range) => range.path === path))
            .map(({ path, label }) => (
              <option key={path} value={path}>
                {label}
              </option>
            ))}
        </select>
      </fieldset>
      <fieldset>
        <legend>What must be kept, and the aim</legend>
        {asked.limits.map((limit) => (
          <label class="row" key={limit.key}>
            <span>{limit.label}</span>
            <Field
              label={`${limit.label} [${limit.unit}]`}
              value={limit.text}
              onKeep={(text) => keep({ limits: asked.limits.map((other) => (other.key === limit.key ? { ...other, text: withUnit(text, limit.unit) } : other)) })}
            />
          </label>
        ))}
        <label class="row">
          <span>touches no wall</span>
          <input type="checkbox" checked={asked.forbid_walls} onChange={(event) => keep({ forbid_walls: event.currentTarget.checked })} />
        </label>
        <label class="row">
          <span>best at</span>
          <select value={asked.aim} onChange={(event) => keep({ aim: event.currentTarget.value })}>
            {asked.aims.map((aim) => (
              <option key={aim}>{aim}</option>
            ))}
          </select>
        </label>
      </fieldset>
    </div>
  );
}

/** A plain number gets the unit that the field shows. */
const withUnit = (text: string, unit: string): string => (text !== "" && Number.isFinite(Number(text)) ? `${text} ${unit}` : text);
