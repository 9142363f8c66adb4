// The engine in its worker: one request in, one answer out.

interface Exports {
  memory: WebAssembly.Memory;
  carom_room(length: number): number;
  carom_answer(): number;
  carom_place(): number;
  carom_length(): number;
}

let engine: Exports | undefined;

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
    engine = new WebAssembly.Instance(event.data, {}).exports as unknown as Exports;
    return;
  }
  const { id, request } = event.data;
  try {
    self.postMessage({ id, answer: answer(request) });
  } catch (error) {
    // After a panic the module's memory still holds its last words.
    const words = engine === undefined ? "" : read(engine.carom_place(), engine.carom_length());
    self.postMessage({ id, died: words || String(error) });
  }
});
