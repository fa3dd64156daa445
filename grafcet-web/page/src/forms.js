// The chart in other notations, a tab each.

import { rich } from "../../../cargo-grafcet/src/watch/page/rich.js";

export class Forms {
  #tabs = [...document.querySelectorAll("[role=tab]")];
  #panel = document.getElementById("panel");
  #drawing = document.getElementById("drawing");
  #text = document.getElementById("translation");
  #ask;
  #go;
  #source = null;
  form = "drawing";

  // `ask` gets a text and a notation; `go` leads to a place of the text.
  constructor(ask, go) {
    this.#ask = ask;
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
    let done;
    try {
      done = await this.#ask(source, form);
    } catch (error) {
      done = { refused: [{ text: error.message, from: null, to: null }] };
    }
    // Somebody has gone on meanwhile.
    if (form !== this.form || source !== this.#source) return;
    this.#text.replaceChildren(...(done.refused ? done.refused.map(one => this.#refused(one)) : this.#written(done, form)));
  }

  #written({ text, notes }, form) {
    const code = document.createElement("pre");
    code.textContent = text;
    const copy = document.createElement("button");
    copy.type = "button";
    copy.textContent = "Copy";
    copy.className = "copy";
    copy.addEventListener("click", async () => {
      await navigator.clipboard.writeText(text);
      copy.textContent = "Copied";
    });
    const said = notes.map(note => {
      const line = document.createElement("p");
      line.className = "note";
      line.append(...rich(note));
      return line;
    });
    code.dataset.form = form;
    return [copy, ...said, code];
  }

  #refused({ text, from, to }) {
    const line = document.createElement("p");
    line.className = "note";
    line.append(...rich(text));
    if (from !== null) {
      const lead = document.createElement("button");
      lead.type = "button";
      lead.textContent = "Show";
      lead.addEventListener("click", () => this.#go(from, to));
      line.append(" ", lead);
    }
    return line;
  }
}
