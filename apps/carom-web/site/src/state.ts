// What the page knows: the scene, its history, the last answer about it.

import { computed, effect, signal } from "@preact/signals";
import { Engine, EngineDied } from "./engine/engine";
import type { Ask, Change, Doc, Failure, Frame, Limit, Pair, Quantity, Reply, Window } from "./engine/protocol";
import { given as byHost, hosted, later, taken, tell } from "./host";
import { docOf, linkOf, served } from "./link";
import { lessonOf } from "./lessons/lessons";
import { first } from "./scenes";

const MOST_UNDONE = 500;

/** The scene as it stands. */
export const doc = signal<Doc>(first);
/** Scenes before and after this one, for undo and redo. */
const past = signal<Doc[]>([]);
const future = signal<Doc[]>([]);
export const canUndo = computed(() => past.value.length > 0);
export const canRedo = computed(() => future.value.length > 0);

/** The last answer about the whole scene. */
export const whole = signal<Reply>({});
/** The picture as it is now: of the whole scene, or of what is being dragged. */
export const shown = signal<Reply>({});
/** What is wrong with what was tried last; the scene before it stays. */
export const failure = signal<(Failure & { tried: string }) | undefined>(undefined);
/** A short message for who cannot see what changed. */
export const said = signal("");
/** A limit, the value that it was found from, and the scene. */
export interface Found {
  limit: Limit;
  value: number;
  text: string;
}
/** Limits by quantity; those of the scene before stay until they are found anew. */
export const limits = signal<ReadonlyMap<string, Found>>(new Map());
/** What the person at the page should know, until the next change. */
export const notice = signal("");
/** The text as it is typed, while it is no scene. */
export const broken = signal<string | undefined>(undefined);
/** The size of the picture [px]. */
export const size = signal<Pair>([900, 640]);
export const engine = new Engine();
const searcher = new Engine();

const PAGE = (message: string): Failure => ({ message, problems: [], lines: [] });

let marked = false;

function told(error: unknown, tried: string): void {
  const words = error instanceof Error ? error.message : String(error);
  const died = error instanceof EngineDied;
  const said = died ? `The engine was started again, and the scene is as it was: ${words}.` : words;
  failure.value = { ...PAGE(said), tried };
}

/** Takes an answer about a scene: shows it, or says what is wrong. */
function take(next: Doc, reply: Reply, tried: string, keep: "remember" | "replace"): boolean {
  if (reply.window === undefined) {
    if (reply.failure === undefined) return false;
    failure.value = { ...reply.failure, tried };
    return false;
  }
  // A look from elsewhere mends nothing: what is wrong stays told until the scene changes.
  if (keep === "remember") [failure.value, broken.value] = [undefined, undefined];
  if (reply.failure !== undefined) failure.value = { ...reply.failure, tried };
  const text = reply.text ?? next.text;
  const another = text !== doc.value.text || next.name !== doc.value.name || next.lesson !== doc.value.lesson;
  if (keep === "remember" && another) {
    past.value = [...past.value.slice(-MOST_UNDONE), doc.value];
    future.value = [];
  }
  // A look at the same scene, at every frame of a pan, is no new scene: its link and its limits stay.
  if (another || next.files !== doc.value.files || !marked) {
    doc.value = { ...next, text };
    if (!hosted) void linkOf(doc.value).then((link) => history.replaceState(null, "", link));
    void searchLimits(reply.kind === "scene" ? (reply.quantities ?? []) : []);
  }
  if (reply.sections !== undefined || reply.lab !== undefined || reply.failure !== undefined) whole.value = reply;
  shown.value = reply;
  said.value = reply.seen?.words ?? reply.lab?.words ?? reply.solid?.words ?? "";
  if (!marked) performance.mark("carom-first-verdict");
  marked = true;
  return true;
}

const ofScene = (frame: Frame, change?: Change): Ask => ({ show: { frame, ...(change === undefined ? {} : { change }) } });
const around = (): Frame => ({ size: size.value });

/** Asks about a scene. One that is to be remembered takes the place of text that is no scene, if that may be thrown away. */
function asked(next: Doc, ask: Ask, tried: string, keep: "remember" | "replace"): Promise<boolean> {
  if (keep === "remember" && tried !== "text" && !mayDiscard()) return Promise.resolve(false);
  const answered = answer(next, ask, tried, keep);
  asking = answered;
  return answered;
}

/** When all that was asked about the file is answered: what is saved or asked then is of the newest. */
export async function settled(): Promise<void> {
  for (let last; last !== asking; ) {
    last = asking;
    await last;
    await engine.idle();
  }
}

/** The last question about a file that is under way. */
let asking: Promise<boolean> = Promise.resolve(true);

