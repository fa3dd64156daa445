// The chart in other notations, a tab each.

import { rich } from "../../../cargo-grafcet/src/watch/page/rich.js";
import { Ended, Late, Single } from "./engine.js";

// So long a person waits for a text, in milliseconds.
const LONGEST = 10_000;
// So soon it is said that it is being written.
const SOON = 300;
// So many characters of a text are shown: a browser takes seconds for millions.
const SHOWN = 300_000;

export class Forms {
  #tabs = [...document.querySelectorAll("[role=tab]")];
  #panel = document.getElementById("panel");
  #drawing = document.getElementById("drawing");
  #text = document.getElementById("translation");
  #engine = new Single();
  #go;
  #source = null;
  form = "drawing";

  // `go` leads to a place of the text.
  constructor(go) {
    this.#go = go;
    for (const tab of this.#tabs) tab.addEventListener("click", () => this.#choose(tab));
    this.#tabs[0].parentElement.addEventListener("keydown", event => {
      const at = this.#tabs.indexOf(document.activeElement);
      const to = { ArrowLeft: at - 1, ArrowRight: at + 1, Home: 0, End: this.#tabs.length - 1 }[event.key];
      if (at < 0 || to === undefined) return;
      event.preventDefault();
      const tab = this.#tabs[(to + this.#tabs.length) % this.#tabs.length];
      tab.focus();
      this.#choose(tab);
    });
  }

  // There is another text.
  of(source) {
    this.#source = source;
    if (this.form !== "drawing") void this.#show();
  }

  #choose(tab) {
    for (const other of this.#tabs) {
      other.setAttribute("aria-selected", String(other === tab));
      other.tabIndex = other === tab ? 0 : -1;
    }
    this.form = tab.dataset.form;
    this.#panel.setAttribute("aria-labelledby", tab.id);
    this.#drawing.hidden = this.form !== "drawing";
    this.#text.hidden = this.form === "drawing";
    if (this.form !== "drawing") void this.#show();
  }

  async #show() {
    const { form } = this, source = this.#source;
    // What is typed first comes first; it is asked for again when it has been looked at.
    if (source === null) return;
    const soon = setTimeout(() => this.#text.replaceChildren(note("It is being written…")), SOON);
    let done;
    try {
      done = await this.#engine.ask(LONGEST, "translate", source, form);
    } catch (error) {
      // Somebody has gone on meanwhile.
      if (error instanceof Ended) return;
      const late = `This takes longer than ${LONGEST / 1000} seconds and was given up. \`cargo grafcet\` takes its time.`;
      done = { refused: [{ text: error instanceof Late ? late : error.message, from: null, to: null }] };
    } finally {
      clearTimeout(soon);
    }
    if (form !== this.form || source !== this.#source) return;
    this.#text.replaceChildren(...(done.refused ? done.refused.map(one => this.#refused(one)) : this.#written(done, form)));
  }

  #written({ text, notes, file }, form) {
    const code = document.createElement("pre");
    code.textContent = text.slice(0, SHOWN);
    code.dataset.form = form;
    const buttons = document.createElement("div");
    buttons.className = "copy";
    const copy = button("Copy", async () => {
      // Browsers have a clipboard for pages that came encrypted or from this machine.
      try {
        await navigator.clipboard.writeText(text);
        copy.textContent = "Copied";
      } catch {
        copy.textContent = "No clipboard: download it";
      }
    });
    buttons.append(copy, button("Download", () => download(text, file)));
    const cut = text.length > SHOWN ? [`The first ${SHOWN.toLocaleString("en")} of ${text.length.toLocaleString("en")} characters are shown. Copy and Download take all.`] : [];
    return [buttons, ...[...notes, ...cut].map(note), code];
  }

  #refused({ text, from, to }) {
    const line = note(text);
    if (from !== null) line.append(" ", button("Show", () => this.#go(from, to)));
    return line;
  }
}

function note(text) {
  const line = document.createElement("p");
  line.className = "note";
  line.append(...rich(text));
  return line;
}

function button(text, click) {
  const button = document.createElement("button");
  button.type = "button";
  button.textContent = text;
  button.addEventListener("click", click);
  return button;
}

function download(text, file) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([text], { type: "text/plain;charset=utf-8" }));
  link.download = file;
  link.click();
  // The browser reads it after the click.
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}
