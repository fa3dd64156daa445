// The pages of the manual as they were built: no link is dead, and each chart opens in the playground. `node manual.mjs PAGE GLUE MANUAL`.

import assert from "node:assert/strict";
import { readFile, readdir } from "node:fs/promises";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

import { unpacked } from "../src/share.js";

const [folder, glue, told] = process.argv.slice(2).map(path => resolve(path));
const { check, initSync, look } = await import(pathToFileURL(join(glue, "grafcet.js")));
initSync({ module: await readFile(join(glue, "grafcet_bg.wasm")) });

const entries = await readdir(folder, { recursive: true, withFileTypes: true });
const files = entries.filter(entry => entry.isFile()).map(({ parentPath, path, name }) => join(parentPath ?? path, name).slice(folder.length + 1));
const plain = text => text.replaceAll("&quot;", '"').replaceAll("&lt;", "<").replaceAll("&gt;", ">").replaceAll("&amp;", "&");
const pages = new Map();
for (const name of files.filter(name => name.endsWith(".html"))) {
  const html = await readFile(join(folder, name), "utf8");
  const all = pattern => [...html.matchAll(pattern)].map(([, found]) => plain(found));
  const loads = [...all(/\bsrc="([^"]*)"/g), ...all(/<link\b[^>]*\bhref="([^"]*)"/g)];
  pages.set(name, { ids: all(/\bid="([^"]*)"/g), links: all(/<a\b[^>]*\bhref="([^"]*)"/g), loads });
}

const dead = [];
let followed = 0;
for (const [name, { ids, links, loads }] of pages) {
  const twice = ids.filter((id, at) => ids.indexOf(id) !== at);
  if (twice.length > 0) dead.push(`${name} has ${twice.join(", ")} twice`);
  for (const file of loads) if (!files.includes(file)) dead.push(`${name} loads ${file}`);
  for (const link of links) {
    const [path, fragment] = link.split("#");
    followed++;
    if (/^https:/.test(link)) continue;
    const to = path === "" ? name : path;
    if (!files.includes(to)) dead.push(`${name} leads to ${link}`);
    else if (fragment && !fragment.startsWith("chart=") && !pages.get(to)?.ids.includes(fragment)) dead.push(`${name} leads to ${link}, where nothing is`);
  }
}
assert.deepEqual(dead, []);
assert.ok(followed > 700 && pages.size > 18, `${followed} links in ${pages.size} pages`);

// What the page keeps for when there is no network is all of it.
const offline = await readFile(join(folder, "offline.js"), "utf8");
assert.deepEqual(files.filter(name => name !== "offline.js" && !offline.includes(`"${name}"`)), []);

// Each chart that a page shows is in a link, whole, and the page of the playground understands it.
let opened = 0;
for (const { file, blocks } of JSON.parse(await readFile(told, "utf8"))) {
  const name = file === "README.md" ? "manual.html" : file.replace(/^docs\//, "").replaceAll("/", "-").replace(/md$/, "html");
  const links = pages.get(name).links.filter(link => link.startsWith("index.html#"));
  const texts = await Promise.all(links.map(link => unpacked(link.slice("index.html".length))));
  const charts = blocks.flatMap(block => block.charts.map(chart => ({ ...chart, fails: block.fails })));
  assert.equal(texts.length, charts.length, name);
  for (const [at, { name: chart, text, fails }] of charts.entries()) {
    assert.equal(texts[at], text, name);
    const what = `${name}: ${chart}`, seen = JSON.parse(look(text)), { messages, runs } = JSON.parse(check(text));
    const errors = messages.filter(({ level }) => level === "error").map(({ notes }) => notes.map(note => note.text).join("; "));
    assert.equal(seen.name, chart, what);
    // Of each rule there is one chart that breaks it, which tests/rules.rs looks at.
    if (file === "docs/rules.md") continue;
    assert.ok(fails ? errors.length > 0 : errors.length === 0 && runs && seen.drawing, `${what}: ${errors.join("\n")}`);
    opened++;
  }
}
assert.ok(opened > 60, `${opened} charts`);
console.log(`manual: ${pages.size} pages, ${followed} links, ${opened} charts without those of the rules`);
