// The page: what is typed is looked at and drawn; the chart that was drawn last and can run is run.

import { Chronogram } from "../../../cargo-grafcet/src/watch/page/chronogram.js";
import { Drawing } from "../../../cargo-grafcet/src/watch/page/drawing.js";
import { rich } from "../../../cargo-grafcet/src/watch/page/rich.js";
import { ByHand } from "./byhand.js";
import { Editor, ruleLink } from "./editor.js";
import { Latest } from "./engine.js";
import { Forms } from "./forms.js";
import { Gallery, charts } from "./gallery.js";
import { packed, unpacked } from "./share.js";
import { Signals } from "../../../cargo-grafcet/src/watch/page/signals.js";
import { Simulation } from "./simulation.js";
import { keep, kept, theme } from "../../../cargo-grafcet/src/watch/page/theme.js";

const at = id => document.getElementById(id);

const STORED = "grafcet.chart";

// What is drawn, of which text; and what the compiler has said last, which comes later.
let drawn = null;
let looked = null;
// The last one that could run: the marks of the drawing are of it.
let simulation = null;
// The first click on an input lets the chart run; who has stopped it once, goes on by hand.
let wasStopped = false;
let soon = 0;
// The chart of the address.
let linked = null;
// What is wrong with the link that was opened.
let unreadable = "";
// The chart whose signals stand there to be clicked.
let signalled = null;

const hasRun = () => (simulation?.latest?.number ?? 0) > 0;

function list(place, lines) {
  place.replaceChildren(...lines.map(line => {
    const item = document.createElement("li");
    item.append(...(typeof line === "string" ? rich(line) : line));
    return item;
  }));
}

// ---- What is typed

// The drawing does not wait for what the compiler has to say.
const drawer = new Latest("look", (text, seen, error) => {
  if (error) return failed(error);
  drawn = { text, ...seen };
  drawing.draw(seen.drawing);
  at("chart-name").textContent = seen.name || "Chart";
  document.title = seen.name ? `${seen.name} · grafcet playground` : "grafcet playground";
  show();
});

const checker = new Latest("check", (text, said, error) => {
  if (error) return failed(error);
  looked = { text, ...said };
  if (editor.text === text) editor.mark(said.messages);
  problems(said);
  forms.of(text);
  // What somebody else has written, and nobody here has changed, does not take the place of one's own.
  if (text !== linked) keep(STORED, text);
  // Each session is a worker of its own: not one for each letter.
  clearTimeout(soon);
  if (said.runs && !hasRun()) soon = setTimeout(() => { if (!hasRun()) begin(text); }, simulation ? 250 : 0);
  show();
});

function failed(error) {
  at("verdict").textContent = "The compiler has failed";
  at("verdict").className = "bad";
  list(at("problems"), [`${error.message}. The next change starts it anew; if it fails again, please report the chart.`]);
}

function problems({ messages, runs }) {
  const errors = messages.filter(one => one.level === "error").length, warnings = messages.length - errors;
  const count = (number, word) => number === 0 ? [] : [number === 1 ? `1 ${word}` : `${number} ${word}s`];
  at("verdict").textContent = [...count(errors, "error"), ...count(warnings, "warning")].join(", ") || (runs ? "No complaints" : "");
  at("verdict").className = errors > 0 ? "bad" : warnings > 0 ? "warn" : "good";
  at("problems").replaceChildren(...messages.map(message => {
    const item = document.createElement("li");
    item.className = message.level;
    message.notes.forEach((note, index) => {
      const lead = document.createElement("button");
      lead.type = "button";
      lead.append(...rich(note.text.replace(/ \[grafcet::\w+\]$/, "")));
      lead.addEventListener("click", () => editor.go(note.from, note.to));
      item.append(lead);
      if (index === 0 && message.rule) item.append(ruleLink(message.rule));
      if (note.table) {
        const table = document.createElement("pre");
        table.textContent = note.table;
        table.tabIndex = 0;
        item.append(table);
      }
    });
    return item;
  }));
}

