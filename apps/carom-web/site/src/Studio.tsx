// The page: a bar above, the quantities at the left, the picture in the middle, what is said of it at the right.

import type { ComponentChildren } from "preact";
import { useEffect } from "preact/hooks";
import { Bar } from "./Bar";
import { Picture, playing } from "./bench/Picture";
import { Quantities } from "./bench/Quantities";
import { Words } from "./bench/Words";
import { Design } from "./design/Design";
import { Lab } from "./lab/Lab";
import { LabWords } from "./lab/LabWords";
import { LessonPanel, projector } from "./lessons/LessonPanel";
import { MapView } from "./map/MapView";
import { Solid } from "./solid/Solid";
import { Surely } from "./surely/Surely";
import { type Tab, TABS, tab } from "./tabs";
import { Notice, Problems } from "./Problems";
import { begin, doc, redo, said, shown, undo } from "./state";
import { taken } from "./taken";

function keys(event: KeyboardEvent): void {
  const command = event.ctrlKey || event.metaKey;
  const { target } = event;
  const inText = target instanceof HTMLTextAreaElement || (target instanceof HTMLInputElement && !["range", "checkbox"].includes(target.type));
  // The player's keys work from anywhere that has none of its own.
  const nowhere = event.target === document.body;
  if (!command && nowhere && tab.value === "motion" && playing.value?.press(event.key, event.shiftKey) === true) event.preventDefault();
  if (!command || inText) return;
  const key = event.key.toLowerCase();
  if (key === "z") {
    event.preventDefault();
    void (event.shiftKey ? redo() : undo());
  } else if (key === "y") {
    event.preventDefault();
    void redo();
  }
}

async function dropped(event: DragEvent): Promise<void> {
  event.preventDefault();
  const file = event.dataTransfer?.files[0];
  if (file !== undefined) await taken(file);
}

type Kind = keyof typeof TABS;

function viewOf(name: Tab, kind: Kind): ComponentChildren {
  if (name === "surely") return <Surely key={kind} inSpace={kind === "space"} />;
  if (name === "map") return <MapView key={kind} />;
  if (name === "design") return <Design />;
  const { lab } = shown.value;
  if (kind === "impact") return lab !== undefined && <Lab lab={lab} />;
  return kind === "solid" || kind === "space" ? <Solid /> : <Picture />;
}

function TabButton({ name, label, kind, chosen }: { name: Tab; label: string; kind: Kind; chosen: boolean }) {
  const others = TABS[kind].map(([other]) => other);
  const step = (by: number) => {
    const next = others[(others.indexOf(name) + by + others.length) % others.length] ?? name;
    tab.value = next;
    document.getElementById(`tab-${next}`)?.focus();
  };
  return (
    <button
      type="button"
      role="tab"
      id={`tab-${name}`}
      aria-controls={`view-${name}`}
      aria-selected={chosen}
      tabIndex={chosen ? 0 : -1}
      onClick={() => (tab.value = name)}
      onKeyDown={(event) => {
        if (event.key === "ArrowRight") step(1);
        if (event.key === "ArrowLeft") step(-1);
      }}
    >
      {label}
    </button>
  );
}

function Views({ kind }: { kind: Kind }) {
  const tabs = TABS[kind];
  // A view that this kind of file does not have is not shown.
  const now = tabs.some(([name]) => name === tab.value) ? tab.value : "motion";
  return (
    <>
      <div class="tabs" role="tablist" aria-label="Views">
        {tabs.map(([name, label]) => (
          <TabButton key={name} name={name} label={label} kind={kind} chosen={now === name} />
        ))}
      </div>
      {tabs.map(([name]) => (
        <div key={name} class="view" role="tabpanel" id={`view-${name}`} aria-labelledby={`tab-${name}`} hidden={now !== name}>
          {viewOf(name, kind)}
        </div>
      ))}
    </>
  );
}

export function Studio() {
  const { kind = "scene", lab } = shown.value;
  useEffect(() => {
    addEventListener("keydown", keys);
    const over = (event: DragEvent) => event.preventDefault();
    const drop = (event: DragEvent) => void dropped(event);
    addEventListener("dragover", over);
    addEventListener("drop", drop);
    void begin();
    return () => {
      removeEventListener("keydown", keys);
      removeEventListener("dragover", over);
      removeEventListener("drop", drop);
    };
  }, []);
  return (
    <div class={`studio${projector.value && doc.value.lesson !== undefined ? " projector" : ""}`}>
      <Bar />
      <Quantities />
      <main>
        <div class="told">
          <Notice />
          <Problems />
          <LessonPanel />
        </div>
        <Views kind={kind} />
      </main>
      {lab === undefined ? <Words /> : <LabWords lab={lab} />}
      <p class="unseen" role="status">
        {said}
      </p>
    </div>
  );
}
