// Files that are opened or dropped on the page.

import { drawnBy } from "./parts";
import { another, notice, open } from "./state";

/** A scene is opened; an outline becomes the part. */
export async function taken(file: File): Promise<void> {
  if (!/\.(toml|dxf|svg)$/i.test(file.name)) {
    notice.value = `${file.name} is neither a scene (.toml) nor the outline of a part (.dxf, .svg).`;
    return;
  }
  const text = await file.text();
  if (/\.(dxf|svg)$/i.test(file.name)) await another(drawnBy(file.name), { [file.name]: text });
  else await open({ name: file.name, text, files: {} });
}
