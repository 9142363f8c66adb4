// Runs the command, built as WebAssembly, in Node.js: `node wasi.mjs MODULE TARGET WORD…`. It sees this folder, and TARGET where that is elsewhere.
import { readFile } from "node:fs/promises";
import { isAbsolute } from "node:path";
import { WASI } from "node:wasi";

const [module, target, ...words] = process.argv.slice(2);
const elsewhere = isAbsolute(target) ? { [target]: target } : {};
const wasi = new WASI({ version: "preview1", args: ["carom", ...words], preopens: { ".": ".", ...elsewhere } });
const compiled = await WebAssembly.compile(await readFile(module));
// What the C library does not have: threads. Who wants to start one gets ENOSYS, and the program does its work on the one it has.
const missing = WebAssembly.Module.imports(compiled).filter((one) => one.module === "env");
const env = Object.fromEntries(missing.map(({ name }) => [name, () => (name === "pthread_create" ? 52 : 0)]));
wasi.start(await WebAssembly.instantiate(compiled, { ...wasi.getImportObject(), env }));
