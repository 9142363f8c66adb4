// Two forms of one site: a folder of static files, and with `--mode single` one file that opens from a disk.
import { readFileSync } from "node:fs";
import { gzipSync } from "node:zlib";
import { defineConfig } from "vite";

/** The bench, which the page loads first, and the whole engine. */
const ENGINES = ["carom.wasm", "carom-whole.wasm"];
const engine = (name) => readFileSync(new URL(`./engine/${name}`, import.meta.url));

// The players are the reports' own: plain scripts there, modules here.
const EXPORTED = {
  "player.js": "player",
  "solid_camera.js": "solidCamera",
  "solid_plates.js": "solidPlates",
  "solid_view.js": "solidView",
  "solid.js": "solidPlayer",
};
const NEEDS = {
  solidPlayer: [["solidView", "./solid_view.js"]],
  solidView: [
    ["solidCamera", "./solid_camera.js"],
    ["solidPlates", "./solid_plates.js"],
  ],
};
const player = {
  name: "players-of-reports",
  transform(code, id) {
    const name = EXPORTED[id.slice(id.lastIndexOf("/") + 1)];
    if (name === undefined || !id.includes("carom-figure")) return null;
    const needs = (NEEDS[name] ?? []).map(([from, file]) => `import { ${from} } from "${file}";\n`).join("");
    return `${needs}${code}\nexport { ${name} };\n`;
  },
};

// Scripts, styles and the engine within the page itself.
const inOneFile = {
  name: "in-one-file",
  enforce: "post",
  generateBundle(_, bundle) {
    const page = bundle["index.html"];
    let html = page.source;
    for (const [name, file] of Object.entries(bundle)) {
      if (name === "index.html") continue;
      const reference = new RegExp(`<(script|link)[^>]*"[^"]*${name.replaceAll(".", "\\.")}"[^>]*>(</script>)?`);
      if (file.type === "chunk") {
        const code = file.code.replaceAll("</script", "<\\/script");
        html = html.replace(reference, "").replace("</body>", () => `<script type="module">${code}</script></body>`);
      } else if (name.endsWith(".css")) {
        html = html.replace(reference, () => `<style>${file.source}</style>`);
      }
      delete bundle[name];
    }
    const within = ENGINES.map((name) => {
      const packed = gzipSync(engine(name), { level: 9 }).toString("base64");
      return `<script type="application/octet-stream" id="${name}">${packed}</script>`;
    });
    page.source = html.replace("</head>", () => `${within.join("")}</head>`);
    page.fileName = "carom-studio.html";
  },
};

const inAFolder = {
  name: "engine-beside",
  generateBundle() {
    for (const fileName of ENGINES) this.emitFile({ type: "asset", fileName, source: engine(fileName) });
  },
};

export default defineConfig(({ mode }) => ({
  base: "./",
  plugins: [player, mode === "single" ? inOneFile : inAFolder],
  server: { fs: { allow: ["../../.."] } },
  build: {
    outDir: mode === "single" ? "dist/single" : "dist/site",
    assetsInlineLimit: 0,
    modulePreload: false,
    cssCodeSplit: false,
    rolldownOptions: {
      output: {
        entryFileNames: "studio.js",
        chunkFileNames: "[name].js",
        assetFileNames: (asset) => (asset.names?.[0]?.endsWith(".css") ? "studio.css" : "[name][extname]"),
      },
    },
  },
}));
