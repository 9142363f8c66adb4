// Eight lessons: each asks a question, and what is done with the mouse or the keyboard answers it.
import assert from "node:assert/strict";
import { test } from "node:test";
import { FILE, opened } from "./lib.mjs";

async function value(page, path, text) {
  const field = page.locator(`[id="quantity-${path}"]`);
  await field.fill(text);
  await field.press("Enter");
  await page.waitForFunction(([path, text]) => document.getElementById(`quantity-${path}`).value === text, [path, text]);
}

/** What answers each lesson. */
const ANSWERS = {
  routh: (page) => value(page, "contact.0.friction", "1.2"),
  async types(page) {
    const found = (number) => page.waitForFunction((number) => document.querySelector(".question").textContent.match(/Found: (.*)\./)?.[1].includes(number), number);
    await found("1");
    await value(page, "body.velocity", '["0 m/s", "-1 m/s"]');
    await found("2");
    await value(page, "contact.0.friction", "0.6");
    await found("3");
    await value(page, "contact.0.friction", "0.1");
    await value(page, "body.velocity", '["-0.5 m/s", "-1 m/s"]');
  },
  painleve: (page) => value(page, "contact.0.friction", "1.34"),
  async energy(page) {
    await value(page, "contact.0.restitution", "1");
    await value(page, "contact.0.friction", "1");
  },
  cradle: (page) => page.locator("#quantity-sharing").selectOption("in sequence"),
  async wedge(page) {
    await value(page, "contact.0.friction", "0.5");
    await value(page, "contact.1.friction", "0.5");
  },
  rocking: (page) => value(page, "height", "34 mm"),
  async turn(page) {
    // The picture is as large as its room.
    await page.waitForFunction(() => {
      const picture = document.querySelector("#view-motion svg.layout");
      return Math.abs(picture.viewBox.baseVal.height - picture.parentElement.clientHeight) <= 1;
    });
    const box = await page.locator('[data-grip="1-middle"]').boundingBox();
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    await page.mouse.move(x, y);
    await page.mouse.down();
    for (let step = 1; step <= 60 && (await page.locator(".question.answered").count()) === 0; step += 1) {
      await page.mouse.move(x, y - 5 * step);
      await page.waitForTimeout(30);
    }
    await page.mouse.up();
  },
};

for (const [id, answer] of Object.entries(ANSWERS)) {
  test(`the lesson ${id} asks, is answered, and says why`, async () => {
    const { page, complaints, close } = await opened(`${FILE}#lesson=${id}`);
    await page.waitForSelector(".lesson .question");
    await page.waitForTimeout(300);
    assert.equal(await page.locator(".question.answered").count(), 0, "it is open at first");
    await answer(page);
    await page.waitForSelector(".question.answered");
    assert.ok((await page.locator(".lesson .why").count()) >= 1, "it says why");
    // The answer is a link: who opens it sees the lesson with what was done.
    await page.waitForFunction(() => location.hash.startsWith("#scene="));
    await page.waitForTimeout(200);
    const link = page.url();
    const other = await opened(link);
    await other.page.waitForSelector(".lesson .question");
    const text = (page) => page.locator(".source textarea").inputValue();
    assert.equal(await text(other.page), await text(page), "with what was done");
    await other.close();
    assert.deepEqual(complaints, []);
    await close();
  });
}

test("lessons follow each other, in large letters, and are closed", async () => {
  const { page, close } = await opened(FILE, { viewport: { width: 1280, height: 720 } });
  await page.locator("#lessons").selectOption("0");
  await page.waitForSelector(".lesson");
  for (let number = 2; number <= 8; number += 1) {
    await page.locator("#lesson-next").click();
    await page.waitForFunction((number) => document.querySelector(".lesson h2").textContent.trim().startsWith(`${number}.`), number);
  }
  await page.getByText("Large letters").click();
  const size = await page.locator(".lesson").evaluate((lesson) => Number.parseFloat(getComputedStyle(lesson).fontSize));
  assert.ok(size >= 22, `${size} px`);
  await page.getByText("Close the lesson").click();
  await page.waitForFunction(() => document.querySelector(".lesson") === null);
  await close();
});
