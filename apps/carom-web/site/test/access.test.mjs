// Who cannot see or use a pointer: what axe-core finds, in light and dark.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { test } from "node:test";
import { FILE, measured, opened } from "./lib.mjs";

/** What is looked at: how one comes there. */
const PLACES = {
  async strike(page) {
    await page.waitForFunction(() => document.querySelectorAll(".zone").length >= 8);
    await page.locator(".timeline button[data-strike='0']").click();
    await page.locator("#strike svg.impulse").waitFor();
  },
  async tolerances(page) {
    await page.locator("#scene").selectOption("designer.toml");
    await page.locator("#tab-surely").click();
    await page.locator(".tolerances input").first().waitFor();
  },
  async design(page) {
    await page.locator("#scene").selectOption("designer.toml");
    await page.locator("#tab-design").click();
    await page.locator("#search").click();
    await page.locator(".candidate").first().waitFor();
  },
  async lab(page) {
    await page.locator("#scene").selectOption("impact_cradle.toml");
    await page.locator("#lab").waitFor();
    await page.locator("#walk-next").click();
  },
  async lesson(page) {
    await page.locator("#lessons").selectOption("0");
    await page.locator(".lesson").waitFor();
    await page.locator(".markers").waitFor();
  },
  async roll(page) {
    await page.locator("#scene").selectOption("roll_cylinder.toml");
    await page.locator("tr[data-t]").first().waitFor();
  },
  async space(page) {
    await page.locator("#scene").selectOption("roll_stool.toml");
    await page.locator("#solid").waitFor();
  },
};

test("axe-core finds no violation", async () => {
  const axe = await readFile(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
  const rules = new Set();
  for (const colorScheme of ["light", "dark"]) {
    for (const [place, go] of Object.entries(PLACES)) {
      const { page, close } = await opened(FILE, { colorScheme });
      await go(page);
      await page.waitForTimeout(300);
      await page.evaluate(axe);
      const found = await page.evaluate(() => window.axe.run(document));
      const told = found.violations.map(({ id, nodes }) => `${id}: ${nodes.slice(0, 3).map((node) => node.html).join(" | ")}`);
      assert.deepEqual(told, [], `${place}, ${colorScheme}: ${told.join("\n")}`);
      found.passes.forEach(({ id }) => rules.add(id));
      await close();
    }
  }
  measured(`axe-core: no violation at ${Object.keys(PLACES).length} places in light and dark, ${rules.size} rules pass`);
});
