// Design: what may be chosen and must be kept, the search as it goes on, and the winner that is taken.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtemp, readFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { CAROM, FILE, ROOT, engine, headline, measured, opened, until } from "./lib.mjs";

async function designing(scene) {
  const all = await opened(FILE);
  await all.page.locator("#scene").selectOption(scene);
  await all.page.waitForFunction((scene) => document.querySelector("#scene option").textContent === scene, scene);
  await all.page.locator("#tab-design").click();
  return all;
}

test("a layout is searched with progress, the winner is taken, and undo brings the scene back", async () => {
  const { page, complaints, close } = await designing("designer.toml");
  const before = await page.locator(".source textarea").inputValue();
  await page.locator("#search").click();
  await page.waitForSelector(".design progress");
  await page.waitForFunction(() => /look [3-9] of 9, \d{4,} drops/.test(document.querySelector(".design [role=status]").textContent));
  assert.match(await page.locator(".candidate h2").first().textContent(), /best so far/, "the best so far is seen while it goes on");
  await page.waitForSelector(".design .headline", { timeout: 120_000 });
  assert.equal(await page.locator(".design .headline").textContent(), "Possible");
  assert.match(await page.locator(".design .lead").textContent(), /^9\d\.\d\d % /, "most drops end as wanted");
  assert.ok((await page.locator(".candidate path").count()) >= 2, "candidates have pictures");
  await page.locator(".candidate button").first().click();
  await page.locator("#tab-motion[aria-selected=true]").waitFor();
  await until(page, "turned");
  const taken = await page.locator(".source textarea").inputValue();
  assert.notEqual(taken, before, "the winner is another layout");
  await page.locator("#undo").click();
  await page.waitForFunction((text) => document.querySelector(".source textarea").value === text, before);
  assert.deepEqual(complaints, []);
  await close();
});

test("limits, ranges, wants and the aim are written into the scene, and what is wrong is told there", async () => {
  const { page, close } = await designing("case_2.toml");
  const text = () => page.locator(".source textarea").inputValue();
  await page.locator(".asked select").nth(1).selectOption("turned");
  await page.waitForFunction(() => document.querySelector(".source textarea").value.includes('want = "turned"'));
  await page.locator("#choose").selectOption("plate.upper.slope");
  await page.waitForFunction(() => document.querySelector(".source textarea").value.includes('"plate.upper.slope" = '));
  await page.getByLabel("strikes at most").fill("2.5");
  await page.getByLabel("strikes at most").press("Enter");
  await page.waitForFunction(() => document.querySelector(".source textarea").value.includes('max_impact_speed = "2.5 m/s"'));
  await page.getByLabel("plate.upper.slope at most").fill("200");
  await page.getByLabel("plate.upper.slope at most").press("Enter");
  await page.waitForSelector(".design > .wrong");
  assert.match(await page.locator(".design > .wrong").textContent(), /plate\.upper\.slope.*reaches 200 deg/);
  assert.ok(!(await text()).includes("200"), "the scene stays as it was");
  // Nothing has a tolerance: the search says so, and what to write.
  await page.locator("#search").click();
  await page.waitForFunction(() => [...document.querySelectorAll(".design > .wrong")].some((list) => list.textContent.includes("tolerance")));
  assert.match(await headline(page), /turned/);
  await close();
});

test("a search can be stopped, and the best so far can be taken", async () => {
  const { page, close } = await designing("designer.toml");
  await page.locator("#search").click();
  await page.waitForSelector(".candidate");
  const began = performance.now();
  await page.locator("#search-stop").click();
  await page.waitForSelector("#search");
  measured(`a design stops ${(performance.now() - began).toFixed(0)} ms after it is told to`);
  assert.match(await page.locator(".design [role=status]").textContent(), /stopped/);
  await page.locator(".candidate button").click();
  await until(page, "turned");
  await close();
});

test("the files of a winner are the command's, byte for byte", async () => {
  const folder = await mkdtemp(join(tmpdir(), "carom-design-"));
  execFileSync(CAROM, ["design", "examples/designer.toml", "--scan", "64", "--samples", "64", "--out", folder], { cwd: ROOT });
  const ask = await engine();
  const text = await readFile(join(ROOT, "examples/designer.toml"), "utf8");
  const { found } = ask({ name: "designer.toml", text, ask: { study: { design: { scan: 64, samples: 64, seed: 1 } } } });
  const names = Object.keys(found.files);
  assert.deepEqual(names.sort(), ["design.toml", "drawing.dxf", "drawing.svg", "report.html"]);
  for (const name of names) {
    const own = await readFile(join(folder, "design", name), "utf8").catch(() => readFile(join(folder, "designer/design", name), "utf8"));
    assert.equal(found.files[name], own, `${name} is the command's`);
  }
});
