// What the page's tabs write is what `cargo grafcet export` writes, letter by letter: `node forms.mjs GLUE GALLERY TOOL`.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

const [glue, gallery, tool] = process.argv.slice(2).map(path => resolve(path));
const { initSync, translate } = await import(pathToFileURL(join(glue, "grafcet.js")));
initSync({ module: await readFile(join(glue, "grafcet_bg.wasm")) });

// By the name of a tab, what the tool is asked for.
const FORMS = {
  "case": ["st"],
  "flip-flops": ["st", "--form", "flip-flops"],
  "sfc": ["sfc"],
  "plcopen": ["plcopen"],
  "pnml": ["pnml"],
  "aiger": ["aiger"],
  "btor2": ["btor2"],
};

const shelves = JSON.parse(await readFile(gallery, "utf8"));
// One that has errors, and one that breaks its own claim.
const bad = "sfc Bad { input a: bool; initial step A; step B; step C; A -[a]-> B -[!a]-> A; C -[a]-> A; }";
const claim = "sfc Claim { input a: bool; never B.X; initial step A; step B; A -[a]-> B -[!a]-> A; }";
const charts = [...shelves.flatMap(shelf => shelf.charts.map(chart => chart.text)), bad, claim];
const folder = await mkdtemp(join(tmpdir(), "grafcet-forms-"));
// One file for all charts, as the tool takes its time to start.
const file = join(folder, "charts.rs");
await writeFile(file, charts.map(text => `grafcet! {\n${text}}\n`).join("\n"));

const differences = [];
let texts = 0, refusals = 0;
for (const [form, words] of Object.entries(FORMS)) {
  const { stdout, stderr, error } = spawnSync(tool, ["grafcet", "export", words[0], file, ...words.slice(1), "--json"], { encoding: "utf8", maxBuffer: 1 << 28 });
  if (error) throw error;
  const told = stdout.trim().split("\n").map(line => JSON.parse(line));
  assert.equal(told.length, charts.length, stderr);
  for (const [at, { chart, text, to_write: toWrite, refused }] of told.entries()) {
    const done = JSON.parse(translate(charts[at], form));
    // Errors of the chart are said by the tool as the compiler's, and by the page beside the text.
    const hasErrors = text === null && refused.length === 0;
    const [own, other] = hasErrors
      ? [[done.refused?.[0].text.replace(/an error|\d+ errors/, "errors")], ["the chart has errors: mend that first"]]
      : [
        [done.text ?? null, (done.refused ?? []).map(one => one.text), (done.notes ?? []).map(note => note.match(/`([^`]*)`/)[1])],
        [text, refused.map(one => one.message), toWrite.map(one => one.name)],
      ];
    if (JSON.stringify(own) !== JSON.stringify(other)) differences.push(`${form} of ${chart}: ${JSON.stringify(own).slice(0, 300)} is not ${JSON.stringify(other).slice(0, 300)}`);
    if (text === null) refusals++;
    else texts++;
  }
}
await rm(folder, { recursive: true });
console.log(`forms: ${charts.length} charts, ${texts} texts, ${refusals} refusals, ${differences.length} differences`);
if (differences.length > 0 || texts < 300 || refusals < 20) {
  console.error(differences.join("\n"));
  process.exitCode = 1;
}
