// The impact lab: contacts by the mouse, the walk stage by stage, every consistent outcome, laws and sharings side by side.
import assert from "node:assert/strict";
import { test } from "node:test";
import { FILE, headline, opened, until } from "./lib.mjs";

async function impact(name) {
  const all = await opened(FILE);
  await all.page.locator("#scene").selectOption(name);
  await all.page.waitForSelector("#lab");
  // The picture is as large as its room.
  await all.page.waitForFunction(() => {
    const sketch = document.querySelector("#lab svg.sketch");
    return Math.abs(sketch.viewBox.baseVal.width - sketch.parentElement.clientWidth) <= 1;
  });
  return all;
}

const text = (page) => page.locator(".source textarea").inputValue();
const written = (page, words) => page.waitForFunction((words) => document.querySelector(".source textarea").value.includes(words), words);

test("a contact is pulled, added and removed by the mouse, and undo brings all of it back", async () => {
  const { page, complaints, close } = await impact("impact_box.toml");
  await until(page, "left separates, right separates");
  const first = await text(page);
  // The left contact goes under the mass centre.
  const grip = await page.locator('[data-grip="contact.0-point"]').boundingBox();
  const [x, y] = [grip.x + grip.width / 2, grip.y + grip.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 60, y, { steps: 6 });
  await page.mouse.move(x + 120, y, { steps: 6 });
  await page.mouse.up();
  await page.waitForFunction((first) => document.querySelector(".source textarea").value !== first, first);
  assert.match(await text(page), /point {7}= \["-\d+ mm", "-20 mm"\]/, "the point is written in millimetres, on its level");
  // By the keyboard as well.
  await page.locator('[data-grip="contact.1-normal"]').focus();
  const pulled = await text(page);
  await page.keyboard.press("ArrowRight");
  await page.waitForFunction((pulled) => document.querySelector(".source textarea").value !== pulled, pulled);
  // One more, and away again.
  await page.locator("#add-contact").click();
  const paper = await page.locator("#lab svg.sketch").boundingBox();
  await page.mouse.click(paper.x + paper.width / 2, paper.y + paper.height * 0.85);
  await page.waitForSelector('[data-grip="contact.2-point"]');
  await page.locator('[data-grip="contact.2-point"]').click();
  await page.locator("#remove").click();
  await page.waitForFunction(() => document.querySelector('[data-grip="contact.2-point"]') === null);
  while (await page.locator("#undo").isEnabled()) {
    const before = await text(page);
    await page.locator("#undo").click();
    await page.waitForFunction((before) => document.querySelector(".source textarea").value !== before, before);
    if ((await text(page)) === first) break;
  }
  assert.equal(await text(page), first);
  assert.deepEqual(complaints, []);
  await close();
});

test("the walk goes on stage by stage, with the bodies and the marks in impulse space", async () => {
  const { page, close } = await impact("impact_bar.toml");
  const words = () => page.locator(".walk-view [role=status]").textContent();
  const mark = async () => page.locator(".markers circle").first().getAttribute("cx");
  assert.equal(await words(), "before the impact");
  const before = await mark();
  const speed = await page.locator(".velocity-name").first().textContent();
  await page.locator("#walk-next").click();
  assert.match(await words(), /^stage 1 of \d, its end; compression: K slips/);
  assert.notEqual(await mark(), before, "the mark moves in impulse space");
  await page.locator("#walk-play").click();
  await page.waitForFunction(() => /stage (\d) of \1, its end/.test(document.querySelector(".walk-view [role=status]").textContent));
  assert.notEqual(await page.locator(".velocity-name").first().textContent(), speed, "the body moves otherwise after it");
  await close();
});

test("friction by its slider decides whether a contact sticks, and laws and sharings stand side by side", async () => {
  const { page, close } = await impact("impact_step.toml");
  const laws = await page.locator(".beside").first().locator("tbody tr").count();
  assert.equal(laws, 3, "three laws");
  assert.equal(await page.locator(".beside").nth(1).locator("tbody tr").count(), 3, "three ways to share");
  assert.match(await page.locator("#hypotheses summary").textContent(), /consistent, \d+ hypotheses are rejected/);
  const was = await headline(page);
  const slider = page.locator('input[type=range][aria-label^="contact K: friction"]');
  await slider.focus();
  await page.keyboard.press("End");
  await written(page, "friction    = 0.8");
  await page.waitForFunction((was) => document.querySelector("#headline").textContent.trim().toLowerCase() !== was, was);
  await page.locator("#quantity-law").selectOption("newton");
  await written(page, '"newton"');
  await close();
});

test("Painlevé's rod is told: no motion under its weight, and the impact that friction forces", async () => {
  const { page, close } = await impact("contact_painleve.toml");
  assert.match(await headline(page), /no contact approaches, friction forces the impact/);
  assert.match(await page.locator("#forces-at-once .lead").textContent(), /^NO MOTION IS CONSISTENT/);
  assert.match(await page.locator("#hypotheses summary").textContent(), /2 end states are consistent/);
  await close();
});

test("a field with a bad value tells its problem, and the impact stays", async () => {
  const { page, close } = await impact("impact_bar.toml");
  await page.locator('[id="quantity-contact.0.restitution"]').fill("1.5");
  await page.locator('[id="quantity-contact.0.restitution"]').press("Enter");
  await page.waitForSelector(".quantity .wrong");
  assert.match(await page.locator(".quantity .wrong").textContent(), /must be from 0 to 1/);
  assert.ok(!(await text(page)).includes("1.5"), "the file stays");
  await close();
});

test("sliders write in the unit of the file, and undo keeps every step however fast it is asked for", async () => {
  const { page, close } = await impact("impact_bar.toml");
  const slider = page.locator('input[type=range][aria-label^="body: mass"]');
  await slider.focus();
  await page.keyboard.press("End");
  await written(page, 'mass     = "0.6 kg"');
  await page.keyboard.press("Control+z");
  await written(page, 'mass     = "0.3 kg"');
  for (const friction of ["0.16", "0.17", "0.18"]) {
    await page.locator('[id="quantity-contact.0.friction"]').fill(friction);
    await page.locator('[id="quantity-contact.0.friction"]').press("Enter");
    await written(page, `friction    = ${friction}`);
  }
  await page.evaluate(() => {
    document.querySelector("#undo").click();
    document.querySelector("#undo").click();
  });
  await written(page, "friction    = 0.16");
  await page.locator("#redo").click();
  await written(page, "friction    = 0.17");
  await page.locator("#redo").click();
  await written(page, "friction    = 0.18");
  // What was chosen of one file is not removed of another.
  await page.locator('[data-grip="contact.0-point"]').click();
  assert.equal(await page.locator("#remove").count(), 1);
  await page.locator("#scene").selectOption("impact_cradle.toml");
  await page.waitForSelector('[data-grip="contact.1-point"]');
  assert.equal(await page.locator("#remove").count(), 0);
  await close();
});

test("an impact in space is told, stage by stage", async () => {
  const { page, complaints, close } = await opened(FILE);
  await page.locator("#scene").selectOption("impact_twist.toml");
  await page.waitForSelector("#lab");
  assert.match(await page.locator("#lab .over").textContent(), /In space/);
  assert.ok((await page.locator(".stages-told li").count()) >= 2, "its stages");
  assert.match(await page.locator("aside.words").textContent(), /law · in space/);
  await page.locator('[id="quantity-contact.0.friction"]').fill("0.2");
  await page.locator('[id="quantity-contact.0.friction"]').press("Enter");
  await written(page, "friction    = 0.2");
  assert.deepEqual(complaints, []);
  await close();
});
