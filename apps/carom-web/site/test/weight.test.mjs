// How much a browser loads, how soon it shows, and how fast the engine is in it.
import assert from "node:assert/strict";
import { readFile, stat } from "node:fs/promises";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { gzipSync } from "node:zlib";
import { DIST, ROOT, browser, engine, measured, opened, serve } from "./lib.mjs";

let chrome;
let server;
before(async () => {
  [chrome, server] = await Promise.all([browser(), serve()]);
});
after(async () => {
  await chrome.close();
  server.close();
});

test("what a browser loads", async () => {
  const packed = async (name) => gzipSync(await readFile(join(DIST, "site", name)), { level: 9 }).length;
  const [engine, page, style] = await Promise.all(["carom.wasm", "studio.js", "studio.css"].map(packed));
  const single = (await stat(join(DIST, "single/carom-studio.html"))).size;
  const kilo = (bytes) => `${(bytes / 1e3).toFixed(0)} kB`;
  measured(`engine ${kilo(engine)}, page ${kilo(page)}, style ${kilo(style)}, each gzipped; the one file ${kilo(single)}`);
  assert.ok(page < 100e3, `the page's own script is ${page} bytes`);
});

test("how soon it shows", async () => {
  const { page, close } = await opened(chrome, server.address);
  const [paint, verdict] = await page.evaluate(() => [
    performance.getEntriesByName("first-contentful-paint")[0].startTime,
    performance.getEntriesByName("carom-first-verdict")[0].startTime,
  ]);
  measured(`first paint after ${paint.toFixed(0)} ms, first verdict after ${verdict.toFixed(0)} ms`);
  await close();
});

test("drops a second in one worker and by the command, in one run", async () => {
  const text = await readFile(join(ROOT, "examples/case_2.toml"), "utf8");
  const ask = await engine();
  const race = (runs) => {
    const began = performance.now();
    ask({ name: "case_2.toml", text, ask: { race: { runs } } });
    return (performance.now() - began) / runs;
  };
  race(5000);
  const inPage = Math.min(race(5000), race(5000), race(5000));
  measured(`${(1e3 / inPage).toFixed(0)} drops a second in one worker, ${(1e3 * inPage).toFixed(1)} µs each`);
  assert.ok(inPage > 0, "it took time");
});
