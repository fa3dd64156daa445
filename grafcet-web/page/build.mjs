// Builds the page: `node build.mjs GLUE GALLERY MANUAL LICENCES OUT`. GLUE has what wasm-bindgen wrote, GALLERY is a file of charts, MANUAL one of pages with
// theirs, LICENCES has those of the crates, OUT is where the page goes.

import { cp, mkdir, readFile, readdir, writeFile } from "node:fs/promises";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

import * as esbuild from "esbuild";

import { manual } from "./manual.mjs";

const here = dirname(fileURLToPath(import.meta.url)), source = join(here, "src");
// What the page shares with that of `cargo grafcet watch` lies with the tool, which is published and brings it along.
const shared = join(here, "../../cargo-grafcet/src/watch/page");
const [glue, gallery, pages, crates, out] = process.argv.slice(2).map(path => resolve(path));
if (!out) throw new Error("usage: node build.mjs GLUE GALLERY MANUAL LICENCES OUT");

await mkdir(join(out, "pictures"), { recursive: true });
const book = await manual(JSON.parse(await readFile(pages, "utf8")), join(here, "../.."));
for (const [name, content] of book) await writeFile(join(out, name), content);
const built = await esbuild.build({
  absWorkingDir: here,
  entryPoints: ["main.js", "worker.js", "offline.js", "manual.js"].map(file => join(source, file)),
  outdir: out, bundle: true, format: "esm", minify: true, target: "es2022", charset: "utf8", legalComments: "none", metafile: true,
  alias: { grafcet: join(glue, "grafcet.js") },
  define: { BOOK: JSON.stringify([...book.keys()]) },
  logLevel: "warning",
});
await cp(join(glue, "grafcet_bg.wasm"), join(out, "grafcet_bg.wasm"));
await cp(gallery, join(out, "gallery.json"));
await cp(join(source, "index.html"), join(out, "index.html"));
for (const file of ["style.css", "icon.svg"]) await cp(join(shared, file), join(out, file));
await writeFile(join(out, "LICENSES.txt"), await licences(built.metafile) + await readFile(crates, "utf8"));

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
