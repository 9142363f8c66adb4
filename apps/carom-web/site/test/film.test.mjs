// The motion as a film that the browser records.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { FILE, opened, server } from "./lib.mjs";

for (const name of ["case_2.toml", "roll_rod.toml", "roll_body_bolt.toml"]) {
  test(`${name} as a film`, async () => {
    const { page, complaints, close } = await opened((await server()).address);
    await page.locator("#scene").selectOption(name);
    await page.waitForFunction((name) => document.querySelector("#scene option").textContent === name, name);
    await page.waitForTimeout(500);
    // Fast, so that the film is short.
    await page.locator("#speed").selectOption(name.startsWith("roll_body") ? "0.05" : name.startsWith("roll") ? "0.2" : "1");
    const download = page.waitForEvent("download");
    await page.locator("#export").selectOption({ label: "Film of the motion, WebM" });
    const file = await download;
    assert.equal(file.suggestedFilename(), name.replace("toml", "webm"));
    const bytes = await readFile(await file.path());
    // The mark of every WebM file, and more than one picture.
    assert.deepEqual([...bytes.subarray(0, 4)], [0x1a, 0x45, 0xdf, 0xa3]);
    assert.ok(bytes.length > 5000, `${bytes.length} bytes`);
    // It plays, and shows something else at its end than at its beginning.
    // The page's own policy lets no film in: the one from the disk has none.
    const theatre = await opened(FILE);
    const differs = await theatre.page.evaluate(async (address) => {
      const video = document.createElement("video");
      video.muted = true;
      video.src = address;
      await new Promise((done, failed) => ((video.onloadeddata = done), (video.onerror = () => failed(new Error("it does not play")))));
      const seen = (time) =>
        new Promise((done) => {
          video.onseeked = () => {
            const canvas = document.createElement("canvas");
            [canvas.width, canvas.height] = [video.videoWidth, video.videoHeight];
            canvas.getContext("2d").drawImage(video, 0, 0);
            done(canvas.toDataURL());
          };
          video.currentTime = time;
        });
      return (await seen(0.05)) !== (await seen(0.6));
    }, `data:video/webm;base64,${bytes.toString("base64")}`);
    assert.ok(differs, "it shows something else at its end");
    await theatre.close();
    assert.deepEqual(complaints, []);
    await close();
  });
}
