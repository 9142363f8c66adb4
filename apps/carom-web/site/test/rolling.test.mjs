// Bodies that roll and rock: their motion, their strikes, and region diagrams under the cursor.
import assert from "node:assert/strict";
import { test } from "node:test";
import { FILE, headline, opened, until } from "./lib.mjs";

async function roll(name) {
  const all = await opened(FILE);
  await all.page.locator("#scene").selectOption(name);
  await all.page.waitForFunction((name) => document.querySelector("#scene option").textContent === name, name);
  return all;
}

test("a cylinder meets a step, is played, and friction by its slider changes the strike", async () => {
  const { page, complaints, close } = await roll("roll_cylinder.toml");
  await until(page, "rolling at");
  assert.match(await page.locator("aside.words").textContent(), /1: separates at A, sticks at K/);
  await page.locator("#play").click();
  await page.waitForFunction(() => Number.parseFloat(document.querySelector("#clock").textContent) > 0);
  await page.locator("#play").click();
  await page.locator("tr[data-t]").nth(1).click();
  assert.match(await page.locator("#clock").textContent(), /^0\.235/, "a row moves the animation to its strike");
  await page.locator("#quantity-friction").fill("0.1");
  await page.locator("#quantity-friction").press("Enter");
  await page.waitForFunction(() => document.querySelector("aside.words").textContent.includes("2: separates at A, slips at K"));
  assert.equal(await page.locator("#add-plate").count(), 0, "a roll has no plates to draw");
  // A file that Carom cannot take says so at the field, and a value that may be left out goes with its line.
  await page.locator("#quantity-friction").fill("");
  await page.locator("#quantity-friction").press("Enter");
  await page.waitForFunction(() => !/^friction/m.test(document.querySelector(".source textarea").value));
  assert.match(await page.locator("aside.words").textContent(), /non-sliding law/);
  assert.deepEqual(complaints, []);
  await close();
});

test("a bolt from an STL file falls in a view that can be turned, and another file is thrown where it is dropped", async () => {
  const { page, complaints, close } = await roll("roll_body_bolt.toml");
  await until(page, "at rest");
  const seen = () => page.evaluate(() => document.querySelector("#solid").toDataURL().length);
  const before = await seen();
  const canvas = await page.locator("#solid").boundingBox();
  await page.mouse.move(canvas.x + 100, canvas.y + 100);
  await page.mouse.down();
  await page.mouse.move(canvas.x + 260, canvas.y + 150, { steps: 5 });
  await page.mouse.up();
  assert.notEqual(await seen(), before, "it is seen from elsewhere");
  await page.locator("#play").click();
  await page.waitForFunction(() => Number.parseFloat(document.querySelector("#clock").textContent) > 0);
  await page.locator("#quantity-turn").fill("40 deg");
  await page.locator("#quantity-turn").press("Enter");
  await page.waitForFunction(() => document.querySelector(".source textarea").value.includes("40 deg"));
  // A tetrahedron in binary form.
  const corners = [[0, 0, 0], [20, 0, 0], [0, 20, 0], [0, 0, 20]];
  const faces = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
  const bytes = Buffer.alloc(84 + 50 * faces.length);
  bytes.writeUInt32LE(faces.length, 80);
  faces.forEach((face, i) => face.forEach((corner, k) => corners[corner].forEach((x, axis) => bytes.writeFloatLE(x, 84 + 50 * i + 12 + 12 * k + 4 * axis))));
  await page.locator("input[type=file]").setInputFiles({ name: "tetrahedron.stl", mimeType: "model/stl", buffer: bytes });
  await page.waitForFunction(() => document.querySelector("aside.words").textContent.includes("tetrahedron.stl: 4 points"));
  await page.locator("#undo").click();
  await page.waitForFunction(() => document.querySelector(".source textarea").value.includes("bolt.stl"));
  assert.deepEqual(complaints, []);
  await close();
});

for (const [name, x, y] of [["roll_cylinder.toml", "friction", "step_height"], ["impact_step.toml", "contact.0.friction", "contact.1.friction"]]) {
  test(`the regions of ${name} are drawn, told under the cursor, and a click takes the values`, async () => {
    const { page, complaints, close } = await roll(name);
    await page.locator("#tab-map").click();
    await page.locator("#map-x").selectOption(x);
    await page.locator("#map-y").selectOption(y);
    await page.locator("#map-draw").click();
    await page.waitForFunction(() => document.querySelector(".map [role=status]").textContent.startsWith("drawn on 80"), undefined, { timeout: 60_000 });
    assert.ok((await page.locator("#map-picture path.region").count()) >= 2, "two outcomes at least");
    const plane = await page.locator("#map-picture rect.axis").boundingBox();
    await page.mouse.move(plane.x + 0.1 * plane.width, plane.y + 0.1 * plane.height);
    await page.waitForFunction(() => document.querySelector(".map .there").textContent.includes(": "));
    const before = await page.locator(".source textarea").inputValue();
    await page.mouse.click(plane.x + 0.1 * plane.width, plane.y + 0.95 * plane.height);
    await page.waitForFunction((before) => document.querySelector(".source textarea").value !== before, before);
    assert.equal(await page.locator("#tab-motion").getAttribute("aria-selected"), "true");
    assert.ok((await headline(page)).length > 0, "the impact or the roll is shown");
    await page.locator("#undo").click();
    await page.waitForFunction((before) => document.querySelector(".source textarea").value === before, before);
    assert.deepEqual(complaints, []);
    await close();
  });
}
