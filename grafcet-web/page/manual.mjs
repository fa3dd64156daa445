// The manual as pages beside the playground: each chart that a page shows has a link that opens it there.

import { readFile } from "node:fs/promises";
import { posix } from "node:path";

import { Marked, Renderer } from "marked";

import { highlighted, looks } from "./src/language.js";
import { packed } from "./src/share.js";

// In which order they are read. What is not named here comes after them.
const ORDER = ["README.md", ...["first-chart", "language", "semantics", "rules", "names", "cookbook", "porting", "drawing", "playground", "tool",
  "record", "replay", "proof", "reliability", "cost"].map(name => `docs/${name}.md`)];
const PICTURES = "docs/pictures/";
const POLICY = "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self'; connect-src 'self'; worker-src 'self'; base-uri 'none'; form-action 'none'";

const escaped = text => text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;").replaceAll('"', "&quot;");
const plain = html => html.replace(/<[^>]*>/g, "").replaceAll("&lt;", "<").replaceAll("&gt;", ">").replaceAll("&quot;", '"').replaceAll("&#39;", "'").replaceAll("&amp;", "&");

// The file of a page: all lie in one folder.
function named(file) {
  return file === "README.md" ? "manual.html" : file.replace(/^docs\//, "").replaceAll("/", "-").replace(/\.md$/, ".html");
}

// `told` are the pages with their charts, as `examples/manual.rs` prints them. What comes back are the files of the folder: names and contents, with the
// pictures that they show.
export async function manual(told, root) {
  const place = ({ file }) => (ORDER.indexOf(file) + 1) || ORDER.length + 1;
  const sorted = [...told].sort((a, b) => place(a) - place(b));
  const known = new Set(sorted.map(({ file }) => file)), pictures = new Set();
  const parts = [];
  for (const page of sorted) parts.push(await written(page, known, pictures));
  const files = new Map(parts.map((part, at) => [named(part.file), whole(parts, at)]));
  for (const picture of pictures) files.set(`pictures/${picture}`, await readFile(posix.join(root, PICTURES, picture)));
  files.set("manual.css", await styles());
  return files;
}

// A page between its head and its foot: the headings lead to what stands where.
async function written({ file, text, blocks }, known, pictures) {
  const charts = new Map(), found = new Set(), headings = [], ids = new Map();
  for (const block of blocks) charts.set(block.text, await links(block.charts));
  const marked = new Marked({ renderer: {
    heading({ tokens, depth }) {
      const inner = this.parser.parseInline(tokens), heading = { depth, inner, id: unique(slug(plain(inner)), ids) };
      headings.push(heading);
      return `<h${depth} id="${heading.id}">${inner}</h${depth}>\n`;
    },
    code({ text, lang = "" }) {
      const isRust = /^(rust|rs)\b/.test(lang), opened = isRust ? charts.get(text) : undefined;
      found.add(text);
      const code = isRust ? coloured(seen(text)) : escaped(text);
      return `<div class="code"><pre tabindex="0"><code>${code}\n</code></pre>${opened ?? ""}</div>\n`;
    },
    link({ href, tokens }) {
      const inner = this.parser.parseInline(tokens), to = target(href, file, known);
      // What is not part of the folder stands in the repository, of which nobody knows where it is published.
      return to === null ? inner : `<a href="${escaped(to)}">${inner}</a>`;
    },
    image({ href, text }) { return `<img src="${picture(href, file, pictures)}" alt="${escaped(text)}">`; },
    html({ text }) {
      const image = /^<img\b[^>]*\bsrc="([^"]*)"[^>]*\balt="([^"]*)"[^>]*>\s*$/.exec(text);
      if (image) return `<img class="beside" src="${picture(image[1], file, pictures)}" alt="${image[2]}">\n`;
      if (/^\s*<!--[^]*-->\s*$/.test(text)) return "";
      throw new Error(`${file}: the pages of the manual hold no HTML: ${text}`);
    },
    table(token) { return `<div class="wide" role="group" aria-label="Table" tabindex="0">${Renderer.prototype.table.call(this, token)}</div>\n`; },
  } });
  const body = marked.parse(text);
  const missing = [...charts.keys()].find(text => !found.has(text));
  if (missing !== undefined) throw new Error(`${file}: this chart is in no block of code that is shown:\n${missing}`);
  return { file, body, headings, title: plain(headings[0].inner) };
}

// As repositories and their readers know them: `## By hand` is `#by-hand`.
function slug(text) {
  return text.trim().toLowerCase().replace(/[^\p{L}\p{N}_\- ]/gu, "").replaceAll(" ", "-");
}

function unique(id, ids) {
  const count = ids.get(id) ?? 0;
  ids.set(id, count + 1);
  return count === 0 ? id : `${id}-${count}`;
}

function target(href, file, known) {
  if (/^(https?:|#)/.test(href)) return href;
  const [path, fragment] = href.split("#"), to = posix.join(posix.dirname(file), path);
  return known.has(to) ? named(to) + (fragment === undefined ? "" : `#${fragment}`) : null;
}

function picture(href, file, pictures) {
  const name = posix.relative(PICTURES, posix.join(posix.dirname(file), href));
  if (name.startsWith("..")) throw new Error(`${file}: a picture that is not in ${PICTURES}: ${href}`);
  pictures.add(name);
  return escaped(`pictures/${name}`);
}

// Without what rustdoc hides.
function seen(rust) {
  return rust.split("\n").filter(line => line !== "#" && !line.startsWith("# ")).map(line => line.replace(/^##/, "#")).join("\n");
}

function coloured(code) {
  let html = "";
  highlighted(code, (text, look) => { html += look ? `<span class="${look}">${escaped(text)}</span>` : escaped(text); });
  return html;
}

async function links(charts) {
  const all = await Promise.all(charts.map(async ({ name, text }) => `<a href="index.html#${await packed(text)}">Open <b>${escaped(name)}</b> in the playground</a>`));
  return `<p class="open">${all.join(" ")}</p>`;
}

function whole(parts, at) {
  const { file, body, title, headings } = parts[at];
  const sections = headings.filter(({ depth }) => depth === 2).map(({ inner, id }) => `<li><a href="#${id}">${inner.replace(/<\/?a\b[^>]*>/g, "")}</a></li>`);
  const pages = parts.map((part, place) => {
    const label = part.file === "README.md" ? "Overview" : escaped(part.title);
    const inside = place === at && sections.length > 0 ? `<ul>${sections.join("")}</ul>` : "";
    return `<li><a href="${named(part.file)}"${place === at ? ' aria-current="page"' : ""}>${label}</a>${inside}</li>`;
  });
  const next = parts[at + 1], name = file === "README.md" ? "grafcet" : `${escaped(title)} · grafcet`;
  return `<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="${POLICY}">
<meta name="referrer" content="no-referrer">
<meta name="color-scheme" content="light dark">
<title>${name}</title>
<link rel="icon" href="icon.svg" type="image/svg+xml">
<link rel="stylesheet" href="style.css">
<link rel="stylesheet" href="manual.css">
<script type="module" src="manual.js"></script>
</head>
<body class="manual">
<a class="skip" href="#text">Skip to the text</a>
<header>
  <p class="brand"><a href="manual.html">grafcet <span>manual</span></a></p>
  <nav aria-label="Playground">
    <a href="index.html">Playground</a>
    <button id="theme" type="button" aria-label="Colours: as the system">◐</button>
  </nav>
</header>
<div class="book">
<nav class="pages" aria-label="Manual"><details><summary>Pages</summary><ul>
${pages.join("\n")}
</ul></details></nav>
<main id="text">
${body}${next ? `<p class="next"><a href="${named(next.file)}">Next: ${escaped(next.title)}</a></p>\n` : ""}</main>
</div>
</body>
</html>
`;
}

// The colours of code are those of the editor.
async function styles() {
  const rules = looks.map(({ name, color, fontWeight, fontStyle }) => {
    const rest = [fontWeight && `font-weight: ${fontWeight};`, fontStyle && `font-style: ${fontStyle};`].filter(Boolean);
    return `.code .${name} { ${[`color: ${color};`, ...rest].join(" ")} }`;
  });
  return `${await readFile(new URL("src/manual.css", import.meta.url), "utf8")}${rules.join("\n")}\n`;
}
