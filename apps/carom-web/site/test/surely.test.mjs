// How surely: the yield with its interval, the drops to look at, and work that can be stopped.
import assert from "node:assert/strict";
import { execFile } from "node:child_process";
import { test } from "node:test";
import { promisify } from "node:util";
import { CAROM, FILE, ROOT, measured, opened, until } from "./lib.mjs";

async function designer(options) {
  const page = await opened(FILE, options);
  await page.page.locator("#scene").selectOption("designer.toml");
  await page.page.waitForFunction(() => document.querySelector("#scene").selectedOptions[0].textContent === "designer.toml");
  await page.page.locator("#tab-surely").click();
  return page;
}

test("the yield is the command's, and a drop to look at is one click away", async () => {
  const { page, complaints, close } = await designer();
  await page.locator("#samples").selectOption("4096");
  await page.locator("#sample").click();
  await page.waitForFunction(() => document.querySelector(".surely [role=status]").textContent === "4096 drops");
  const shown = await page.locator(".surely .headline strong").textContent();
  const words = ["yield", "examples/designer.toml", "--samples", "4096", "--seed", "1", "--format", "json", "--out", "target/surely"];
  const { stdout } = await promisify(execFile)(CAROM, words, { cwd: ROOT, maxBuffer: 1 << 26 });
  const share = 100 * JSON.parse(stdout).yield.share;
  assert.ok(Math.abs(Number.parseFloat(shown) - share) < 0.006, `${shown} and ${share} %`);
  assert.ok((await page.locator(".surely table.matrix").count()) > 0, "from which face to which");
  await page.locator(".surely button[data-case='0']").click();
  await page.waitForFunction(() => document.querySelector("#scene").selectedOptions[0].textContent.startsWith("worst-"));
  assert.equal(await page.locator("#tab-motion").getAttribute("aria-selected"), "true");
  assert.deepEqual(complaints, []);
  await close();
});

test("a solid part goes through its feeder in a view that can be turned, and its yield is the command's", async () => {
  const { page, complaints, close } = await opened(FILE);
  await page.locator("#scene").selectOption("solid.toml");
  await page.locator("#solid").waitFor();
  await until(page, "turned on “lower”");
  const seen = () => page.evaluate(() => document.querySelector("#solid").toDataURL().length);
  const before = await seen();
  await page.locator("#solid").focus();
  for (let press = 0; press < 5; press += 1) await page.keyboard.press("ArrowLeft");
  assert.notEqual(await seen(), before, "it is seen from elsewhere");
  await page.getByLabel("friction").first().fill("0.5");
  await page.getByLabel("friction").first().press("Enter");
  await until(page, "stuck on “upper”");
  await page.locator("#undo").click();
  await until(page, "turned on “lower”");
  await page.locator("#tab-surely").click();
  await page.locator("#samples").selectOption("64");
  await page.locator("#sample").click();
  await page.waitForFunction(() => document.querySelector(".surely [role=status]").textContent === "64 drops", undefined, { timeout: 120_000 });
  const shown = await page.locator(".surely .headline strong").textContent();
  const words = ["yield", "examples/solid.toml", "--samples", "64", "--seed", "1", "--format", "json", "--out", "target/surely-solid"];
  const { stdout } = await promisify(execFile)(CAROM, words, { cwd: ROOT, maxBuffer: 1 << 26 });
  const share = 100 * JSON.parse(stdout).yield.share;
  assert.ok(Math.abs(Number.parseFloat(shown) - share) < 0.006, `${shown} and ${share} %`);
  await page.locator(".surely button[data-case='0']").click();
  await page.waitForFunction(() => document.querySelector("#scene").selectedOptions[0].textContent.startsWith("worst-"));
  await page.locator("#solid").waitFor();
  assert.deepEqual(complaints, []);
  await close();
});

test("several workers say what one says, and are faster", async () => {
  const found = async (workers) => {
    const { page, complaints, close } = await designer({ workers });
    await page.locator("#samples").selectOption("16384");
    const began = await page.evaluate(() => performance.now());
    await page.locator("#sample").click();
    await page.waitForFunction(() => document.querySelector(".surely [role=status]").textContent === "16384 drops");
    const seconds = ((await page.evaluate(() => performance.now())) - began) / 1e3;
    const html = await page.locator(".surely > div:last-child").innerHTML();
    assert.deepEqual(complaints, []);
    await close();
    return { html, seconds };
  };
  const [one, two, five] = [await found(1), await found(2), await found(5)];
  measured(`a yield of 16384 drops, with the smaller ones before it, in ${one.seconds.toFixed(1)} s by one worker and ${two.seconds.toFixed(1)} s by two: ${(one.seconds / two.seconds).toFixed(2)} times as fast`);
  assert.equal(two.html, one.html, "two workers");
  assert.equal(five.html, one.html, "five workers");
});

test("long work stops at once", async () => {
  const { page, complaints, close } = await designer();
  await page.locator("#samples").selectOption("262144");
  await page.locator("#sample").click();
  await page.locator(".surely .headline").waitFor();
  const waited = await page.evaluate(async () => {
    const began = performance.now();
    document.querySelector("#sample-stop").click();
    while (document.querySelector("#sample-stop") !== null) await new Promise((done) => requestAnimationFrame(done));
    return performance.now() - began;
  });
  measured(`long work stops within ${waited.toFixed(0)} ms`);
  assert.ok(await page.locator("#sample").isVisible(), "and can be begun again");
  assert.deepEqual(complaints, []);
  await close();
});

test("a scene without tolerances is told what to write", async () => {
  const { page, complaints, close } = await opened(FILE);
  await until(page, "turned");
  await page.locator("#tab-surely").click();
  await page.locator("#sample").click();
  await page.locator(".surely .wrong").waitFor();
  assert.match(await page.locator(".surely .wrong").textContent(), /toleranc/);
  assert.deepEqual(complaints, []);
  await close();
});

test("tolerances are set in one table, and the yield is of these", async () => {
  const { page, complaints, close } = await opened(FILE);
  await until(page, "turned");
  await page.locator("#tab-surely").click();
  const tolerance = page.getByLabel("tolerance of plate.upper.slope");
  await tolerance.fill("0.5");
  await tolerance.press("Enter");
  await page.waitForFunction(() => document.querySelector(".source textarea").value.includes('slope = "10 ± 0.5 deg"'));
  const friction = page.getByLabel("tolerance of contact.friction");
  await friction.fill("20 %");
  await friction.press("Enter");
  await page.waitForFunction(() => document.querySelector(".source textarea").value.includes('"0.15 ± 20 %"'));
  // A bad one is told in its row, and the scene stays.
  await friction.fill("-3");
  await friction.press("Enter");
  await page.waitForSelector(".tolerances .wrong");
  await tolerance.fill("");
  await tolerance.press("Enter");
  await page.waitForFunction(() => document.querySelector(".source textarea").value.includes('slope = "10 deg"'));
  await page.locator("#sample").click();
  await page.locator(".surely .headline").waitFor();
  assert.deepEqual(complaints, []);
  await close();
});
