// Files that are opened or dropped on the page.

import { drawnBy, thrown } from "./parts";
import { another, notice, open } from "./state";

/** The bytes of a file, a letter for each. */
async function bytesOf(file: File): Promise<string> {
  let letters = "";
  for (const byte of new Uint8Array(await file.arrayBuffer())) letters += String.fromCharCode(byte);
  return letters;
}

/** A file that says what it is about is opened; an outline becomes the part, and a surface is thrown. */
export async function taken(file: File): Promise<void> {
  if (!/\.(toml|dxf|svg|stl)$/i.test(file.name)) {
    notice.value = `${file.name} is neither a file of Carom (.toml) nor the outline of a part (.dxf, .svg) nor a surface (.stl).`;
    return;
  }
  if (/\.stl$/i.test(file.name)) {
    const text = `${thrown(file.name)}\n`;
    await open({ name: file.name.replace(/\.stl$/i, ".toml"), text, files: { [file.name]: await bytesOf(file) } });
    return;
  }
  const text = await file.text();
  if (/\.(dxf|svg)$/i.test(file.name)) await another(drawnBy(file.name), { [file.name]: text });
  else await open({ name: file.name, text, files: {} });
}