// ---- What runs

function begin(text) {
  // What was to begin soon has begun now: twice would throw away what is clicked in between.
  clearTimeout(soon);
  simulation?.end();
  const next = new Simulation(text, Number(at("period").value), () => { if (next === simulation) show(); });
  next.speed = Number(at("speed").value);
  simulation = next;
}

function restart() {
  wasStopped = false;
  if (looked?.runs) begin(looked.text);
  show();
}

function input(change) {
  const next = simulation;
  if (!next?.moment) {
    // It has not begun yet: what is clicked meanwhile is for it, where it has the signals that are shown.
    if (next?.text === signalled) void next?.ready.then(() => { if (next === simulation && next.moment) input(change); });
    return;
  }
  // What is true in the first cycle already has no edge (A26), which nobody who clicks has in mind.
  if (simulation.latest.number === 0 && !wasStopped) void simulation.cycle();
  change();
  if (!simulation.isRunning && !wasStopped && simulation.isLive) simulation.run(true);
}

function show() {
  const ready = simulation?.names && simulation.moment;
  const fits = ready && drawn && simulation.text === drawn.text;
  document.body.classList.toggle("idle", !ready);
  for (const id of ["run", "cycle", "skip", "init", "restart"]) at(id).disabled = !ready;
  at("stale").hidden = !(ready && looked?.runs && simulation.text !== looked.text);
  const trouble = simulation?.trouble ?? unreadable;
  at("trouble").hidden = trouble === "";
  if (at("trouble").dataset.text !== trouble) {
    at("trouble").dataset.text = trouble;
    at("trouble").replaceChildren(...rich(trouble));
  }
  if (!ready) return;
  const { moment, names } = simulation;
  at("run").setAttribute("aria-pressed", String(simulation.isRunning));
  at("run").textContent = simulation.isRunning ? "❙❙ Pause" : "▶ Run";
  at("clock").textContent = `${moment.time} · cycle ${moment.number}`;
  at("live").hidden = simulation.isLive;
  at("past").textContent = simulation.isLive ? "" : "The past: what you do now goes on from here.";
  speak();
  signals.show(simulation);
  byHand.show(simulation);
  signalled = simulation.text;
  chronogram.draw(simulation);
  list(at("waits"), moment.said);
  list(at("did"), happened());
  if (!fits) return drawing.clear();
  const evolutions = moment.evolutions;
  drawing.mark({
    steps: new Set(moment.steps),
    entered: new Set(evolutions.flatMap(one => one.entered)),
    cleared: new Set(evolutions.flatMap(one => one.cleared)),
    enabled: new Set(moment.waits.map(([transition]) => transition)),
  });
}

// For who listens: what is shown now, but not while it runs.
function speak() {
  const { moment, names } = simulation;
  if (simulation.isRunning || moment.number === 0) return;
  const steps = moment.steps.map(step => names.steps[step]), on = names.outputs.filter((_, place) => moment.outputs[place] === true);
  const text = `Cycle ${moment.number}: in ${steps.join(", ") || "no step"}; ${on.map(one => one.name).join(", ") || "no output"} on`;
  if (at("spoken").textContent !== text) at("spoken").textContent = text;
}

// What the last cycle did that did anything, and when.
function happened() {
  const { history, shown, moment } = simulation;
  const late = moment.late.map(step => `\`${step}\` is late`);
  const last = history.slice(0, shown + 1).findLast(one => one.isNew && one.did.length > 0);
  if (!last) return [...late, "nothing yet"];
  return [...late, `at ${last.time}:`, ...last.did];
}

// What to say of a transition that somebody points at.
function told(transition) {
  const fits = simulation?.names && drawn?.text === simulation.text;
  if (!fits) return rich("The chart that runs is another one.");
  const { condition } = simulation.names.transitions[transition];
  const waits = simulation.moment.waits.filter(([one]) => one === transition).map(([, text]) => text);
  const lines = waits.length > 0 ? waits : [`\`${condition}\` is not asked: not all of its steps are active`];
  return lines.flatMap((line, index) => index === 0 ? rich(line) : [document.createElement("br"), ...rich(line)]);
}

