// How much a browser loads, how soon it shows, and how fast the engine is in it.
import assert from "node:assert/strict";
import { execFile } from "node:child_process";
import { readFile, stat } from "node:fs/promises";
import { join } from "node:path";
import { test } from "node:test";
import { promisify } from "node:util";
import { gzipSync } from "node:zlib";
import { CAROM, DIST, ROOT, engine, measured, opened, server, shared } from "./lib.mjs";

test("what a browser loads", async () => {
  const packed = async (name) => gzipSync(await readFile(join(DIST, "site", name)), { level: 9 }).length;
  const [bench, whole, page, style] = await Promise.all(["carom.wasm", "carom-whole.wasm", "studio.js", "studio.css"].map(packed));
  const single = (await stat(join(DIST, "single/carom-studio.html"))).size;
  const kilo = (bytes) => `${(bytes / 1e3).toFixed(0)} kB`;
  measured(`the bench ${kilo(bench)}, the whole engine on demand ${kilo(whole)}, page ${kilo(page)}, style ${kilo(style)}, each gzipped; the one file ${kilo(single)}`);
  assert.ok(page < 100e3, `the page's own script is ${page} bytes`);
});

test("how soon it shows", async () => {
  const { page, close } = await opened((await server()).address);
  const [paint, verdict] = await page.evaluate(() => [
    performance.getEntriesByName("first-contentful-paint")[0].startTime,
    performance.getEntriesByName("carom-first-verdict")[0].startTime,
  ]);
  measured(`first paint after ${paint.toFixed(0)} ms, first verdict after ${verdict.toFixed(0)} ms`);
  await close();
});

test("drops a second in one worker and by the command on one thread, of one scene in one run", async () => {
  const name = "examples/designer.toml";
  const text = await readFile(join(ROOT, name), "utf8");
  const ask = await engine();
  const samples = 16384;
  const inPage = () => {
    const began = performance.now();
    shared(ask, { name, text }, { yield: { samples, seed: 1 } });
    return performance.now() - began;
  };
  inPage();
  const page = Math.min(inPage(), inPage(), inPage());
  const words = ["yield", name, "--samples", String(samples), "--seed", "1", "--format", "json", "--out", "target/weight"];
  const env = { ...process.env, RAYON_NUM_THREADS: "1" };
  const command = async () => JSON.parse((await promisify(execFile)(CAROM, words, { cwd: ROOT, env, maxBuffer: 1 << 26 })).stdout).run;
  const runs = [await command(), await command(), await command()];
  const { drops } = runs[0];
  const native = 1e3 * Math.min(...runs.map(({ seconds }) => seconds));
  const rate = (milliseconds) => Math.round((1e3 * drops) / milliseconds);
  measured(`${rate(page)} drops a second in one worker, ${rate(native)} by the command on one thread: 1 to ${(page / native).toFixed(2)}`);
  assert.ok(drops >= samples, `${drops} drops`);
});
