// What is said of the run: how it came out, stage by stage, and one strike in full.

import { useSignal, useSignalEffect } from "@preact/signals";
import { doc, shown, strike, whole } from "../state";
import { playing } from "./Picture";

const SIGNS = new Map([
  [true, "✓ "],
  [false, "✗ "],
]);

const capital = (word: string): string => word.charAt(0).toUpperCase() + word.slice(1);

function More({ summary, html }: { summary: string; html: string }) {
  if (html === "") return null;
  return (
    <details>
      <summary>{summary}</summary>
      <div dangerouslySetInnerHTML={{ __html: html }} />
    </details>
  );
}

export function Words() {
  const full = useSignal("");
  useSignalEffect(() => {
    // Another scene has other strikes.
    if (doc.value.text !== "") full.value = "";
  });
  const { headline, failure } = shown.value;
  const { kind, sections } = whole.value;
  const wanted = headline?.wanted ?? null;
  const chosen = async (event: MouseEvent) => {
    const button = (event.target as Element).closest<HTMLElement>("[data-t]");
    if (button === null) return;
    playing.value?.goTo(Number(button.dataset["t"]));
    const number = button.dataset["strike"];
    full.value = number === undefined ? "" : await strike(Number(number));
  };
  return (
    <aside class="words" aria-label="What the part does">
      {headline !== undefined && (
        <p class={`headline verdict ${wanted === null ? "open" : wanted ? "wanted" : "unwanted"}`} id="headline">
          <strong>
            {wanted === null ? "" : SIGNS.get(wanted)}
            {capital(headline.word)}
          </strong>
          {headline.plate === null ? "" : ` on “${headline.plate}”`}
        </p>
      )}
      {failure !== undefined && (
        <p class="note warn" role="alert">
          {failure.message}
        </p>
      )}
      {sections !== undefined && (
        <>
          <div class="said" dangerouslySetInnerHTML={{ __html: sections.verdict }} />
          {kind === "scene" && <h2>Stage by stage</h2>}
          <div onClick={(event) => void chosen(event)} dangerouslySetInnerHTML={{ __html: sections.timeline }} />
          <div id="strike" aria-live="polite" dangerouslySetInnerHTML={{ __html: full.value }} />
          <More summary="The part and its faces" html={sections.part} />
          <More summary={kind === "space" ? "Strikes in full, and the plates" : "Table of stages"} html={sections.stages} />
          <div dangerouslySetInnerHTML={{ __html: sections.model }} />
        </>
      )}
    </aside>
  );
}
