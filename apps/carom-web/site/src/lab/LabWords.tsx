// What is said of an impact: what happens, what else is consistent, and what other laws and ways to share make of it.

import type { Beside, Lab } from "../engine/protocol";
import { shown } from "../state";

const joules = (energy: Beside["energy"], k: 0 | 1): string => {
  const value = energy?.[k];
  return value === undefined ? "" : String(Number(value.toPrecision(5)));
};

function Table({ caption, rows }: { caption: string; rows: Beside[] }) {
  const known = rows.some(({ energy }) => energy !== null);
  return (
    <table class="beside">
      <caption>{caption}</caption>
      <thead>
        <tr>
          <th scope="col">by</th>
          {known && <th scope="col">energy after [J]</th>}
          <th scope="col">normal velocities and slips after [m/s]</th>
        </tr>
      </thead>
      <tbody>
        {rows.map(({ name, said, energy, asked }) => (
          <tr key={name} class={asked ? "asked" : ""}>
            <th scope="row">
              {name}
              {asked ? " ◂" : ""}
            </th>
            {known && <td>{joules(energy, 1)}</td>}
            <td class="words">
              {said.split("   ").map((contact) => (
                <div key={contact}>{contact}</div>
              ))}
            </td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}

function Forces({ forces }: { forces: NonNullable<Lab["forces"]> }) {
  return (
    <section id="forces-at-once">
      <h2>Under forces, at this instant</h2>
      <p class="lead">{forces.headline}</p>
      {forces.motions.length > 0 && (
        <ul>
          {forces.motions.map(([motion, taken]) => (
            <li key={motion}>
              <b>{motion}</b>: {taken}
            </li>
          ))}
        </ul>
      )}
      <details open={forces.motions.length !== 1}>
        <summary>{forces.rejected.length} hypotheses are rejected</summary>
        <ul>
          {forces.rejected.map(([motion, because]) => (
            <li key={motion}>
              {motion}: {because}
            </li>
          ))}
        </ul>
      </details>
    </section>
  );
}

export function LabWords({ lab }: { lab: Lab }) {
  const before = lab.laws.find(({ energy }) => energy !== null)?.energy ?? null;
  return (
    <aside class="words" aria-label="What the impact does">
      <p class="headline verdict long" id="headline">
        <strong>{shown.value.headline?.word.replace(/^./, (letter) => letter.toUpperCase())}</strong>
      </p>
      <p class="lead">{lab.lead}</p>
      {lab.forces !== null && <Forces forces={lab.forces} />}
      <div dangerouslySetInnerHTML={{ __html: lab.after }} />
      <div dangerouslySetInnerHTML={{ __html: lab.hypotheses }} />
      {lab.laws.length > 0 && (
        <Table caption={`Laws of restitution side by side${before === null ? "" : `; ${joules(before, 0)} J before`}`} rows={lab.laws} />
      )}
      {lab.sharings.length > 0 && <Table caption="Ways to share the impact side by side: rigid bodies leave it open" rows={lab.sharings} />}
    </aside>
  );
}
