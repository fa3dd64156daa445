// Steering: what a person asks of the controller, and what became of it. It is here only where the tool was started with `--steer`, and has only the words
// that the chart has.

import { rich } from "./rich.js";

// So long an answer may take, in milliseconds; the tool waits as long before it takes the next command.
const PATIENCE = 3000;

// The mode in which a chart is, by the values of its inputs; null where that is not known.
function modeOf({ names, moment }) {
  const is = name => moment.values[names.signals.findIndex(one => one.name === name)];
  const given = [is("paused"), is("manual"), is("semi_automatic")];
  if (given.some(value => typeof value !== "boolean")) return null;
  return ["paused", "manual", "semi-automatic"].find((_, place) => given[place]) ?? "automatic";
}

// Asks a person; resolves to whether it shall be.
function confirmed(title, text, word) {
  const dialog = document.getElementById("confirm"), part = selector => dialog.querySelector(selector);
  part("h2").textContent = title;
  part(".what").replaceChildren(...rich(text));
  part(".yes").textContent = word;
  return new Promise(resolve => {
    part(".yes").onclick = () => dialog.close("yes");
    part(".no").onclick = () => dialog.close("no");
    dialog.onclose = () => resolve(dialog.returnValue === "yes");
    dialog.returnValue = "no";
    dialog.showModal();
    part(".no").focus();
  });
}

export class Steering {
  #root;
  #ask;
  #mark;
  #names = null;
  #takes = null;
  #chosen = null;
  #boxes = [];
  #sent = [];
  // When the list of commands came, by the clock of this page.
  #came = 0;
  #refused = null;

  // `ask` gets a command; `mark` gets the steps that are chosen, in the drawing.
  constructor(root, { ask, mark }) {
    this.#root = root;
    this.#ask = ask;
    this.#mark = mark;
    for (const button of this.#all("[data-mode]")) button.addEventListener("click", () => this.#say({ do: "mode", mode: button.dataset.mode }));
    this.#part(".push").addEventListener("click", () => this.#say({ do: "push" }));
    this.#part(".init").addEventListener("click", () => this.#init());
    this.#part(".choose").addEventListener("click", () => this.#choose(this.#chosen === null ? new Set() : null));
    this.#part(".leave").addEventListener("click", () => this.#choose(null));
    this.#part(".force").addEventListener("click", () => this.#force());
  }

  #part(selector) { return this.#root.querySelector(selector); }
  #all(selector) { return this.#root.querySelectorAll(selector); }

  // What the tool says of the last commands.
  take(sent) {
    this.#sent = sent;
    this.#came = performance.now();
    if (sent.length > 0 && sent.at(-1).outcome === null) this.#refused = null;
    this.tick();
  }

  // Why a command was not sent.
  refuse(why) {
    this.#refused = why;
    this.tick();
  }

  // `isKnown`: it is known what the chart does now.
  show(seen, takes, isKnown) {
    this.#root.hidden = !takes;
    if (this.#names !== seen.names) {
      this.#names = seen.names;
      this.#takes = takes;
      this.#build();
    }
    if (!takes) return;
    this.#part(".modes").hidden = !takes.modes;
    this.#part(".choose").hidden = !takes.forceable;
    const mode = takes.modes && isKnown && seen.latest ? modeOf({ names: seen.names, moment: seen.latest }) : null;
    for (const button of this.#all("[data-mode]")) button.setAttribute("aria-pressed", String(button.dataset.mode === mode));
    for (const button of this.#all("[data-mode], .push, .init, .choose, .force")) button.disabled = !isKnown;
  }

  #build() {
    this.#chosen = null;
    this.#refused = null;
    this.#boxes = (this.#names?.steps ?? []).map((name, step) => {
      const label = document.createElement("label"), box = document.createElement("input");
      box.type = "checkbox";
      box.addEventListener("change", () => this.toggle(step));
      label.append(box, name);
      return { label, box };
    });
    this.#part(".steps").replaceChildren(...this.#boxes.map(one => one.label));
    this.#choose(null);
  }

  get isChoosing() { return this.#chosen !== null; }

  // A step was clicked, here or in the drawing.
  toggle(step) {
    if (this.#chosen === null || !(step in this.#boxes)) return;
    if (!this.#chosen.delete(step)) this.#chosen.add(step);
    this.#choose(this.#chosen);
  }

  #choose(chosen) {
    this.#chosen = chosen;
    this.#part(".situation").hidden = chosen === null;
    this.#part(".choose").setAttribute("aria-expanded", String(chosen !== null));
    this.#boxes.forEach(({ box }, step) => { box.checked = chosen?.has(step) ?? false; });
    this.#mark(chosen ?? new Set());
  }

  #say(words) {
    this.#refused = null;
    this.#ask({ ...words, chart: this.#takes.chart });
  }

  async #init() {
    const names = this.#names;
    const text = `\`${names.chart}\` goes back to its initial situation, whatever the machine is doing. What an output has moved stays where it is.`;
    if (await confirmed("Init?", text, "Init") && this.#names === names) this.#say({ do: "init" });
  }

  async #force() {
    const names = this.#names, steps = [...this.#chosen].sort((one, other) => one - other);
    const listed = steps.map(step => `\`${names.steps[step]}\``).join(", ") || "no step";
    const text = `\`${names.chart}\` goes into the situation of exactly ${listed}, whatever its conditions say. What they make sure of on the way there has not happened. `
      + "Somebody has to stand beside the machine, with an emergency stop that does not depend on this chart.";
    if (!await confirmed("Force?", text, "Force") || this.#names !== names) return;
    this.#say({ do: "force", steps });
    this.#choose(null);
  }

  // What became of the last commands.
  tick() {
    const said = ({ what, ago, outcome }) => {
      if (outcome?.accepted) return ["good", `${what}: accepted`];
      if (outcome) return ["bad", `${what}: refused: ${outcome.why}`];
      if (ago + performance.now() - this.#came < PATIENCE) return ["", `${what}: sent`];
      return ["bad", `${what}: no answer. The program on the controller may not take commands`];
    };
    const lines = this.#sent.map(said);
    if (this.#refused !== null) lines.push(["bad", `not sent: ${this.#refused}`]);
    const text = lines.map(([, line]) => line).join("\n");
    if (this.#part(".steered").dataset.text === text) return;
    this.#part(".steered").dataset.text = text;
    this.#part(".steered").replaceChildren(...lines.reverse().map(([kind, line]) => {
      const item = document.createElement("p");
      if (kind) item.className = kind;
      item.append(...rich(line));
      return item;
    }));
  }
}
