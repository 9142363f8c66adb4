// Files that are opened or dropped on the page.

import { drawnBy } from "./parts";
import { another, open } from "./state";

/** A scene is opened; an outline becomes the part. */
export async function taken(file: File): Promise<void> {
  const text = await file.text();
  if (/\.(dxf|svg)$/i.test(file.name)) await another(drawnBy(file.name), { [file.name]: text });
  else await open({ name: file.name, text, files: {} });
}
