// The page's side of the engine: asks a worker, starts another one where it died.

import type { Ask, Doc, Progress, Reply } from "./protocol";
import EngineWorker from "./worker?worker&inline";

/** The bench alone, which is loaded first, and the whole engine, which is loaded where the bench does not know. */
type Module = "carom.wasm" | "carom-whole.wasm";

/** A module's bytes: within the page where it is one file, beside it else. */
async function load(name: Module): Promise<WebAssembly.Module> {
  const within = document.getElementById(name)?.textContent;
  if (within === undefined || within === null) {
    return WebAssembly.compileStreaming(fetch(new URL(name, document.baseURI)));
  }
  const packed = Uint8Array.from(atob(within), (letter) => letter.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return WebAssembly.compile(await new Response(stream).arrayBuffer());
}

/** A worker that says nothing for so long is ended [ms]. */
const MOST_WAITED = 20_000;

const loaded = new Map<Module, Promise<WebAssembly.Module>>();

function engineModule(name: Module): Promise<WebAssembly.Module> {
  const loading = loaded.get(name) ?? load(name);
  loaded.set(name, loading);
  return loading;
}

interface Waiting {
  resolve: (reply: Reply) => void;
  reject: (error: Error) => void;
  hear: (progress: Progress) => void;
}

interface Said {
  id: number;
  answer?: string;
  died?: string;
  progress?: Progress;
}

/** A worker that did not answer: what it said last. The scene is the page's and is safe. */
export class EngineDied extends Error {}

export class Engine {
  private readonly workers = new Map<Module, Worker>();
  private readonly waiting = new Map<number, Waiting>();
  private next = 0;
  private stops = 0;
  private newest: { run: () => Promise<void> } | undefined;
  private draining: Promise<void> | undefined;

  constructor(private module: Module = "carom.wasm") {}

  /** Asks long work, and hears how far it is. */
  study(doc: Doc, ask: Ask, hear: (progress: Progress) => void = () => undefined): Promise<Reply> {
    return this.ask(doc, ask, Number.POSITIVE_INFINITY, hear);
  }

  /** Asks and waits, at most so long [ms]. */
  async ask(doc: Doc, ask: Ask, most = MOST_WAITED, hear: (progress: Progress) => void = () => undefined): Promise<Reply> {
    const reply = await this.once(this.module, doc, ask, most, hear);
    if (reply.elsewhere !== true) return reply;
    // The bench does not know: from now on the whole engine answers here. What the bench still works on it finishes.
    this.module = "carom-whole.wasm";
    return this.once(this.module, doc, ask, most, hear);
  }

  private async once(module: Module, doc: Doc, ask: Ask, most: number, hear: (progress: Progress) => void): Promise<Reply> {
    const { stops } = this;
    const worker = await this.started(module);
    // It may have been stopped while the module was loaded.
    if (stops !== this.stops) throw new EngineDied("stopped");
    const id = this.next++;
    return new Promise((resolve, reject) => {
      const late = Number.isFinite(most) ? setTimeout(() => this.stop(`it did not answer within ${most / 1000} s`), most) : undefined;
      const done = () => clearTimeout(late);
      this.waiting.set(id, {
        resolve: (reply) => (done(), resolve(reply)),
        reject: (error) => (done(), reject(error)),
        hear,
      });
      worker.postMessage({ id, request: JSON.stringify({ name: doc.name, text: doc.text, files: doc.files, ask }) });
    });
  }

  /** Asks what a pointer asks: only the newest of what waits is answered. */
  latest(doc: Doc, ask: Ask, done: (reply: Reply) => void, failed: (error: Error) => void): void {
    this.newest = { run: () => this.ask(doc, ask).then(done, failed) };
    this.draining ??= this.drain();
  }

  /** When all that [latest] was asked is answered. */
  async idle(): Promise<void> {
    await this.draining;
  }

  /** Ends what runs; who waits is told. */
  stop(reason = "stopped"): void {
    this.stops += 1;
    this.workers.forEach((worker) => worker.terminate());
    this.workers.clear();
    const waiting = [...this.waiting.values()];
    this.waiting.clear();
    waiting.forEach(({ reject }) => reject(new EngineDied(reason)));
  }

  private async drain(): Promise<void> {
    while (this.newest !== undefined) {
      const { run } = this.newest;
      this.newest = undefined;
      await run();
    }
    this.draining = undefined;
  }

  private async started(module: Module): Promise<Worker> {
    const engine = await engineModule(module);
    const running = this.workers.get(module);
    if (running !== undefined) return running;
    const worker = new EngineWorker();
    worker.postMessage(engine);
    worker.addEventListener("message", (event: MessageEvent<Said>) => {
      const { id, answer, died, progress } = event.data;
      const waiting = this.waiting.get(id);
      if (progress !== undefined) return waiting?.hear(progress);
      this.waiting.delete(id);
      if (answer !== undefined) waiting?.resolve(JSON.parse(answer) as Reply);
      if (died === undefined) return;
      waiting?.reject(new EngineDied(died));
      this.stop(died);
    });
    worker.addEventListener("error", (event) => this.stop(event.message));
    this.workers.set(module, worker);
    return worker;
  }
}
