// The bench in a real browser, from a server with a strict policy and as one file from the disk.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { FILE, ROOT, headline, middle, measured, opened, server, until } from "./lib.mjs";

/** Drags a grip by so many pixels in small steps; `each` is called after every step and ends the drag where it answers true. */
async function drag(page, grip, [dx, dy], steps, each = () => false) {
  const box = await page.locator(`[data-grip="${grip}"]`).boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let step = 1; step <= steps; step += 1) {
    await page.mouse.move(x + (dx * step) / steps, y + (dy * step) / steps);
    if (await each()) break;
  }
  await page.mouse.up();
}

for (const [form, address] of [["a server", async () => (await server()).address], ["one file on the disk", () => FILE]]) {
  test(`from ${form}: case 2 turns, its lower plate is dragged until it does not, and all is undone`, async () => {
    const { page, complaints, close } = await opened(await address());
    assert.match(await headline(page), /^turned on “lower”/);
    const text = () => page.locator(".source textarea").inputValue();
    const first = await text();
    // The lower plate up, towards the upper one, until the verdict flips.
    await drag(page, "1-middle", [0, -300], 60, async () => {
      await page.waitForTimeout(20);
      return (await headline(page)).startsWith("same side");
    });
    await until(page, "same side");
    await page.waitForFunction((first) => document.querySelector(".source textarea").value !== first, first);
    // To the end of the motion, and back by one event.
    await page.locator("#scrub").fill("1000");
    const ended = Number.parseFloat(await page.locator("#clock").textContent());
    await page.locator("#back").click();
    assert.ok(Number.parseFloat(await page.locator("#clock").textContent()) < ended, "an event before the end");
    // All undone: the text is the first one, to the byte.
    while (await page.locator("#undo").isEnabled()) {
      await page.locator("#undo").click();
      await page.waitForTimeout(100);
    }
    await until(page, "turned");
    assert.equal(await text(), first);
    await page.locator("#redo").click();
    await until(page, "same side");
    assert.deepEqual(complaints, []);
    await close();
  });

  test(`from ${form}: a value is typed with unit and tolerance, and a wrong one is told at its field`, async () => {
    const { page, complaints, close } = await opened(await address());
    const field = page.getByLabel("slope").first();
    await field.fill("12 ± 0.5 deg");
    await field.press("Enter");
    await page.waitForFunction(() => document.querySelector(".source textarea").value.includes("12 ± 0.5 deg"));
    await field.fill("12 furlongs");
    await field.press("Enter");
    const wrong = page.locator(".wrong");
    await wrong.waitFor();
    assert.match(await wrong.textContent(), /furlongs|unit/);
    assert.equal(await field.getAttribute("aria-invalid"), "true");
    assert.ok((await page.locator(".source textarea").inputValue()).includes("12 ± 0.5 deg"), "the good scene stays");
    await field.fill("10 deg");
    await field.press("Enter");
    await page.waitForFunction(() => document.querySelector(".wrong") === null);
    // A default that the file does not write gets its line.
    const speed = page.getByLabel("speed", { exact: true }).first();
    await speed.fill("0.1 m/s");
    await speed.press("Enter");
    await page.waitForFunction(() => document.querySelector(".source textarea").value.includes('speed = "0.1 m/s"'));
    assert.deepEqual(complaints, []);
    await close();
  });

  test(`from ${form}: the drawing is exported as DXF in millimetres, and the scene is a link`, async () => {
    const { page, complaints, close } = await opened(await address());
    const [download] = await Promise.all([
      page.waitForEvent("download"),
      page.locator("#export").selectOption({ label: "Drawing, DXF" }),
    ]);
    const dxf = await readFile(await download.path(), "utf8");
    assert.equal(download.suggestedFilename(), "case_2-drawing.dxf");
    assert.match(dxf, /\$INSUNITS\r?\n\s*70\r?\n\s*4\r?\n/, "millimetres");
    assert.ok(dxf.includes("DIMENSION") && dxf.trimEnd().endsWith("EOF"), "dimensions, and a whole file");
    await page.getByLabel("friction").first().fill("0.16");
    await page.getByLabel("friction").first().press("Enter");
    await page.waitForFunction(() => document.querySelector(".source textarea").value.includes("0.16"));
    await page.waitForFunction(() => location.hash.startsWith("#scene="));
    await page.waitForTimeout(100);
    const link = page.url();
    const other = await opened(link);
    assert.ok((await other.page.locator(".source textarea").inputValue()).includes("0.16"), "the link holds the scene");
    assert.deepEqual([...complaints, ...other.complaints], []);
    await other.close();
    await close();
  });
}

