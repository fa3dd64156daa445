// Controllers that run: what the socket tells of each, and who shows it.

import { Chronogram } from "./chronogram.js";
import { Drawing } from "./drawing.js";
import { rich } from "./rich.js";
import { Signals } from "./signals.js";
import { Steering } from "./steering.js";
import { theme } from "./theme.js";

// So many moments a page keeps of each; the tool may keep more.
const MOST_KEPT = 10_000;
// So long after it was lost the socket is opened again, in milliseconds.
const AGAIN = 1000;

const at = id => document.getElementById(id);

function list(place, lines) {
  place.replaceChildren(...lines.map(line => {
    const item = document.createElement("li");
    item.append(...rich(line));
    return item;
  }));
}

// What is known of a controller, as the parts of the page read it.
class Seen {
  names = null;
  drawing = null;
  // What the chart can be told, where that is allowed.
  takes = null;
  history = [];
  shown = 0;
  line = null;
  // When the last frame came, by the clock of this page.
  heard = null;

  get isLive() { return this.shown === this.history.length - 1; }
  get moment() { return this.history[this.shown]; }
  get latest() { return this.history[this.history.length - 1]; }
  get values() { return this.moment.values; }
  get params() { return this.moment.params; }
  // So long the last moment lasts on the axis of time: nobody knows yet.
  get step() { return Math.max(1, Math.round(1e7 / this.names.nanosPerTick)); }
  begins({ elapsed }) { return elapsed; }

  // The last moment with none of its values.
  without() {
    const { names, moment } = this, none = list => list.map(() => "?");
    const [values, outputs, variables, params] = [moment.values, moment.outputs, moment.variables, moment.params].map(none);
    return { names, values, params, moment: { ...moment, values, outputs, variables, params } };
  }

  take({ line, chart, missed, moments }) {
    this.line = line;
    this.heard = line.heard === null ? null : performance.now() - line.heard;
    if (chart !== undefined) {
      this.names = chart?.names ?? null;
      this.drawing = chart?.drawing ?? null;
      this.takes = chart?.takes ?? null;
      this.history = [];
      this.shown = 0;
    }
    moments.forEach((moment, index) => {
      if (index === 0 && missed > 0) moment.gap ??= { reason: `${missed} moments came too fast for this page`, cycles: null };
      this.#add(moment);
    });
  }

  #add(moment) {
    const before = this.latest, follows = !before || this.isLive;
    // What differs in nothing but the time takes the place of what does so, too.
    if (before && !moment.isNew && !before.isNew) {
      moment.gap ??= before.gap;
      this.history.pop();
    }
    this.history.push(moment);
    if (this.history.length > MOST_KEPT) {
      this.history.shift();
      this.shown = Math.max(0, this.shown - 1);
    }
    this.shown = follows ? this.history.length - 1 : Math.min(this.shown, this.history.length - 1);
  }
}

// A controller on the page.
class View {
  seen = new Seen();
  #root;
  #label;
  #drawing;
  #chronogram;
  #signals;
  #steering;
  #drawn = null;
  #due = false;

  // `ask` says something to the tool.
  constructor(label, ask) {
    this.#label = label;
    this.#root = at("controller").content.firstElementChild.cloneNode(true);
    at("controllers").append(this.#root);
    this.#part(".place").textContent = label;
    this.#root.setAttribute("aria-label", label);
    this.#drawing = new Drawing(this.#part(".drawing"), at("hint"), {
      pointed: transition => this.#told(transition),
      chosen: (kind, number, isAlone) => { if (kind === "step" && isAlone) this.#steering.toggle(number); },
    });
    this.#chronogram = new Chronogram(this.#part(".chronogram"), moment => this.look(moment));
    this.#signals = new Signals(this.#part(".signals"));
    this.#steering = new Steering(this.#part(".steering"), { ask, mark: steps => this.#drawing.choose(steps) });
    this.#part(".now").addEventListener("click", () => this.look(this.seen.history.length - 1));
    this.show();
  }

  #part(selector) { return this.#root.querySelector(selector); }

  take(news) {
    this.seen.take(news);
    if (news.steered) this.#steering.take(news.steered);
    this.show();
  }

