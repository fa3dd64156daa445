// Builds the page: `node build.mjs GLUE GALLERY LICENCES OUT`. GLUE has what wasm-bindgen wrote, GALLERY is a file of charts, LICENCES has those of the
// crates, OUT is where the page goes.

import { cp, mkdir, readFile, readdir, writeFile } from "node:fs/promises";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

import * as esbuild from "esbuild";
import { Marked } from "marked";

const here = dirname(fileURLToPath(import.meta.url)), source = join(here, "src");
// What the page shares with that of `cargo grafcet watch` lies with the tool, which is published and brings it along.
const shared = join(here, "../../cargo-grafcet/src/watch/page");
const [glue, gallery, crates, out] = process.argv.slice(2).map(path => resolve(path));
if (!out) throw new Error("usage: node build.mjs GLUE GALLERY LICENCES OUT");

await mkdir(out, { recursive: true });
const built = await esbuild.build({
  absWorkingDir: here,
  entryPoints: [join(source, "main.js"), join(source, "worker.js"), join(source, "offline.js")],
  outdir: out, bundle: true, format: "esm", minify: true, target: "es2022", charset: "utf8", legalComments: "none", metafile: true,
  alias: { grafcet: join(glue, "grafcet.js") },
  logLevel: "warning",
});
await cp(join(glue, "grafcet_bg.wasm"), join(out, "grafcet_bg.wasm"));
await cp(gallery, join(out, "gallery.json"));
await cp(join(source, "index.html"), join(out, "index.html"));
for (const file of ["style.css", "icon.svg"]) await cp(join(shared, file), join(out, file));
await writeFile(join(out, "rules.html"), await rules());
await writeFile(join(out, "LICENSES.txt"), await licences(built.metafile) + await readFile(crates, "utf8"));

// The page of rules, in the folder itself, so that it can be read without a network.
async function rules() {
  const text = await readFile(join(here, "../../docs/rules.md"), "utf8");
  const manual = "https://docs.rs/grafcet/latest/grafcet/manual";
  const links = ["language", "names", "semantics", "proof", "cookbook"].map(page => `[${page}]: ${manual}/${page}/index.html`).join("\n");
  const plain = html => html.replace(/<[^>]*>/g, "");
  const marked = new Marked({ renderer: {
    heading({ tokens, depth }) {
      const inner = this.parser.parseInline(tokens);
      const id = plain(inner).toLowerCase().replace(/[^\w]+/g, "_");
      return `<h${depth} id="${id}">${inner}</h${depth}>\n`;
    },
    code({ text }) { return `<pre tabindex="0"><code>${text.replaceAll("&", "&amp;").replaceAll("<", "&lt;")}</code></pre>\n`; },
  } });
  const body = marked.parse(`${text}\n\n${links}\n`);
  const policy = "default-src 'none'; style-src 'self'; img-src 'self'; base-uri 'none'; form-action 'none'";
  return `<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="${policy}">
<title>The rules · grafcet</title>
<link rel="icon" href="icon.svg" type="image/svg+xml">
<link rel="stylesheet" href="style.css">
</head>
<body class="page">
<main>
<p><a href="index.html">Playground</a></p>
${body}</main>
</body>
</html>
`;
}

// The licence of every package of which something is in the page.
async function licences({ inputs }) {
  const packages = new Set(Object.keys(inputs).map(path => /^.*node_modules\/(?:@[^/]+\/)?[^/]+/.exec(path)?.[0]).filter(Boolean));
  const parts = [];
  for (const folder of [...packages].sort()) {
    const { name, version, license } = JSON.parse(await readFile(join(here, folder, "package.json"), "utf8"));
    const file = (await readdir(join(here, folder))).find(file => /^licen[cs]e/i.test(file));
    if (!file) throw new Error(`${name} has no licence file`);
    parts.push(`${name} ${version} (${license})\n\n${await readFile(join(here, folder, file), "utf8")}`);
  }
  return parts.map(part => `${part.trimEnd()}\n\n${"-".repeat(72)}\n\n`).join("");
}