test("stages and strikes are told, and one opens in full with its impulse diagram", async () => {
  const { page, complaints, close } = await opened(FILE);
  await page.locator(".timeline button[data-strike='0']").click();
  await page.locator("#strike svg.impulse").waitFor();
  assert.equal(await page.locator("#clock").textContent(), "1.1450 s");
  await page.locator(".timeline button[data-stage='2']").click();
  assert.match(await page.locator("#stage").textContent(), /3 flight/);
  await page.locator("#play").click();
  await page.waitForFunction(() => Number.parseFloat(document.querySelector("#clock").textContent) > 1.02);
  await page.locator("#play").click();
  assert.deepEqual(complaints, []);
  await close();
});

test("everything moves by the keyboard", async () => {
  const { page, complaints, close } = await opened(FILE);
  const before = await page.locator(".source textarea").inputValue();
  await page.locator('[data-grip="part-middle"]').focus();
  await page.keyboard.press("ArrowLeft");
  await page.waitForFunction((before) => document.querySelector(".source textarea").value !== before, before);
  await page.keyboard.press("Control+z");
  await page.waitForFunction((before) => document.querySelector(".source textarea").value === before, before);
  const field = page.getByLabel("slope").first();
  await field.focus();
  await page.keyboard.press("ArrowUp");
  await page.waitForFunction(() => document.querySelector(".source textarea").value.includes("11 deg"));
  assert.deepEqual(complaints, []);
  await close();
});

test("limits come to each quantity, and the worker that dies loses nothing", async () => {
  const { page, close } = await opened(FILE);
  await page.waitForFunction(() => document.querySelectorAll(".zone").length >= 8);
  const words = await page.getByLabel(/contact friction|contact.friction/).first().getAttribute("aria-label");
  assert.match(words, /flips below 0\.055158.*flips above 0\.17633/);
  const before = await page.locator(".source textarea").inputValue();
  // Both workers break, as a panic of the engine breaks them.
  for (const worker of page.workers()) await worker.evaluate(() => void setTimeout(() => { throw new Error("broken on purpose"); }));
  await page.waitForTimeout(200);
  await page.getByLabel("friction").first().fill("0.14");
  await page.getByLabel("friction").first().press("Enter");
  await page.waitForFunction(() => document.querySelector(".source textarea").value.includes("0.14"));
  await page.locator("#undo").click();
  await page.waitForFunction((before) => document.querySelector(".source textarea").value === before, before);
  await close();
});

test("every example opens, and a hostile name is text", async () => {
  const { page, complaints, close } = await opened(FILE);
  const names = await page.locator("#scene optgroup option").evaluateAll((all) => all.map((option) => option.value));
  assert.ok(names.length >= 18, `${names.length} examples`);
  for (const name of names) {
    await page.locator("#scene").selectOption(name);
    await page.waitForFunction((name) => document.querySelector("#scene").selectedOptions[0].textContent === name, name);
    assert.equal(await page.locator(".problems").count(), 0, name);
  }
  await page.locator("#scene").selectOption("case_2.toml");
  await until(page, "turned on “lower”");
  await page.locator(".source summary").click();
  const text = await page.locator(".source textarea").inputValue();
  await page.locator(".source textarea").fill(text.replace('"lower"', '"<marquee>boo"'));
  await page.locator(".source textarea").blur();
  await until(page, "<marquee>boo");
  assert.equal(await page.locator("marquee").count(), 0, "a name is text");
  assert.deepEqual(complaints, []);
  await close();
});

