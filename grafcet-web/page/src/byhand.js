// Steps to choose, in the drawing or in a list: a cycle by hand leads into exactly these. Only for charts that let themselves be put anywhere.

export class ByHand {
  #open = document.getElementById("by-hand");
  #panel = document.getElementById("situation");
  #list = this.#panel.querySelector(".steps");
  #names = null;
  #chosen = null;
  #boxes = [];
  #mark;

  // `force` gets the steps; `mark` gets them as they are chosen.
  constructor({ force, mark }) {
    this.#mark = mark;
    this.#open.addEventListener("click", () => this.#choose(this.#chosen === null ? new Set() : null));
    this.#panel.querySelector(".leave").addEventListener("click", () => this.#choose(null));
    this.#panel.querySelector(".force").addEventListener("click", () => {
      force([...this.#chosen].sort((one, other) => one - other));
      this.#choose(null);
    });
  }

  get isChoosing() { return this.#chosen !== null; }

  show({ names }) {
    if (names === this.#names) return;
    this.#names = names;
    this.#open.hidden = !names.forceable;
    this.#boxes = names.steps.map((name, step) => {
      const label = document.createElement("label"), box = document.createElement("input");
      box.type = "checkbox";
      box.addEventListener("change", () => this.toggle(step));
      label.append(box, name);
      return { label, box };
    });
    this.#list.replaceChildren(...this.#boxes.map(one => one.label));
    this.#choose(null);
  }

  // A step was clicked, here or in the drawing.
  toggle(step) {
    if (this.#chosen === null || !(step in this.#boxes)) return;
    if (!this.#chosen.delete(step)) this.#chosen.add(step);
    this.#choose(this.#chosen);
  }

  #choose(chosen) {
    // The button that has the focus goes away with the panel.
    const returns = chosen === null && this.#panel.contains(document.activeElement);
    this.#chosen = chosen;
    this.#panel.hidden = chosen === null;
    this.#open.setAttribute("aria-expanded", String(chosen !== null));
    this.#boxes.forEach(({ box }, step) => { box.checked = chosen?.has(step) ?? false; });
    this.#mark(chosen ?? new Set());
    if (returns) this.#open.focus();
  }
}
