// `carom studio` in a real browser: its own page works under its policy, and a foreign page gets nothing.
import assert from "node:assert/strict";
import { createServer } from "node:http";
import { test } from "node:test";
import { browser, headline, once, opened, studio, until } from "./lib.mjs";

const served = once(() => studio(["examples/bracket.toml"]));

test("the scene that was named opens, with the file that draws its part", async () => {
  const { page, complaints, close } = await opened((await served()).address);
  assert.equal(await page.locator("#scene").evaluate((select) => select.selectedOptions[0].textContent), "bracket.toml");
  assert.notEqual(await headline(page), "");
  assert.ok(!page.url().includes("token"), "the token does not stay in the address");
  await page.locator("#scene").selectOption("case_2.toml");
  await until(page, "turned on “lower”");
  assert.deepEqual(complaints, []);
  await close();
});

test("a foreign page cannot read the scene, with the token or without", async () => {
  const foreign = createServer((_, response) => response.setHeader("Content-Type", "text/html").end("<p>elsewhere</p>"));
  await new Promise((done) => foreign.listen(0, "127.0.0.1", done));
  const context = await (await browser()).newContext();
  const page = await context.newPage();
  await page.goto(`http://127.0.0.1:${foreign.address().port}/`);
  const [base, token] = (await served()).address.split("#token=");
  const read = await page.evaluate(
    async ([base, token]) => {
      const tried = [];
      for (const options of [{}, { headers: { "x-carom-token": token } }, { mode: "no-cors" }]) {
        try {
          tried.push((await (await fetch(`${base}scene`, options)).text()).length);
        } catch {
          tried.push("refused");
        }
      }
      return tried;
    },
    [base, token],
  );
  assert.ok(read.every((length) => length === "refused" || length === 0), `nothing is read: ${read}`);
  await context.close();
  foreign.close();
});
