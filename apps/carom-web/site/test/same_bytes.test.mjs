// The module and the command say the same, byte for byte, of every example.
import assert from "node:assert/strict";
import { execFile } from "node:child_process";
import { mkdtemp, readFile, readdir, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { basename, join } from "node:path";
import { test } from "node:test";
import { promisify } from "node:util";
import { CAROM, ROOT, engine, measured } from "./lib.mjs";

const run = promisify(execFile);
const ROLLS = /^roll_(cylinder|prism|rod|pyramid|stool|body)/;
const IMPACTS = /^(impact|contact)_/;

/** The files that a command writes. */
async function written(words, folder) {
  await run(CAROM, [...words, "--out", folder], { cwd: ROOT });
  const found = await readdir(folder, { recursive: true, withFileTypes: true });
  const names = found.filter((entry) => entry.isFile()).map((entry) => join(entry.parentPath ?? entry.path, entry.name));
  return Object.fromEntries(await Promise.all(names.map(async (name) => [basename(name), await readFile(name, "utf8")])));
}

test("every example gives the same files in WebAssembly and by the command", async (t) => {
  const [ask, bench] = [await engine(), await engine("carom.wasm")];
  const all = await readdir(join(ROOT, "examples"));
  const names = all.filter((name) => name.endsWith(".toml"));
  const outlines = all.filter((name) => /\.(dxf|stl)$/.test(name));
  const files = Object.fromEntries(
    await Promise.all(outlines.map(async (name) => [`examples/${name}`, await readFile(join(ROOT, "examples", name), "utf8")])),
  );
  let compared = 0;
  let bytes = 0;
  for (const name of names) {
    const text = await readFile(join(ROOT, "examples", name), "utf8");
    const base = { name: `examples/${name}`, text, files };
    const folder = await mkdtemp(join(tmpdir(), "carom-"));
    const file = `examples/${name}`;
    const kind = ROLLS.exec(name)?.[1];
    const tasks = kind !== undefined ? [[["roll", kind, file], "files"]] : IMPACTS.test(name) ? [[["impact", file], "files"]] : [[["run", file], "files"]];
    // What is a solid has no drawing in the plane.
    if (tasks[0][0][0] === "run" && !name.startsWith("solid")) tasks.push([["draw", file], "drawings"]);
    for (const [words, request] of tasks) {
      const own = await written(words, join(folder, request));
      const question = { ...base, ask: { study: request } };
      const answer = ask(question);
      const first = bench(question);
      assert.ok(first.elsewhere === true || JSON.stringify(first) === JSON.stringify(answer), `${name}: the bench says the same or that somebody else knows`);
      assert.equal(answer.failure, undefined, `${name}: ${JSON.stringify(answer.failure)}`);
      for (const [file, content] of Object.entries(answer.files)) {
        assert.equal(content, own[file], `${name}: ${file} differs`);
        compared += 1;
        bytes += content.length;
      }
    }
    await rm(folder, { recursive: true });
  }
  assert.ok(names.length >= 40, `only ${names.length} examples were found`);
  measured(`${compared} files of ${names.length} examples are the same in WebAssembly and by the command, ${(bytes / 1e6).toFixed(1)} MB`);
});