// ---- The parts

const editor = new Editor(at("editor"), {
  text: "",
  changed: text => {
    // The address says another chart than the page shows.
    if (location.hash && text !== linked) forget();
    drawer.look(text);
    checker.look(text);
  },
  words: () => drawn?.words ?? [],
});
const drawing = new Drawing(at("drawing"), at("hint"), {
  pointed: told,
  chosen: (kind, number, alone) => {
    // A macro-step is several steps: which of them, only the list says.
    if (kind === "step" && byHand.isChoosing && drawn?.text === simulation?.text) return alone ? byHand.toggle(number) : undefined;
    const place = (kind === "step" ? drawn?.steps : drawn?.transitions)?.[number];
    if (place && editor.text === drawn.text) editor.go(...place);
  },
});
const forms = new Forms((from, to) => editor.go(from, to));
const chronogram = new Chronogram(at("waves"), moment => simulation?.look(moment));
const signals = new Signals(at("signals"), {
  set: (place, value) => input(() => simulation.set(place, value)),
  setParam: (place, value) => { if (simulation?.moment) void simulation.setParam(place, value); },
});
const byHand = new ByHand({
  force: steps => { stop(); void simulation.force(steps); },
  mark: steps => drawing.choose(drawn?.text === simulation?.text ? steps : new Set()),
});
new Gallery(text => open(text));
theme(at("theme"));

function open(text) {
  unreadable = "";
  simulation?.end();
  simulation = null;
  wasStopped = false;
  editor.replace(text);
}

function forget() {
  linked = null;
  history.replaceState(null, "", location.pathname + location.search);
}

function stop() {
  wasStopped = true;
  simulation.run(false);
}

at("run").addEventListener("click", () => { if (simulation.isRunning) stop(); else simulation.run(true); });
at("cycle").addEventListener("click", () => { stop(); void simulation.cycle(); });
at("skip").addEventListener("click", () => { stop(); void simulation.skip(); });
at("init").addEventListener("click", () => simulation.init());
at("restart").addEventListener("click", restart);
at("take").addEventListener("click", restart);
at("live").addEventListener("click", () => simulation.look(simulation.history.length - 1));
at("speed").addEventListener("change", () => { if (simulation) simulation.speed = Number(at("speed").value); });
at("period").addEventListener("change", () => simulation?.period(Number(at("period").value)));
document.addEventListener("keydown", event => { if (event.key === "Escape") drawing.hush(); });
document.addEventListener("scroll", () => drawing.hush(), true);

at("share").addEventListener("click", async () => {
  linked = editor.text;
  const fragment = await packed(linked);
  history.replaceState(null, "", `#${fragment}`);
  at("address").value = location.href;
  at("copied").textContent = "";
  at("link").showModal();
  at("address").select();
});
at("copy").addEventListener("click", async () => {
  try {
    await navigator.clipboard.writeText(at("address").value);
    at("copied").textContent = "Copied";
  } catch {
    at("address").select();
    at("copied").textContent = "Copy the marked text";
  }
});

// The chart of the link, else what was typed last, else the first of the gallery.
async function first() {
  unreadable = "";
  try {
    linked = await unpacked(location.hash);
    if (linked !== null) return linked;
  } catch (error) {
    unreadable = `The chart of this link cannot be read: ${error.message}`;
  }
  return kept(STORED) ?? (await charts())[0].charts.find(chart => chart.name === "Motor").text;
}

async function start() {
  editor.replace(await first());
  show();
  document.documentElement.dataset.ready = "";
}
addEventListener("hashchange", () => { if (location.hash.startsWith("#chart")) void start(); });
void start();
if ("serviceWorker" in navigator) navigator.serviceWorker.register("offline.js").catch(() => { /* then with a network alone */ });

// For tests.
Object.assign(globalThis, { playground: { editor, get simulation() { return simulation; }, get drawn() { return drawn; }, get looked() { return looked; } } });
