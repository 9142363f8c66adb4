// What the tests share: the browser, the page in both of its forms, and the engine without a page.
import { spawn } from "node:child_process";
import { readFile } from "node:fs/promises";
import { createServer } from "node:http";
import { extname, join, normalize } from "node:path";
import { after } from "node:test";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";

export const ROOT = fileURLToPath(new URL("../../../..", import.meta.url));
/** The command, built with the studio in it. */
export const CAROM = join(process.env.CARGO_TARGET_DIR ?? join(ROOT, "target"), "release/carom");
export const DIST = fileURLToPath(new URL("../dist", import.meta.url));

/** A figure for the closing lines of the check. */
export const measured = (words) => console.log(`measured: ${words}`);

const TYPES = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".wasm": "application/wasm" };
const POLICY = "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; img-src data:; connect-src 'self'; worker-src blob:";

/** A plain web server for the folder, as strict as a page can be served. */
async function serve() {
  const server = createServer(async (request, response) => {
    const path = normalize(new URL(request.url, "http://x").pathname).replace(/^\/$/, "/index.html");
    try {
      const body = await readFile(join(DIST, "site", path));
      response.writeHead(200, { "Content-Type": TYPES[extname(path)] ?? "text/plain", "Content-Security-Policy": POLICY });
      response.end(body);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((done) => server.listen(0, "127.0.0.1", done));
  return { address: `http://127.0.0.1:${server.address().port}/`, close: () => server.close() };
}

/** What a file of tests has once, from where it first needs it until its tests are done. */
export function once(begin) {
  let begun;
  after(async () => (await begun)?.close());
  return () => (begun ??= begin());
}

/** The plain server. */
export const server = once(serve);

/** The page as one file on the disk. */
export const FILE = `file://${join(DIST, "single/carom-studio.html")}`;

export const browser = once(() => {
  const executablePath = process.env.CHROMIUM ?? "/usr/bin/chromium";
  const quiet = ["--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking"];
  return chromium.launch({ executablePath, args: ["--no-sandbox", "--disable-component-update", "--disable-sync", ...quiet] });
});

/** A page that fails its test where the browser complains. */
export async function opened(address, { workers, ...options } = {}) {
  const context = await (await browser()).newContext({ viewport: { width: 1400, height: 900 }, ...options });
  const page = await context.newPage();
  // A machine with so many cores.
  if (workers !== undefined) await page.addInitScript((cores) => Object.defineProperty(navigator, "hardwareConcurrency", { value: cores }), workers);
  const complaints = [];
  page.on("console", (message) => message.type() === "error" && complaints.push(message.text()));
  page.on("pageerror", (error) => complaints.push(error.message));
  await page.goto(address);
  await page.waitForSelector("#headline");
  return { page, complaints, close: () => context.close() };
}

/** The headline of the page, in lower case. */
export const headline = async (page) => (await page.locator("#headline").textContent()).trim().toLowerCase();

/** Waits until the headline is so. */
export const until = (page, words) =>
  page.waitForFunction((words) => document.querySelector("#headline")?.textContent.toLowerCase().includes(words), words);

/** The engine in this process, as the worker has it. */
export async function engine(name = "carom-whole.wasm") {
  const bytes = await readFile(join(DIST, "site", name));
  const { instance } = await WebAssembly.instantiate(bytes, { page: { step() {}, told() {} } });
  const { memory, carom_room, carom_answer, carom_place } = instance.exports;
  return (request) => {
    const packed = new TextEncoder().encode(JSON.stringify(request));
    const room = carom_room(packed.length);
    new Uint8Array(memory.buffer, room, packed.length).set(packed);
    const length = carom_answer();
    return JSON.parse(new TextDecoder().decode(new Uint8Array(memory.buffer, carom_place(), length)));
  };
}

/** Long work by one worker, and its answer. */
export function shared(ask, file, study) {
  const known = [];
  for (;;) {
    const asked = (what) => {
      const answer = ask({ ...file, ask: what });
      if (answer.failure !== undefined) throw new Error(answer.failure.message);
      return answer;
    };
    known.push([asked({ portion: { study, round: known.length, number: 0, of: 1 } }).portion]);
    const answer = asked({ joined: { study, known } });
    if (answer.again !== true) return answer;
  }
}

/** The median of numbers, and the value that 95 % of them do not pass. */
export function middle(numbers) {
  const sorted = [...numbers].sort((a, b) => a - b);
  const at = (share) => sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))];
  return { median: at(0.5), p95: at(0.95) };
}

/** `carom studio` with these words: its address, and how to end it. */
export async function studio(words) {
  const child = spawn(CAROM, ["studio", ...words, "--no-open", "--format", "json"], { cwd: ROOT, stdio: ["ignore", "pipe", "inherit"] });
  const line = await new Promise((done, failed) => {
    child.stdout.once("data", (data) => done(String(data)));
    child.once("exit", (code) => failed(new Error(`carom studio ended with ${code}`)));
  });
  return { address: JSON.parse(line).address, close: () => child.kill() };
}