async function answer(next: Doc, ask: Ask, tried: string, keep: "remember" | "replace"): Promise<boolean> {
  try {
    return take(next, await engine.ask(next, ask), tried, keep);
  } catch (error) {
    told(error, tried);
    return false;
  }
}

/** The window of the picture now; none before the first answer. */
export const windowNow = (): Window | undefined => shown.value.window;

/** Shows a scene in a window around all of its motion. */
export async function open(next: Doc, keep: "remember" | "replace" = "remember"): Promise<boolean> {
  const opened = await asked(next, ofScene(around()), "", keep);
  if (opened && keep === "remember") notice.value = "";
  return opened;
}

/** Shows the file that there is in a window as large as its room, when nothing else is asked any more. */
export async function refit(): Promise<void> {
  await settled();
  if (windowNow() !== undefined) await open(doc.peek(), "replace");
}

/** Text that is no scene is not thrown away without a word. */
export function mayDiscard(): boolean {
  if (broken.value === undefined) return true;
  const yes = confirm("The text of the scene has problems and is not applied. Throw it away?");
  if (yes) takeBack();
  return yes;
}

/** Goes back from text that is no scene to the last one that is. */
export function takeBack(): void {
  [broken.value, failure.value] = [undefined, undefined];
}

/** Shows the scene again in another window. */
export function look(window: Window): void {
  engine.latest(doc.value, ofScene({ window }), (reply) => take(doc.value, reply, "", "replace"), (error) => told(error, ""));
}

/** Changes the scene in the window that there is. */
async function change(by: Change, tried = ""): Promise<boolean> {
  await settled();
  const window = windowNow();
  return window !== undefined && asked(doc.value, ofScene({ window }, by), tried, "remember");
}

/** Writes a value as it was typed; `tried` is where a problem of it is told. */
export const write = (path: string, value: string, tried = path): Promise<boolean> =>
  change({ write: { path, value } }, tried);

/** Draws one more plate or wall from here to there [m]. */
export const add = (table: "plate" | "wall", from: Pair, to: Pair, snap: number): Promise<boolean> =>
  change({ add: { table, from, to, snap } });

/** Adds a contact to the body that is struck, at a place of the window [px]. */
export const addContact = (at: Pair): Promise<boolean> => change({ add_contact: { at } });

/** Takes a contact away. */
export const removeContact = (contact: number): Promise<boolean> => change({ remove_contact: { contact } });

/** Takes a plate or wall away. */
export const remove = (obstacle: number): Promise<boolean> => change({ remove: { obstacle } });

/** Writes several values, SI. */
export const moveTo = (values: Record<string, number>, tried = ""): Promise<boolean> => change({ move: { values } }, tried);

/** What is wanted on a plate. */
export const want = (plate: number, want: string): Promise<boolean> => change({ want: { plate, want } }, "design");

/** What may be chosen and must be kept, as the keys of `[design]`. */
export const designAsked = (lines: string): Promise<boolean> => change({ replace: { table: "design", lines } }, "design");

/** Another part, as the keys of its table; with the file that draws it, where one does. */
export const another = (lines: string, files: Record<string, string> = {}): Promise<boolean> =>
  asked({ ...doc.value, files: { ...doc.value.files, ...files } }, ofScene(around(), { replace: { table: "part", lines } }), "part", "remember");

/** Shows a scene that was typed as text, in the window that there is. */
export async function typed(text: string): Promise<boolean> {
  if (text === doc.value.text) {
    takeBack();
    return true;
  }
  broken.value = text;
  const window = windowNow();
  return asked({ ...doc.value, text }, ofScene(window === undefined ? around() : { window }), "text", "remember");
}

/** Shows what a value would do, while it is being moved. */
export function preview(from: Doc, values: Record<string, number>): void {
  drag(from, { move: { values } });
}

/** Shows again what there is, after something that was tried is not kept. */
export function restore(): void {
  const window = windowNow();
  if (window !== undefined) void asked(doc.value, ofScene({ window }), "", "replace");
}

/** When the pointer moved to whose path is being put into the picture. */
export const moved = { at: 0 };

/** Shows what a drag does, while it goes on. */
export function drag(from: Doc, by: Change): void {
  const [began, window] = [performance.now(), windowNow()];
  if (window === undefined) return;
  engine.latest(
    from,
    ofScene({ window }, by),
    (reply) => {
      if (reply.window === undefined) return;
      moved.at = began;
      [shown.value, whole.value] = [reply, reply];
      // Seen in the browser's own tools: from the pointer to the frame that shows the path.
      requestAnimationFrame(() => performance.measure("carom-drag", { start: began }));
    },
    (error) => told(error, ""),
  );
}

/** Keeps what a drag came to. */
export async function drop(from: Doc): Promise<void> {
  await engine.idle();
  const { text, window } = shown.value;
  if (text === undefined || window === undefined || text === from.text) return;
  if (!(await asked({ ...from, text }, ofScene({ window }), "", "remember"))) restore();
}

