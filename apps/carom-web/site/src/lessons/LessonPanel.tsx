// A lesson beside what it is about: its question is answered by what is done with the mouse, and the engine says when.

import { signal, useSignalEffect } from "@preact/signals";
import { doc, open, shown } from "../state";
import { begun, type Lesson, LESSONS } from "./lessons";

/** Larger letters, for a lecture hall. */
export const projector = signal(false);
/** What was found in each lesson. */
const found = signal<ReadonlyMap<string, ReadonlySet<string>>>(new Map());

/** Begins a lesson, as if for the first time. */
export function start(lesson: Lesson): void {
  const others = new Map(found.peek());
  others.delete(lesson.id);
  found.value = others;
  void open(begun(lesson));
}

export function LessonPanel() {
  useSignalEffect(() => {
    const reply = shown.value;
    const lesson = LESSONS.find(({ id }) => id === doc.value.lesson);
    const finding = lesson?.found(reply);
    if (lesson === undefined || finding === undefined) return;
    const before = found.peek().get(lesson.id) ?? new Set();
    if (!before.has(finding)) found.value = new Map(found.peek()).set(lesson.id, new Set([...before, finding]));
  });
  const number = LESSONS.findIndex(({ id }) => id === doc.value.lesson);
  const lesson = LESSONS[number];
  if (lesson === undefined) return null;
  const findings = found.value.get(lesson.id) ?? new Set();
  const answered = findings.size >= lesson.wanted;
  const go = (to: number) => {
    const next = LESSONS[to];
    if (next !== undefined) start(next);
  };
  return (
    <section class="lesson" aria-label="Lesson">
      <div class="lesson-head">
        <h2>
          {number + 1}. {lesson.title}
        </h2>
        <div class="controls">
          <button type="button" disabled={number === 0} onClick={() => go(number - 1)}>
            ◂ before
          </button>
          <button type="button" id="lesson-next" disabled={number === LESSONS.length - 1} onClick={() => go(number + 1)}>
            next ▸
          </button>
          <button type="button" onClick={() => go(number)}>
            Start again
          </button>
          <button type="button" aria-pressed={projector.value} onClick={() => (projector.value = !projector.value)}>
            Large letters
          </button>
          <button
            type="button"
            onClick={() => {
              const { lesson: _, ...plain } = doc.peek();
              projector.value = false;
              void open(plain);
            }}
          >
            Close the lesson
          </button>
        </div>
      </div>
      <p class={`question${answered ? " answered" : ""}`}>
        {answered ? "✓ " : ""}
        {lesson.question}
        {lesson.wanted > 1 && ` Found: ${findings.size === 0 ? "none" : [...findings].sort().join(", ")}.`}
      </p>
      <div role="status">
        {answered &&
          lesson.why.map((paragraph) => (
            <p class="why" key={paragraph}>
              {paragraph}
            </p>
          ))}
      </div>
      {lesson.about.map((paragraph) => (
        <p key={paragraph}>{paragraph}</p>
      ))}
      {!answered && (
        <details>
          <summary>A hint</summary>
          <p>{lesson.hint}</p>
        </details>
      )}
      <p class="source">{lesson.source}</p>
    </section>
  );
}
