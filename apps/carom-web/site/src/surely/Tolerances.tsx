// The tolerances of all quantities in one table: a yield is of these.

import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import type { Quantity } from "../engine/protocol";
import { Wrong } from "../Problems";
import { doc, failure, whole, write } from "../state";

/** A text like `25 ± 0.5 deg`: the middle, what is after the sign without the unit, and the unit. */
function split(text: string): { middle: string; around: string; unit: string } | undefined {
  const [middle, around] = text.split(/\s*(?:±|\+-|\+\/-)\s*/);
  const parts = /^(-?[\d.]+(?:e[-+]?\d+)?)\s*(.*)$/i.exec((middle ?? "").trim());
  if (parts === null) return undefined;
  const half = /^([\d.]+(?:e[-+]?\d+)?)\s*(.*)$/i.exec((around ?? "").trim());
  if (around !== undefined && half === null) return undefined;
  // `15 deg ± 0.5 deg` has its unit twice, `0.15 ± 10 %` another one after the sign.
  const unit = parts[2] || (half?.[2] === "%" ? "" : half?.[2]) || "";
  return { middle: parts[1] ?? "", around: half === null ? "" : `${half[1]}${half[2] === "%" ? " %" : ""}`, unit };
}

function joined({ middle, unit }: { middle: string; unit: string }, around: string): string {
  const tail = unit === "" ? "" : ` ${unit}`;
  if (around.trim() === "") return `${middle}${tail}`;
  return around.includes("%") ? `${middle}${tail} ± ${around.trim()}` : `${middle} ± ${around.trim()}${tail}`;
}

function Row({ quantity }: { quantity: Quantity }) {
  const parts = split(quantity.text);
  // A bad tolerance is told here, not at the quantity.
  const tried = `tolerance of ${quantity.path}`;
  const draft = useSignal(parts?.around ?? "");
  useEffect(() => {
    draft.value = parts?.around ?? "";
  }, [quantity.text, doc.value.text]);
  const keep = () => {
    if (parts !== undefined && draft.value.trim() !== parts.around) void write(quantity.path, joined(parts, draft.value), tried);
  };
  const wrong = failure.value?.tried === tried ? failure.value : undefined;
  return (
    <tr>
      <th scope="row">{quantity.label}</th>
      <td>{parts === undefined ? quantity.text : `${parts.middle} ${parts.unit}`}</td>
      <td>
        {parts === undefined ? (
          "as it is written"
        ) : (
          <>
            ±{" "}
            <input
              aria-label={`tolerance of ${quantity.label}`}
              value={draft}
              autocomplete="off"
              onInput={(event) => (draft.value = event.currentTarget.value)}
              onBlur={keep}
              onKeyDown={(event) => event.key === "Enter" && keep()}
            />{" "}
            {draft.value.includes("%") ? "" : parts.unit}
          </>
        )}
        <Wrong failure={wrong} own={quantity.path} />
      </td>
    </tr>
  );
}

export function Tolerances() {
  const written = (whole.value.quantities ?? []).filter(({ written, number, unit }) => written && number && unit !== "count");
  return (
    <details class="tolerances" open>
      <summary>Tolerances</summary>
      <table>
        <thead>
          <tr>
            <th scope="col">quantity</th>
            <th scope="col">middle</th>
            <th scope="col">limits: three standard deviations</th>
          </tr>
        </thead>
        <tbody>
          {written.map((quantity) => (
            <Row key={quantity.path} quantity={quantity} />
          ))}
        </tbody>
      </table>
    </details>
  );
}