/** One step after the other, however fast they are asked for. */
let travelling: Promise<void> = Promise.resolve();

function travel(from: typeof past, to: typeof past): Promise<void> {
  travelling = travelling.then(() => step(from, to));
  return travelling;
}

async function step(from: typeof past, to: typeof past): Promise<void> {
  await settled();
  // The first step back from text that is no scene is to the scene.
  const text = broken.value !== undefined;
  takeBack();
  if (text && from === past) return;
  const there = from.value.at(-1);
  if (there === undefined) return;
  const here = doc.value;
  const window = windowNow();
  const another = there.name !== here.name || window === undefined;
  if (!(await asked(there, ofScene(another ? around() : { window }), "", "replace"))) return;
  [from.value, to.value] = [from.value.slice(0, -1), [...to.value, here]];
}

export const undo = (): Promise<void> => travel(past, future);
export const redo = (): Promise<void> => travel(future, past);

/** Files that the engine writes of the scene. */
export async function filesOf(ask: "files" | "drawings"): Promise<Record<string, string>> {
  try {
    const reply = await engine.ask(doc.value, { study: ask });
    if (reply.failure !== undefined) failure.value = { ...reply.failure, tried: "" };
    return reply.files ?? {};
  } catch (error) {
    told(error, "");
    return {};
  }
}

/** One strike in full, as HTML. */
export async function strike(number: number): Promise<string> {
  try {
    return (await engine.ask(doc.value, { study: { strike: { number } } })).html ?? "";
  } catch (error) {
    told(error, "");
    return "";
  }
}

let search = 0;

/** Finds the limits of each quantity, one after the other, beside the engine that draws; a change of the scene begins anew. */
async function searchLimits(all: Quantity[]): Promise<void> {
  const own = ++search;
  const of = doc.value;
  const quantities = all.filter(({ written, unit }) => written && unit !== "count");
  const known = new Set(quantities.map(({ path }) => path));
  limits.value = new Map([...limits.value].filter(([path]) => known.has(path)));
  for (const { path, value } of quantities) {
    if (limits.value.get(path)?.text === of.text) continue;
    try {
      const { limit } = await searcher.ask(of, { study: { limit: { path } } });
      if (own !== search) return;
      if (limit !== undefined && limit !== null) limits.value = new Map(limits.value).set(path, { limit, value, text: of.text });
    } catch {
      return;
    }
  }
}

/** Opens what the page around, `carom studio` or the address gives, else the first example. */
export async function begin(): Promise<void> {
  let start = first;
  try {
    const given = hosted ? await byHost() : ((await served(location.hash)) ?? lessonOf(location.hash) ?? (await docOf(location.hash)));
    if (given === undefined && location.hash.length > 1) throw new Error("neither a file, a lesson nor a token");
    start = given ?? first;
  } catch {
    notice.value = "The link is damaged: it holds no scene that can be read. Here is an example instead.";
  }
  await openAsText(start, "replace");
  if (!hosted) return;
  outside = start;
  later(() => (following ??= follow()));
  effect(tellChange);
}

/** Opens a file. One with problems is shown as text, with its problems, beside the last picture there is. */
async function openAsText(next: Doc, keep: "remember" | "replace"): Promise<void> {
  if ((await open(next, keep)) || next === first) return;
  const wrong = failure.value;
  if (windowNow() === undefined) await open(first, "replace");
  [doc.value, failure.value] = [{ ...doc.value, name: next.name, files: next.files }, wrong === undefined ? undefined : { ...wrong, tried: "text" }];
  broken.value = next.text;
}

/** What the page around knows: the file that it gave last, or was told last. */
let outside: Doc | undefined;
const sameButText = (a: Doc, b: Doc): boolean => a.name === b.name && JSON.stringify(a.files) === JSON.stringify(b.files);

/** Tells the page around of a change that it does not know. A text with problems stays here, and so does what is on its way to a newer file. */
function tellChange(): void {
  const [now, text] = [doc.value, broken.value];
  if (following !== undefined || text !== undefined || outside === undefined || (now.text === outside.text && sameButText(now, outside))) return;
  outside = now;
  void tell(now);
}

/** The files of the page around are being followed. */
let following: Promise<void> | undefined;

/** Takes the files that the page around gave, one after the other; of those that came meanwhile, the newest. */
async function follow(): Promise<void> {
  for (let next = taken(); next !== undefined; next = taken()) {
    await settled();
    outside = next;
    if (sameButText(next, doc.value)) {
      await typed(next.text);
    } else {
      // Who set another file there has decided already.
      takeBack();
      await openAsText({ name: next.name, text: next.text, files: next.files }, "remember");
    }
  }
  following = undefined;
  tellChange();
}
