// How surely a part ends as wanted under the tolerances of the scene; the answer sharpens as drops come.

import { signal, useSignal, useSignalEffect } from "@preact/signals";
import { EngineDied } from "../engine/engine";
import type { Failure, Reply } from "../engine/protocol";
import { Team } from "../engine/team";
import { Wrong } from "../Problems";
import { Work } from "../Work";
import { Tolerances } from "./Tolerances";
import { doc, open } from "../state";
import { tab } from "../tabs";

/** Drops that may be asked for; in space one takes a thousand times as long. */
const AMOUNTS = { plane: [4096, 16384, 65536, 262144], space: [64, 256, 1024, 4096] };
/** The first answer has so many times fewer than the least of them. */
const SOONER = 4;
const SEED = 1;

const sampler = new Team();
/** What was found so far, with how many drops, and of which scene. */
const found = signal<{ reply: Reply; samples: number; text: string } | undefined>(undefined);
const wrong = signal<Failure | undefined>(undefined);
const running = signal<number | undefined>(undefined);

/** Drops in ever larger numbers up to the one that is asked for: each answer is whole, and the next one is surer. */
async function sample(most: number, first: number): Promise<void> {
  const of = doc.peek();
  wrong.value = undefined;
  running.value = most;
  try {
    for (let samples = Math.min(first, most); running.peek() === most; samples = Math.min(4 * samples, most)) {
      const reply = await sampler.study(of, { yield: { samples, seed: SEED } });
      if (reply.failure !== undefined) {
        wrong.value = reply.failure;
        break;
      }
      found.value = { reply, samples, text: of.text };
      if (samples === most) break;
    }
  } catch (error) {
    const stopped = error instanceof EngineDied && error.message === "stopped";
    if (!stopped) wrong.value = { message: String(error), problems: [], lines: [] };
  }
  running.value = undefined;
}

function stop(): void {
  running.value = undefined;
  sampler.stop();
}

async function chosen(event: MouseEvent): Promise<void> {
  const button = (event.target as Element).closest<HTMLElement>("button[data-case]");
  const scene = found.peek()?.reply.scenes?.[Number(button?.dataset["case"])];
  if (button === null || scene === undefined) return;
  await open({ ...doc.peek(), name: scene.name, text: scene.text });
  tab.value = "motion";
}

export function Surely({ inSpace }: { inSpace: boolean }) {
  const amounts = AMOUNTS[inSpace ? "space" : "plane"];
  const [least = 1, usual = least] = amounts;
  const most = useSignal(usual);
  useSignalEffect(() => {
    // Another scene: what runs is of no use any more, nor what was wrong.
    if (doc.value.text !== "") wrong.value = undefined;
    if (found.peek()?.text !== doc.value.text && running.peek() !== undefined) stop();
  });
  const now = found.value;
  const old = now !== undefined && now.text !== doc.value.text;
  return (
    <section class="surely" aria-label="How surely">
      <Tolerances />
      <div class="controls">
        <label>
          drops{" "}
          <select id="samples" value={most} onChange={(event) => (most.value = Number(event.currentTarget.value))}>
            {amounts.map((amount) => (
              <option key={amount} value={amount}>
                {amount}
              </option>
            ))}
          </select>
        </label>
        <Work id="sample" label="Find the yield" running={running.value !== undefined} begin={() => void sample(most.value, least / SOONER)} stop={stop}>
          {running.value !== undefined && `${now === undefined || old ? 0 : now.samples} of ${running.value} drops …`}
          {running.value === undefined && now !== undefined && `${now.samples} drops${old ? ", of the scene before" : ""}`}
        </Work>
      </div>
      <Wrong failure={wrong.value} />
      {now === undefined && wrong.value === undefined && (
        <p class="note">
          Each quantity varies within its tolerance, of which the table above has a column; at the left one is written like “25 ± 0.5 deg”. The yield is the share of parts that end as
          the scene wants, or else as the part does whose quantities are all in the middle.
        </p>
      )}
      {now !== undefined && (
        <div
          class={old ? "old" : ""}
          onClick={(event) => void chosen(event)}
          dangerouslySetInnerHTML={{ __html: now.reply.html ?? "" }}
        />
      )}
    </section>
  );
}
