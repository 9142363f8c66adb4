// The map: boundaries that sharpen, the outcome under the pointer, and the design under a click.
import assert from "node:assert/strict";
import { test } from "node:test";
import { FILE, headline, opened, until } from "./lib.mjs";

test("a map is drawn, the outcome under the pointer is told, and a click takes that design", async () => {
  const { page, complaints, close } = await opened(FILE);
  await page.waitForFunction(() => document.querySelectorAll(".zone").length >= 8);
  await page.locator("#tab-map").click();
  await page.locator("#map-x").selectOption("contact.friction");
  await page.locator("#map-y").selectOption("plate.upper.slope");
  await page.locator("#map-draw").click();
  await page.waitForFunction(() => document.querySelector(".map [role=status]").textContent.startsWith("drawn on 80"));
  const regions = await page.locator("#map-picture path.region").count();
  assert.ok(regions >= 2, `${regions} outcomes`);
  assert.match(await page.locator("#map-picture").textContent(), /the scene/, "the present design is marked");
  // From the left to the right: more than one outcome is told.
  const plane = await page.locator("#map-picture rect.axis").boundingBox();
  const told = new Map();
  for (let step = 1; step < 40; step += 1) {
    const x = plane.x + (plane.width * step) / 40;
    await page.mouse.move(x, plane.y + plane.height / 2);
    await page.waitForTimeout(30);
    const words = await page.locator(".map .there").textContent();
    told.set(words.split(": ").at(-1), x);
  }
  assert.ok(told.size >= 2, `outcomes told: ${[...told.keys()]}`);
  const other = [...told.keys()].find((words) => !words.startsWith("turned"));
  await page.mouse.click(told.get(other), plane.y + plane.height / 2);
  await until(page, other.split(" on ")[0]);
  assert.equal(await page.locator("#tab-motion").getAttribute("aria-selected"), "true");
  await page.locator("#undo").click();
  await until(page, "turned");
  assert.match(await headline(page), /turned/);
  assert.deepEqual(complaints, []);
  await close();
});
