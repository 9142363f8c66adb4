// Which layout makes drops end as wanted: what may be chosen and must be kept, the search, and what it found.

import { signal, useSignal, useSignalEffect } from "@preact/signals";
import { Engine, EngineDied } from "../engine/engine";
import type { Candidate, DesignFound, Doc, Failure, Progress } from "../engine/protocol";
import { save, stem } from "../download";
import { Wrong } from "../Problems";
import { Work } from "../Work";
import { doc, failure, open, settled } from "../state";
import { tab } from "../tabs";
import { Asked } from "./Asked";

/** How long a search may take: layouts of the first look, drops that confirm the winner. */
const EFFORTS = [
  { words: "quick: 1024 layouts", scan: 1024, samples: 2048 },
  { words: "as the command: 4096 layouts", scan: 4096, samples: 16384 },
  { words: "thorough: 16384 layouts", scan: 16384, samples: 65536 },
] as const;
type Effort = (typeof EFFORTS)[number];
const SEED = 1;

const searcher = new Engine("carom-whole.wasm");
const found = signal<{ design: DesignFound; of: Doc } | undefined>(undefined);
const wrong = signal<Failure | undefined>(undefined);
const progress = signal<Progress | undefined>(undefined);
/** The best layout of a search that goes on, or was stopped. */
const best = signal<{ candidate: Candidate; of: Doc } | undefined>(undefined);

/** Whether the last search was stopped. */
const stopped = signal(false);

async function search({ scan, samples }: Effort): Promise<void> {
  await settled();
  const of = doc.peek();
  stopped.value = false;
  [wrong.value, found.value, best.value] = [undefined, undefined, undefined];
  progress.value = { steps: 0 };
  const hear = (heard: Progress) => {
    if (heard.news?.best != null) best.value = { candidate: heard.news.best, of };
    const news = heard.news ?? progress.peek()?.news;
    progress.value = { steps: heard.steps, ...(news === undefined ? {} : { news }) };
  };
  try {
    const reply = await searcher.study(of, { study: { design: { scan, samples, seed: SEED } } }, hear);
    wrong.value = reply.failure;
    if (reply.found !== undefined) [found.value, best.value] = [{ design: reply.found, of }, undefined];
  } catch (error) {
    stopped.value = error instanceof EngineDied && error.message === "stopped";
    if (!stopped.value) wrong.value = { message: String(error), problems: [], lines: [] };
  }
  progress.value = undefined;
}

const stop = (): void => searcher.stop();

async function take(candidate: Candidate, of: Doc): Promise<void> {
  if (await open({ ...of, text: candidate.text })) tab.value = "motion";
}

function Card({ candidate, of, name }: { candidate: Candidate; of: Doc; name: string }) {
  const [width, height] = candidate.size;
  return (
    <li class="candidate">
      <h2>{name}</h2>
      <svg
        class="fig scene layout"
        viewBox={`0 0 ${width} ${height}`}
        role="img"
        aria-label={`${name}: ${candidate.words}`}
        dangerouslySetInnerHTML={{ __html: candidate.picture }}
      />
      <p>{candidate.words}</p>
      <table>
        <tbody>
          {candidate.rows.map(([label, value]) => (
            <tr key={label}>
              <th scope="row">{label}</th>
              <td>{value}</td>
            </tr>
          ))}
        </tbody>
      </table>
      <button type="button" onClick={() => void take(candidate, of)}>
        Take this layout
      </button>
    </li>
  );
}

function Forbidden({ rows }: { rows: string[][] }) {
  const [head, ...rest] = rows;
  if (head === undefined) return null;
  return (
    <table class="forbidden">
      <caption>What stands in the way, of the layouts of the first look</caption>
      <thead>
        <tr>
          {head.map((cell) => (
            <th key={cell} scope="col">
              {cell}
            </th>
          ))}
        </tr>
      </thead>
      <tbody>
        {rest.map((row) => (
          <tr key={row[0]}>
            {row.map((cell, column) => (column === 0 ? <th scope="row">{cell}</th> : <td>{cell}</td>))}
          </tr>
        ))}
      </tbody>
    </table>
  );
}

function Found({ design, of }: { design: DesignFound; of: Doc }) {
  const old = of.text !== doc.value.text;
  return (
    <div class={old ? "old" : ""}>
      {old && <p class="note">Found for the file as it was before it was changed.</p>}
      <p class={`headline${design.possible ? "" : " impossible"}`}>{design.possible ? "Possible" : "Not possible"}</p>
      <p class="lead">{design.verdict}</p>
      <ul>
        {design.said.map((sentence) => (
          <li key={sentence}>{sentence}</li>
        ))}
      </ul>
      {design.possible && (
        <p class="controls">
          {Object.entries(design.files).map(([name, text]) => (
            <button type="button" key={name} onClick={() => save(`${stem(of.name)}-${name}`, text)}>
              Save {name}
            </button>
          ))}
        </p>
      )}
      <ul class="candidates">
        {design.candidates.map((candidate, number) => (
          <Card key={candidate.text + number} candidate={candidate} of={of} name={design.possible && number === 0 ? "The winner" : `Candidate ${number + (design.possible ? 0 : 1)}`} />
        ))}
      </ul>
      <Forbidden rows={design.forbidden} />
    </div>
  );
}

export function Design() {
  const effort = useSignal<Effort>(EFFORTS[0]);
  useSignalEffect(() => {
    // Another scene: what is searched is of no use any more.
    if (doc.value.text !== "" && progress.peek() !== undefined) stop();
    wrong.value = undefined;
  });
  const now = progress.value;
  const news = now?.news;
  return (
    <section class="design" aria-label="Design">
      <Asked />
      <Wrong failure={failure.value?.tried === "design" ? failure.value : undefined} />
      <div class="controls">
        <label>
          search{" "}
          <select id="effort" value={EFFORTS.indexOf(effort.value)} onChange={(event) => (effort.value = EFFORTS[Number(event.currentTarget.value)] ?? EFFORTS[0])}>
            {EFFORTS.map(({ words }, number) => (
              <option key={words} value={number}>
                {words}
              </option>
            ))}
          </select>
        </label>
        <Work id="search" label="Find a layout" running={now !== undefined} begin={() => void search(effort.value)} stop={stop}>
          {now !== undefined && `look ${(news?.look ?? 0) + 1} of ${news?.looks ?? "…"}, ${now.steps} drops`}
          {now === undefined && stopped.value && (best.value === undefined ? "stopped before a layout was found" : "stopped: the best layout so far is below")}
        </Work>
        {now !== undefined && <progress value={news?.look ?? 0} max={news?.looks ?? 1} aria-label="Looks" />}
      </div>
      <Wrong failure={wrong.value} />
      {best.value !== undefined && (
        <>
          {best.value.of.text !== doc.value.text && <p class="note">Found for the file as it was before it was changed.</p>}
          <ul class="candidates">
            <Card candidate={best.value.candidate} of={best.value.of} name="The best so far" />
          </ul>
        </>
      )}
      {found.value !== undefined && <Found {...found.value} />}
    </section>
  );
}
