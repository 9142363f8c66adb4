// Who cannot see or use a pointer: what axe-core finds, in light and dark.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { after, before, test } from "node:test";
import { FILE, browser, measured, opened } from "./lib.mjs";

let chrome;
before(async () => {
  chrome = await browser();
});
after(() => chrome.close());

test("axe-core finds no violation", async () => {
  const axe = await readFile(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
  let rules = 0;
  for (const colorScheme of ["light", "dark"]) {
    const { page, close } = await opened(chrome, FILE, { colorScheme });
    await page.waitForFunction(() => document.querySelectorAll(".zone").length >= 8);
    await page.locator(".timeline button[data-strike='0']").click();
    await page.locator("#strike svg.impulse").waitFor();
    await page.evaluate(axe);
    const found = await page.evaluate(() => window.axe.run(document));
    const told = found.violations.map(({ id, nodes }) => `${id}: ${nodes.slice(0, 3).map((node) => node.html).join(" | ")}`);
    assert.deepEqual(told, [], `${colorScheme}: ${told.join("\n")}`);
    rules = found.passes.length;
    await close();
  }
  measured(`axe-core: no violation in light and dark, ${rules} rules pass`);
});