  refuse(why) { this.#steering.refuse(why); }

  look(moment) {
    this.seen.shown = moment;
    this.show();
  }

  hush() { this.#drawing.hush(); }

  // Once in a picture of the screen, however much has come.
  show() {
    if (this.#due) return;
    this.#due = true;
    requestAnimationFrame(() => {
      this.#due = false;
      this.#show();
    });
  }

  #show() {
    const { names, moment, isLive, line } = this.seen;
    this.#part("h2").textContent = names?.chart ?? "No chart yet";
    this.tick();
    const unknown = line?.unknown ?? null;
    this.#part(".unknown").hidden = unknown === null;
    if (unknown !== null) this.#part(".unknown").replaceChildren(...rich(`What the chart does now is not known: ${unknown}.`));
    this.#root.classList.toggle("idle", !moment);
    this.#root.classList.toggle("lost", unknown !== null && isLive);
    if (this.#drawn !== names) {
      this.#drawn = names;
      if (names) this.#drawing.draw(this.seen.drawing);
      else this.#part(".drawing").replaceChildren();
    }
    this.#steering.show(this.seen, this.seen.takes, Boolean(moment) && unknown === null && isOpen);
    this.#part(".now").hidden = !moment || isLive;
    this.#part(".past output").textContent = !moment || isLive ? "" : `The past, ${moment.time} after the first moment.`;
    if (!moment) {
      this.#part(".clock").textContent = "";
      for (const part of [".signals", ".waits", ".did"]) this.#part(part).replaceChildren();
      return this.#drawing.clear();
    }
    this.#part(".clock").textContent = `${moment.time} · cycle ${moment.number}`;
    this.#chronogram.draw(this.seen);
    // Where nothing is known of the present, nothing is shown as if it were.
    const isUnknown = unknown !== null && isLive;
    this.#signals.show(isUnknown ? this.seen.without() : this.seen);
    if (isUnknown) {
      list(this.#part(".waits"), ["not known now"]);
      this.#drawing.clear();
    } else {
      list(this.#part(".waits"), moment.said);
      this.#mark(moment);
    }
    list(this.#part(".did"), this.#happened());
  }

  #mark(moment) {
    this.#drawing.mark({
      steps: new Set(moment.steps),
      entered: new Set(moment.evolutions.flatMap(one => one.entered)),
      cleared: new Set(moment.evolutions.flatMap(one => one.cleared)),
      enabled: new Set(moment.waits.map(([transition]) => transition)),
    });
  }

  // How the line does.
  tick() {
    const { line, heard } = this.seen;
    this.#steering.tick();
    if (!line) return;
    const count = (number, one, many) => number === 0 ? [] : [`${number} ${number === 1 ? one : many}`];
    const ago = heard === null ? [] : [`the last one ${Math.max(0, Math.round((performance.now() - heard) / 1000))} s ago`];
    const text = [line.state || "not opened yet", `${line.bytes} bytes`, `${line.frames} ${line.frames === 1 ? "frame" : "frames"}`, ...ago,
      ...count(line.damaged, "damaged", "damaged"), ...count(line.lost, "lost", "lost")].join(", ");
    if (this.#part(".line").textContent !== text) this.#part(".line").textContent = text;
  }

  // What the last moment did in which anything happened, and what is missing in front of this one.
  #happened() {
    const { history, shown, moment } = this.seen;
    const gap = moment.gap ? [`before this there is a gap${moment.gap.cycles ? ` of ${moment.gap.cycles} cycles` : ""}: ${moment.gap.reason}`] : [];
    const late = moment.late.map(step => `\`${step}\` is late`);
    const last = history.slice(Math.max(0, shown - 500), shown + 1).findLast(one => one.isNew && one.did.length > 0);
    return [...gap, ...late, ...(last ? [`at ${last.time}:`, ...last.did] : ["nothing yet"])];
  }

  #told(transition) {
    const { names, moment, line } = this.seen;
    if (!names || !moment || line.unknown) return rich("What the chart does now is not known.");
    const { condition } = names.transitions[transition];
    const waits = moment.waits.filter(([one]) => one === transition).map(([, text]) => text);
    const lines = waits.length > 0 ? waits : [`\`${condition}\` is not asked: not all of its steps are active`];
    return lines.flatMap((line, index) => index === 0 ? rich(line) : [document.createElement("br"), ...rich(line)]);
  }

  // For who listens.
  get spoken() {
    const { names, moment, line } = this.seen;
    if (!names || !moment) return `${this.#label}: nothing yet`;
    if (line.unknown) return `${names.chart}: not known now`;
    return `${names.chart}: in ${moment.steps.map(step => names.steps[step]).join(", ") || "no step"}`;
  }
}

const views = [];
// Whether the tool hears what is said.
let isOpen = false;

function open() {
  const address = new URL("socket", location.href);
  address.protocol = "ws:";
  const socket = new WebSocket(address);
  socket.addEventListener("open", () => {
    at("severed").hidden = true;
    isOpen = true;
  });
  socket.addEventListener("message", ({ data }) => {
    const news = JSON.parse(data);
    if (news.sources) {
      views.length = 0;
      at("controllers").replaceChildren();
      views.push(...news.sources.map((label, source) => new View(label, words => socket.send(JSON.stringify({ ...words, source })))));
    } else if (news.refused) views[news.source].refuse(news.refused);
    else views[news.source].take(news);
  });
  socket.addEventListener("close", () => {
    isOpen = false;
    views.forEach(view => view.show());
    at("severed").textContent = "The tool does not answer: what is shown is the past. Trying again.";
    at("severed").hidden = false;
    setTimeout(open, AGAIN);
  });
}

theme(at("theme"));
open();
setInterval(() => views.forEach(view => view.tick()), 1000);
// Not each cycle: who listens would hear nothing else.
setInterval(() => {
  const text = views.map(view => view.spoken).join("; ");
  if (at("spoken").textContent !== text) at("spoken").textContent = text;
}, 3000);
document.addEventListener("keydown", event => { if (event.key === "Escape") views.forEach(view => view.hush()); });
document.addEventListener("scroll", () => views.forEach(view => view.hush()), true);

// For tests.
Object.assign(globalThis, { live: { views } });