test("plates and walls are drawn and taken away, by the pointer and by the keyboard", async () => {
  const { page, complaints, close } = await opened(FILE);
  const text = () => page.locator(".source textarea").inputValue();
  const says = (words) => page.waitForFunction((words) => document.querySelector(".source textarea").value.includes(words), words);
  const paper = await page.locator("svg.scene").boundingBox();
  await page.locator("#add-wall").click();
  await page.mouse.move(paper.x + 0.9 * paper.width, paper.y + 0.1 * paper.height);
  await page.mouse.down();
  await page.mouse.move(paper.x + 0.92 * paper.width, paper.y + 0.5 * paper.height, { steps: 5 });
  await page.mouse.up();
  await says("[[wall]]");
  await page.locator('[data-grip="2-middle"]').focus();
  await page.locator("#remove").click();
  await page.waitForFunction(() => !document.querySelector(".source textarea").value.includes("[[wall]]"));
  await page.locator("#add-plate").focus();
  await page.keyboard.press("Enter");
  await says('name = "plate_3"');
  await page.locator("#undo").click();
  await page.waitForFunction(() => !document.querySelector(".source textarea").value.includes("plate_3"));
  assert.equal((await text()).match(/\[\[plate\]\]/g).length, 2);
  assert.deepEqual(complaints, []);
  await close();
});

test("text that is no scene is kept until it is mended or taken back, and told where it is wrong", async () => {
  const { page, complaints, close } = await opened(FILE);
  await page.locator(".source summary").click();
  const area = page.locator(".source textarea");
  const good = await area.inputValue();
  await area.fill(good.replace("[part]", "[part"));
  await page.locator(".problems").waitFor();
  assert.match(await page.locator(".problems").textContent(), /line 4/);
  const asked = page.waitForEvent("dialog").then((dialog) => dialog.dismiss());
  await page.locator("#scene").selectOption("disc.toml");
  await asked;
  assert.ok((await area.inputValue()).includes("[part\n"), "what was typed stays");
  await area.fill(good);
  await page.waitForFunction(() => document.querySelector(".problems") === null);
  await area.fill(`${good}\nnonsense`);
  await page.locator("#take-back").click();
  await page.waitForFunction((good) => document.querySelector(".source textarea").value === good, good);
  assert.deepEqual(complaints, []);
  await close();
});

test("a slider shows what it does while it moves, keeps the focus, and stays within what is allowed", async () => {
  const { page, complaints, close } = await opened(FILE);
  await page.waitForFunction(() => document.querySelectorAll(".zone").length >= 8);
  const slider = page.locator('input[type="range"][aria-label^="contact.friction"]');
  await slider.focus();
  for (let step = 0; step < 5; step += 1) await page.keyboard.press("ArrowRight");
  assert.equal(await page.evaluate(() => document.activeElement.getAttribute("type")), "range");
  await page.waitForFunction(() => !document.querySelector(".source textarea").value.includes("friction    = 0.15\n"));
  const box = await slider.boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + 2, box.y + box.height / 2, { steps: 10 });
  // Before it is let go.
  await until(page, "same side");
  await page.mouse.up();
  await page.waitForTimeout(300);
  for (const range of await page.locator(".zone input").all()) assert.equal(await range.evaluate((input) => Number(input.min) < Number(input.max)), true);
  assert.equal(await page.locator(".wrong").count(), 0);
  const restitution = page.locator('input[type="range"][aria-label^="contact.restitution"]');
  assert.equal(Number(await restitution.getAttribute("min")), 0, "no negative restitution");
  assert.ok(Number(await restitution.getAttribute("max")) > 0.01, "and a range that can be used");
  assert.deepEqual(complaints, []);
  await close();
});

