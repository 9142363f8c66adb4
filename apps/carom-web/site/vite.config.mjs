// Two forms of one site: a folder of static files, and with `--mode single` one file that opens from a disk.
import { readFileSync } from "node:fs";
import { gzipSync } from "node:zlib";
import { defineConfig } from "vite";

const ENGINE = new URL("./engine/carom.wasm", import.meta.url);

// The player is the reports' own: a plain script there, a module here.
const player = {
  name: "player-of-reports",
  transform: (code, id) => (id.endsWith("/player.js") ? `${code}\nexport { player };\n` : null),
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
    const engine = gzipSync(readFileSync(ENGINE), { level: 9 }).toString("base64");
    page.source = html.replace(
      "</head>",
      () => `<script type="application/octet-stream" id="engine">${engine}</script></head>`,
    );
    page.fileName = "carom-studio.html";
  },
};

const inAFolder = {
  name: "engine-beside",
  generateBundle() {
    this.emitFile({ type: "asset", fileName: "carom.wasm", source: readFileSync(ENGINE) });
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
