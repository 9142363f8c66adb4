// A scene as a link: its text, packed, after the mark of the address. No server sees it.

import type { Doc } from "./engine/protocol";

const MARK = "#scene=";

async function through(bytes: Uint8Array<ArrayBuffer>, by: GenericTransformStream): Promise<Uint8Array<ArrayBuffer>> {
  const stream = new Blob([bytes]).stream().pipeThrough(by);
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

export async function linkOf(doc: Doc): Promise<string> {
  const bytes = new TextEncoder().encode(JSON.stringify(doc));
  const packed = await through(bytes, new CompressionStream("deflate-raw"));
  let letters = "";
  for (const byte of packed) letters += String.fromCharCode(byte);
  return MARK + btoa(letters).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}

export function isDoc(value: unknown): value is Doc {
  if (typeof value !== "object" || value === null) return false;
  const { name, text, files } = value as Record<string, unknown>;
  if (typeof files !== "object" || files === null) return false;
  return typeof name === "string" && typeof text === "string" && Object.values(files).every((file) => typeof file === "string");
}

/** The scene of a link; undefined where the address has none, an error where it is broken. */
export async function docOf(address: string): Promise<Doc | undefined> {
  if (!address.startsWith(MARK)) return undefined;
  const letters = atob(address.slice(MARK.length).replaceAll("-", "+").replaceAll("_", "/"));
  const packed = Uint8Array.from(letters, (letter) => letter.charCodeAt(0));
  const bytes = await through(packed, new DecompressionStream("deflate-raw"));
  const value: unknown = JSON.parse(new TextDecoder().decode(bytes));
  if (!isDoc(value)) throw new Error("the link holds no scene");
  return value;
}

/** The scene that `carom studio` was started with; undefined where the address has no token, or it was started without one. */
export async function served(address: string): Promise<Doc | undefined> {
  const mark = "#token=";
  if (!address.startsWith(mark)) return undefined;
  const answer = await fetch("scene", { headers: { "x-carom-token": address.slice(mark.length) } });
  if (!answer.ok) return undefined;
  const value: unknown = await answer.json();
  if (!isDoc(value)) throw new Error("the server sent no scene");
  return value;
}
