// The examples of the project as scenes to begin with; the files that they name come along.

import type { Doc } from "./engine/protocol";

const texts = import.meta.glob<string>("../../../../examples/*.toml", { query: "?raw", import: "default", eager: true });
const outlines = import.meta.glob<string>("../../../../examples/*.dxf", { query: "?raw", import: "default", eager: true });

const nameOf = (path: string) => path.slice(path.lastIndexOf("/") + 1);
const OTHER_TASKS = /^(impact|roll|contact)_/;

const files: Record<string, string> = Object.fromEntries(
  Object.entries(outlines).map(([path, text]) => [nameOf(path), text]),
);

/** Scenes by their file names. */
export const scenes: Doc[] = Object.entries(texts)
  .map(([path, text]) => ({ name: nameOf(path), text }))
  .filter(({ name }) => !OTHER_TASKS.test(name))
  .map(({ name, text }) => {
    const own = Object.entries(files).filter(([file]) => text.includes(file));
    return { name, text, files: Object.fromEntries(own) };
  });

/** What the studio opens with. */
export const first: Doc = scenes.find(({ name }) => name === "case_2.toml") ?? { name: "scene.toml", text: "", files: {} };
