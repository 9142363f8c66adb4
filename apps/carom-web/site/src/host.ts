// The page within another page, which gives the file and hears how it changes: a cell of a notebook, say.
//
// The page around names its frame `carom-host` and, each time the frame is loaded, sends it `{ carom: "host" }` with a port. On that port both
// send files: `{ name, text, files }`.

import type { Doc } from "./engine/protocol";
import { isDoc } from "./link";

/** Whether a page around this one gives the file. Its own address is nobody's then. */
export const hosted = window.name === "carom-host" && window.parent !== window;

const port: Promise<MessagePort> = new Promise((got) => {
  addEventListener("message", ({ source, data, ports }: MessageEvent<unknown>) => {
    const [given] = ports;
    if (!hosted || source !== window.parent || given === undefined) return;
    if (typeof data === "object" && data !== null && (data as Record<string, unknown>).carom === "host") got(given);
  });
});

/** The newest file of the page around that nobody has taken yet, and who waits for one. */
let newest: Doc | undefined;
let hear: (() => void) | undefined;

/** The newest file that came and was not taken; undefined where none is. */
export function taken(): Doc | undefined {
  const doc = newest;
  newest = undefined;
  return doc;
}

/** The file that the page around gives first. */
export async function given(): Promise<Doc> {
  const at = await port;
  const first = new Promise<void>((came) => (hear = came));
  at.onmessage = ({ data }: MessageEvent<unknown>) => {
    if (!isDoc(data)) return;
    newest = data;
    hear?.();
  };
  await first;
  const doc = taken();
  if (doc === undefined) throw new Error("the page around gave no file");
  return doc;
}

/** What is done whenever a file has come, also one that came meanwhile. */
export function later(then: () => void): void {
  hear = then;
  if (newest !== undefined) then();
}

/** Tells the page around what the file is now. */
export async function tell({ name, text, files }: Doc): Promise<void> {
  (await port).postMessage({ name, text, files });
}
