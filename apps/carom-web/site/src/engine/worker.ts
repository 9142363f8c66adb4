// The engine in its worker: one request in, one answer out.

interface Exports {
  memory: WebAssembly.Memory;
  carom_room(length: number): number;
  carom_answer(): number;
  carom_place(): number;
  carom_length(): number;
}

let engine: Exports | undefined;

/** The request that is worked on, drops so far, and when the page heard of them last [ms]. */
const work = { id: 0, steps: 0, heard: 0 };
/** The page hears so often [ms], and the clock is asked once in so many drops. */
const PAUSE = 100;
const LOOK = 16;

function tell(news?: unknown): void {
  work.heard = performance.now();
  self.postMessage({ id: work.id, progress: { steps: work.steps, ...(news === undefined ? {} : { news }) } });
}

/** What the engine calls while it works. */
const page = {
  step(): void {
    work.steps += 1;
    if (work.steps % LOOK === 0 && performance.now() - work.heard > PAUSE) tell();
  },
  told: (place: number, length: number): void => tell(JSON.parse(read(place, length))),
};

function read(place: number, length: number): string {
  if (engine === undefined) return "";
  return new TextDecoder().decode(new Uint8Array(engine.memory.buffer, place, length));
}

function answer(request: string): string {
  if (engine === undefined) throw new Error("the engine has not been loaded");
  const bytes = new TextEncoder().encode(request);
  // Room first: it may move the memory.
  const room = engine.carom_room(bytes.length);
  new Uint8Array(engine.memory.buffer, room, bytes.length).set(bytes);
  const length = engine.carom_answer();
  return read(engine.carom_place(), length);
}

self.addEventListener("message", (event: MessageEvent<WebAssembly.Module | { id: number; request: string }>) => {
  if (event.data instanceof WebAssembly.Module) {
    engine = new WebAssembly.Instance(event.data, { page }).exports as unknown as Exports;
    return;
  }
  const { id, request } = event.data;
  Object.assign(work, { id, steps: 0, heard: performance.now() });
  try {
    self.postMessage({ id, answer: answer(request) });
  } catch (error) {
    // After a panic the module's memory still holds its last words.
    const words = engine === undefined ? "" : read(engine.carom_place(), engine.carom_length());
    self.postMessage({ id, died: words || String(error) });
  }
});
