// The examples of the project as scenes to begin with; the files that they name come along.

import type { Doc } from "./engine/protocol";

const texts = import.meta.glob<string>("../../../../examples/*.toml", { query: "?raw", import: "default", eager: true });
const outlines = import.meta.glob<string>("../../../../examples/*.dxf", { query: "?raw", import: "default", eager: true });

const surfaces = import.meta.glob<string>("../../../../examples/*.stl", { query: "?raw", import: "default", eager: true });

const nameOf = (path: string) => path.slice(path.lastIndexOf("/") + 1);
const ROLLS = /^roll_(cylinder|prism|rod)/;
const SOLIDS = /^roll_(pyramid|stool|body)/;
/** Impacts, and those whose contacts are asked under forces. */
const IMPACTS = /^(impact|contact)_/;

const files: Record<string, string> = Object.fromEntries(
  Object.entries({ ...outlines, ...surfaces }).map(([path, text]) => [nameOf(path), text]),
);

const all: Doc[] = Object.entries(texts)
  .map(([path, text]) => ({ name: nameOf(path), text }))
  .map(({ name, text }) => {
    const own = Object.entries(files).filter(([file]) => text.includes(file));
    return { name, text, files: Object.fromEntries(own) };
  });

/** Feeders by their file names. */
export const scenes: Doc[] = all.filter(({ name }) => !IMPACTS.test(name) && !name.startsWith("roll_"));
/** Impacts by their file names. */
export const impacts: Doc[] = all.filter(({ name }) => IMPACTS.test(name));
/** Bodies that roll and rock, by their file names. */
export const rolls: Doc[] = all.filter(({ name }) => ROLLS.test(name));
/** Bodies in space, by their file names. */
export const solids: Doc[] = all.filter(({ name }) => SOLIDS.test(name));

/** What the studio opens with. */
export const first: Doc = scenes.find(({ name }) => name === "case_2.toml") ?? { name: "scene.toml", text: "", files: {} };
