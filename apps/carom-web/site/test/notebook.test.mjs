// The studio within another page: the widget of a notebook gives it a file and hears how the file changes.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { test } from "node:test";
import { browser, DIST, headline, once, ROOT, until } from "./lib.mjs";

const example = (name) => readFile(join(ROOT, "examples", name), "utf8");
const page = once(async () => {
  const context = await (await browser()).newContext({ viewport: { width: 900, height: 900 } });
  const page = await context.newPage();
  const complaints = [];
  page.on("console", (message) => message.type() === "error" && complaints.push(message.text()));
  page.on("pageerror", (error) => complaints.push(error.message));
  const widget = await readFile(join(ROOT, "apps/carom-py/python/carom/studio.js"), "utf8");
  const studio = await readFile(join(DIST, "single/carom-studio.html"), "utf8");
  // A model as notebooks give it to a widget, and a kernel that sends the page to who asks.
  await page.evaluate(
    async ([widget, studio]) => {
      class Model extends EventTarget {
        saved = 0;
        state = {};
        get = (key) => this.state[key];
        set(key, value) {
          if (JSON.stringify(this.state[key]) === JSON.stringify(value)) return;
          this.state[key] = value;
          this.dispatchEvent(new Event(`change:${key}`));
        }
        heard = new Map();
        on(name, hear) {
          const listen = ({ detail }) => hear(...(detail ?? []));
          this.heard.set(hear, listen);
          this.addEventListener(name, listen);
        }
        off = (name, hear) => this.removeEventListener(name, this.heard.get(hear));
        save_changes = () => (this.saved += 1);
        async send(message) {
          if (message.carom !== "page") return;
          const buffers = [new DataView(new TextEncoder().encode(studio).buffer)];
          this.dispatchEvent(new CustomEvent("msg:custom", { detail: [{ carom: "page" }, buffers] }));
        }
      }
      const { default: made } = await import(URL.createObjectURL(new Blob([widget], { type: "text/javascript" })));
      const model = new Model();
      const cell = document.body.appendChild(document.createElement("div"));
      Object.assign(globalThis, { model, cell, show: () => made.render({ model, el: cell }) });
    },
    [widget, studio],
  );
  return { page, complaints, close: () => context.close() };
});

/** Sets what the kernel would set, all at once. */
const set = (page, values) => page.evaluate((values) => Object.entries(values).forEach(([key, value]) => globalThis.model.set(key, value)), values);
const FRICTION = /(friction += ).*/;
const text = (page) => page.evaluate(() => globalThis.model.state.text);
const inner = async (page) => (await (await page.waitForSelector("iframe")).contentFrame());

test("the file that is given opens, and what is changed in the page is heard", async () => {
  const { page: outer, complaints } = await page();
  await set(outer, { name: "case_2.toml", text: await example("case_2.toml"), files: {}, height: 700 });
  await outer.evaluate(() => (globalThis.close = globalThis.show()));
  const frame = await inner(outer);
  await until(frame, "turned on “lower”");
  assert.equal(await outer.locator("iframe").evaluate((frame) => frame.clientHeight), 700);
  assert.equal(await frame.getByRole("button", { name: "Copy link" }).count(), 0, "the page has no address of its own");
  const friction = frame.locator('[id="quantity-contact.friction"]');
  await friction.fill("0.01");
  await friction.press("Enter");
  await until(frame, "same side");
  await outer.waitForFunction(() => /friction += 0\.01\n/.test(globalThis.model.state.text));
  assert.deepEqual(complaints, []);
});

test("what is set outside is shown in the page, and nothing echoes", async () => {
  const { page: outer, complaints } = await page();
  const frame = await inner(outer);
  const saved = () => outer.evaluate(() => globalThis.model.saved);
  const before = await saved();
  await set(outer, { text: (await text(outer)).replace(FRICTION, "$10.15") });
  await until(frame, "turned on “lower”");
  await set(outer, { name: "bracket.toml", text: await example("bracket.toml"), files: { "bracket.dxf": await example("bracket.dxf") } });
  await until(frame, "face");
  assert.equal(await frame.locator("#scene").evaluate((select) => select.selectedOptions[0].textContent), "bracket.toml");
  assert.ok((await saved()) - before <= 2, "each file is told back at most once");
  await frame.locator("#undo").click();
  await until(frame, "turned on “lower”");
  await outer.waitForFunction(() => globalThis.model.state.name === "case_2.toml");
  assert.deepEqual(complaints, []);
});

test("text with problems is shown as text, and the scene before it stays", async () => {
  const { page: outer, complaints } = await page();
  const frame = await inner(outer);
  const good = await text(outer);
  await set(outer, { text: good.replace("friction", "fricton") });
  await frame.waitForFunction(() => document.querySelector(".told .problems, .source .problems")?.textContent.includes("fricton"));
  assert.match(await headline(frame), /turned/);
  await set(outer, { text: good });
  await frame.waitForFunction(() => document.querySelector(".told .problems, .source .problems") === null);
  assert.deepEqual(complaints, []);
});

test("a cell that is moved shows the same file again; one that is closed hears nothing more", async () => {
  const { page: outer, complaints } = await page();
  await outer.evaluate(() => document.body.appendChild(document.createElement("section")).append(globalThis.cell));
  const frame = await inner(outer);
  await until(frame, "turned on “lower”");
  await set(outer, { text: (await text(outer)).replace(FRICTION, "$10.01") });
  await until(frame, "same side");
  await outer.evaluate(() => globalThis.close());
  await set(outer, { text: await example("case_1_box.toml") });
  await outer.waitForTimeout(300);
  assert.match(await headline(frame), /same side/);
  assert.deepEqual(complaints, []);
});

test("a first file with problems stays what it is outside, and one that comes while the page starts is not lost", async () => {
  const { page: outer, complaints } = await page();
  const good = await example("case_2.toml");
  const broken = good.replace("friction", "fricton");
  const again = async (first) => {
    await outer.evaluate(() => globalThis.cell.replaceChildren());
    await set(outer, { name: "mine.toml", text: first, files: {} });
    await outer.evaluate(() => (globalThis.close = globalThis.show()));
  };
  await again(broken);
  const frame = await inner(outer);
  await frame.waitForFunction(() => document.querySelector(".told .problems, .source .problems")?.textContent.includes("fricton"));
  assert.equal(await text(outer), broken);
  await set(outer, { text: good });
  await until(frame, "turned on “lower”");
  assert.equal(await text(outer), good);
  await outer.evaluate(() => globalThis.close());
  // The frame has been given the first text, and has not answered yet.
  await again(good);
  const next = await inner(outer);
  await next.waitForFunction(() => document.querySelector(".opening, .studio") !== null);
  const slow = good.replace(FRICTION, "$10.01");
  await set(outer, { text: slow });
  await until(next, "same side");
  // Three in a row: the last one stays, and none of the others is told back.
  for (const friction of ["0.12", "0.13", "0.15"]) await set(outer, { text: good.replace(FRICTION, `$1${friction}`) });
  await until(next, "turned on “lower”");
  await outer.waitForTimeout(300);
  assert.match(await text(outer), /friction += 0\.15\n/);
  await outer.evaluate(() => globalThis.close());
  assert.deepEqual(complaints, []);
});
