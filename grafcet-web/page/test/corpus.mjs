// The module of WebAssembly plays the timelines of the conformance corpus, which were worked out by hand and which generated code is compared with:
// `node corpus.mjs GLUE TIMELINES`.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

const [folder, timelines] = process.argv.slice(2).map(path => resolve(path));
const { Session, initSync } = await import(pathToFileURL(join(folder, "grafcet.js")));
initSync({ module: await readFile(join(folder, "grafcet_bg.wasm")) });

// A value of a timeline, where `true` is 1 and a variant is its place.
const given = ({ kind }, number) => String(kind.is === "bool" ? number !== 0 : kind.is === "listed" ? kind.list[number] : number);
const number = ({ kind }, value) => kind.is === "bool" ? Number(value) : kind.is === "listed" ? kind.list.indexOf(value) : Number(value);
const plain = name => name.replace(/^.*::/, "");

function shown(names, moment, withCalls) {
  const outputs = names.outputs.map((output, place) => [output.name, number(output, moment.outputs[place])]).filter(([, value]) => value !== 0);
  return {
    steps: moment.steps.map(step => plain(names.steps[step])).sort(),
    outputs: Object.fromEntries([...outputs, ...moment.late.map(step => [`late(${plain(step)})`, 1])].sort(([a], [b]) => a < b ? -1 : 1)),
    ...withCalls && { stable: moment.stable, calls: moment.calls.map(({ phase, action, args }) => `${phase} ${action}(${args.map(Number).join(",")})`) },
  };
}

function expected({ steps, outputs, stable, calls }, withCalls) {
  const raised = Object.entries(outputs).filter(([, value]) => value !== 0).sort(([a], [b]) => a < b ? -1 : 1);
  return { steps: [...steps].sort(), outputs: Object.fromEntries(raised), ...withCalls && { stable, calls: calls.map(call => call.replaceAll(" ", "").replace(/^(first|repeated|final)/, "$1 ")) } };
}

function play({ chart, lines }) {
  const session = new Session(chart, 1), names = JSON.parse(session.names());
  let compared = 0;
  const set = inputs => {
    names.signals.forEach((signal, place) => session.set(place, given(signal, inputs[signal.name] ?? 0)));
    for (const name of Object.keys(inputs)) assert(names.signals.some(signal => signal.name === name), `no input ${name}`);
  };
  for (const { number: line, does } of lines) {
    let moment = null;
    if (does.inputs) set(does.inputs);
    if (does.is === "cycle") moment = JSON.parse(session.cycle_at(does.now));
    if (does.is === "force") moment = JSON.parse(session.force(does.now, Uint32Array.from(does.steps, step => names.steps.findIndex(name => plain(name) === step))));
    if (does.is === "init") session.init();
    if (does.is === "params") for (const [name, value] of Object.entries(does.params)) {
      const place = names.params.findIndex(param => param.name === name);
      session.set_param(place, given(names.params[place], value));
    }
    if (does.is === "shows") moment = JSON.parse(session.now());
    if (!moment) continue;
    compared++;
    const withCalls = does.is !== "shows";
    assert.deepEqual(shown(names, moment, withCalls), expected(does.expected, withCalls), `line ${line}`);
  }
  session.free();
  return compared;
}

const cases = JSON.parse(await readFile(timelines, "utf8"));
let compared = 0;
const differences = [];
for (const one of cases) {
  try {
    compared += play(one);
  } catch (error) {
    differences.push(`${one.name}: ${error.message ?? error}`);
  }
}
console.log(`${cases.length} charts, ${compared} moments, ${differences.length} differences`);
if (differences.length > 0 || compared === 0) {
  console.error(differences.join("\n"));
  process.exitCode = 1;
}
