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

let hear: (doc: Doc) => void = () => undefined;

/** The file that the page around gives first. */
export async function given(): Promise<Doc> {
  const at = await port;
  return new Promise((first) => {
    hear = first;
    at.onmessage = ({ data }: MessageEvent<unknown>) => {
      if (isDoc(data)) hear(data);
    };
  });
}

/** What is done with each file that comes later. */
export function later(then: (doc: Doc) => void): void {
  hear = then;
}

/** Tells the page around what the file is now. */
export async function tell({ name, text, files }: Doc): Promise<void> {
  (await port).postMessage({ name, text, files });
}
