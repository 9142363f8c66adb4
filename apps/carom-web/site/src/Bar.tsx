// Open, save, export, undo: what is done with the scene as a whole.

import { useSignal } from "@preact/signals";
import { useRef } from "preact/hooks";
import { save, stem } from "./download";
import { hosted } from "./host";
import { linkOf } from "./link";
import type { Doc } from "./engine/protocol";
import { film, filmed, stopFilm } from "./record/record";
import { start } from "./lessons/LessonPanel";
import { LESSONS } from "./lessons/lessons";
import { impacts, rolls, scenes, solids } from "./scenes";
import { taken } from "./taken";
import { broken, canRedo, canUndo, doc, filesOf, open, redo, settled, undo, whole } from "./state";

const FILM: [string, () => Promise<void>] = ["Film of the motion, WebM", film];
const REPORT: [string, () => Promise<void>] = ["Report, HTML", async () => exported("files", "report.html")];
const OF_RUNS: [string, () => Promise<void>][] = [
  REPORT,
  ["Result, JSON", async () => exported("files", "run.json")],
  ["Samples, CSV", async () => exported("files", "trace.csv")],
  FILM,
];
const OF_SCENES: [string, () => Promise<void>][] = [
  ["Drawing, DXF", async () => exported("drawings", "drawing.dxf")],
  ["Drawing, SVG", async () => exported("drawings", "drawing.svg")],
  ...OF_RUNS,
];

const OF_ROLLS: [string, () => Promise<void>][] = [REPORT, FILM, ["Result, JSON", async () => exported("files", "roll.json")]];

const EXPORTS = {
  scene: OF_SCENES,
  space: OF_RUNS,
  impact: [REPORT, ["Result, JSON", async () => exported("files", "impact.json")]],
  roll: OF_ROLLS,
  solid: OF_ROLLS,
} satisfies Record<string, [string, () => Promise<void>][]>;

async function exported(ask: "files" | "drawings", file: string): Promise<void> {
  await settled();
  const text = (await filesOf(ask))[file];
  if (text !== undefined) save(`${stem(doc.value.name)}-${file}`, text);
}

function Examples({ label, docs }: { label: string; docs: Doc[] }) {
  return (
    <optgroup label={label}>
      {docs.map(({ name }) => (
        <option key={name} value={name}>
          {stem(name).replaceAll("_", " ")}
        </option>
      ))}
    </optgroup>
  );
}

/** The address of the file as it is. */
const linkNow = async (): Promise<string> => new URL(await linkOf(doc.value), location.href).href;

export function Bar() {
  const input = useRef<HTMLInputElement>(null);
  const copied = useSignal("Copy link");
  const exports = EXPORTS[whole.value.kind ?? "scene"];
  const read = async () => {
    const file = input.current?.files?.[0];
    if (file !== undefined) await taken(file);
    if (input.current !== null) input.current.value = "";
  };
  const link = async () => {
    await settled();
    await navigator.clipboard.writeText(await linkNow());
    copied.value = "Link copied";
    setTimeout(() => (copied.value = "Copy link"), 2000);
  };
  return (
    <header class="top">
      <h1>Carom studio</h1>
      <label>
        <span class="unseen">Scene</span>
        <select
          id="scene"
          value=""
          onChange={(event) => {
            // A file that is not opened is not the chosen one.
            const { currentTarget } = event;
            setTimeout(() => (currentTarget.value = ""));
            const chosen = [...scenes, ...impacts, ...rolls, ...solids].find(({ name }) => name === event.currentTarget.value);
            if (chosen !== undefined) void open(chosen);
          }}
        >
          <option value="" selected>
            {doc.value.name}
          </option>
          <Examples label="Feeders" docs={scenes} />
          <Examples label="Impacts" docs={impacts} />
          <Examples label="Rolling and rocking" docs={rolls} />
          <Examples label="In space" docs={solids} />
        </select>
      </label>
      <label>
        <span class="unseen">Lessons</span>
        <select
          id="lessons"
          value=""
          onChange={(event) => {
            const lesson = LESSONS[Number(event.currentTarget.value)];
            event.currentTarget.value = "";
            if (lesson !== undefined) start(lesson);
          }}
        >
          <option value="" selected>
            Lessons …
          </option>
          {LESSONS.map(({ id, title }, number) => (
            <option key={id} value={number}>
              {number + 1}. {title}
            </option>
          ))}
        </select>
      </label>
      <button type="button" onClick={() => input.current?.click()}>
        Open …
      </button>
      <input ref={input} type="file" accept=".toml,.dxf,.svg,.stl" hidden aria-label="A scene's file, or an outline of its part" onChange={() => void read()} />
      <button type="button" onClick={() => void settled().then(() => save(doc.value.name, broken.value ?? doc.value.text))}>
        Save
      </button>
      <label>
        <span class="unseen">Export</span>
        <select
          id="export"
          onChange={(event) => {
            const chosen = exports[Number(event.currentTarget.value)];
            event.currentTarget.value = "";
            void chosen?.[1]();
          }}
        >
          <option value="" selected>
            Export …
          </option>
          {exports.map(([label], number) => (
            <option key={label} value={number}>
              {label}
            </option>
          ))}
        </select>
      </label>
      {filmed.value !== undefined && (
        <>
          <progress value={filmed.value} aria-label="The film" />
          <button type="button" id="film-stop" onClick={stopFilm}>
            Stop the film
          </button>
        </>
      )}
      <button type="button" id="undo" disabled={!canUndo.value} title="Ctrl+Z" onClick={() => void undo()}>
        Undo
      </button>
      <button type="button" id="redo" disabled={!canRedo.value} title="Ctrl+Shift+Z" onClick={() => void redo()}>
        Redo
      </button>
      {!hosted && (
        <button type="button" onClick={() => void link()}>
          {copied}
        </button>
      )}
    </header>
  );
}