test("a damaged link and a foreign file are told", async () => {
  const { page, complaints, close } = await opened(`${FILE}#scene=%%%`);
  assert.match(await page.locator(".told").textContent(), /link is damaged/);
  await page.locator("header input[type=file]").setInputFiles({ name: "part.png", mimeType: "image/png", buffer: Buffer.from("no scene") });
  await page.waitForFunction(() => document.querySelector(".told").textContent.includes("part.png is neither"));
  assert.deepEqual(complaints, []);
  await close();
});

test("the part is any kind of the library, or what a file draws", async () => {
  const { page, complaints, close } = await opened(FILE);
  const kinds = await page.locator("#part-kind option").count();
  for (let kind = 1; kind < kinds; kind += 1) {
    const before = await page.locator(".source textarea").inputValue();
    await page.locator("#part-kind").selectOption({ index: kind });
    await page.waitForFunction((before) => document.querySelector(".source textarea").value !== before, before);
    assert.equal(await page.locator(".wrong").count(), 0, `kind ${kind}`);
  }
  assert.ok(kinds >= 9, `${kinds} kinds`);
  await page.locator("header input[type=file]").setInputFiles(`${ROOT}/examples/bracket.dxf`);
  await page.waitForFunction(() => document.querySelector(".source textarea").value.includes('file = "bracket.dxf"'));
  assert.equal(await page.locator(".wrong, .problems").count(), 0, "the outline is read");
  assert.deepEqual(complaints, []);
  await close();
});

test("from the pointer to the path: within a frame", async () => {
  const { page, close } = await opened(FILE);
  const frames = await page.evaluate(() => {
    window.frames_ = 0;
    const count = () => { window.frames_ += 1; requestAnimationFrame(count); };
    requestAnimationFrame(count);
    return performance.now();
  });
  const counted = () => page.evaluate(() => [window.frames_, performance.now()]);
  await page.waitForTimeout(300);
  const [from, began] = await counted();
  await drag(page, "1-middle", [120, 60], 150, () => page.waitForTimeout(8).then(() => false));
  const [to, ended] = await counted();
  const delays = await page.evaluate(() => performance.getEntriesByName("carom-drag").map((entry) => entry.duration));
  const { median, p95 } = middle(delays);
  const work = middle(await page.evaluate(() => performance.getEntriesByName("carom-path").map((entry) => entry.duration)));
  measured(`from pointer to path in the picture, median ${work.median.toFixed(1)} ms, 95th percentile ${work.p95.toFixed(1)} ms; what follows waits for the next frame`);
  measured(`from pointer to the frame that shows the path, median ${median.toFixed(1)} ms, 95th percentile ${p95.toFixed(1)} ms, over ${delays.length} moves; ${((1000 * (to - from)) / (ended - began)).toFixed(0)} frames a second while dragging`);
  assert.ok(frames > 0 && delays.length > 50, `${delays.length} moves were drawn`);
  await close();
});

test("a part is drawn by its corners", async () => {
  const { page, complaints, close } = await opened(FILE);
  await page.waitForTimeout(300);
  await page.locator("#draw-part").click();
  const paper = await page.locator("#player svg.layout").boundingBox();
  const corners = [[0, 0], [0, 30], [60, 30], [60, 8], [40, 0]].map(([x, y]) => [paper.x + 200 + x, paper.y + 350 + y]);
  for (const [x, y] of corners) await page.mouse.click(x, y);
  await page.mouse.click(...corners[0]);
  await page.waitForFunction(() => document.querySelector(".source textarea").value.includes('shape = "polygon"'));
  const text = await page.locator(".source textarea").inputValue();
  assert.equal(text.match(/vertices = (.*)/)[1].split("], [").length, 5, "five corners");
  await page.locator("#undo").click();
  await until(page, "turned");
  assert.deepEqual(complaints, []);
  await close();
});
