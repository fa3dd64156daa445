// The picture of the chart, with marks on it that move.

export class Drawing {
  #place;
  #hint;
  #steps = [];
  #bars = [];
  #svg = null;
  #shown = "";

  // `pointed` gets the number of a transition and says what to show there; `chosen` gets "step" or "transition", its number, and whether it is that alone: a macro-step is all of its steps.
  constructor(place, hint, { pointed, chosen }) {
    this.#place = place;
    this.#hint = hint;
    const bar = event => event.target.closest?.("[data-transition]");
    place.addEventListener("pointermove", event => {
      const mark = bar(event);
      if (mark) this.#tell(mark, pointed(Number(mark.dataset.transition)));
      else this.hush();
    });
    place.addEventListener("pointerleave", () => this.hush());
    place.addEventListener("click", event => {
      const mark = bar(event), step = event.target.closest?.("[data-steps]");
      if (mark) {
        this.#tell(mark, pointed(Number(mark.dataset.transition)));
        chosen("transition", Number(mark.dataset.transition));
      } else if (step) {
        const steps = step.dataset.steps.split(" ");
        chosen("step", Number(steps[0]), steps.length === 1);
      }
    });
  }

  // A picture of `grafcet_draw::svg_live`; what was drawn last stays where there is none.
  draw(text) {
    this.#place.classList.toggle("outdated", text === null);
    if (text === null || text === this.#shown) return;
    this.#shown = text;
    // Its one style is its size, which the policy for contents refuses in a text; a script may set it.
    const bare = text.replace(/ style="([^"]*)"/, "");
    const parsed = new DOMParser().parseFromString(bare, "image/svg+xml").documentElement;
    const svg = document.importNode(parsed, true);
    const [, , wide, high] = svg.getAttribute("viewBox").split(" ").map(Number);
    // Not smaller than can be read: what is wider yet is scrolled.
    svg.style.width = `${wide}px`;
    svg.style.maxWidth = `max(100%, ${Math.round(wide * 0.6)}px)`;
    svg.style.aspectRatio = `${wide} / ${high}`;
    this.#steps = [...svg.querySelectorAll("[data-steps]")].map(mark => ({ mark, of: mark.dataset.steps.split(" ").map(Number) }));
    this.#bars = [...svg.querySelectorAll("[data-transition]")].map(mark => ({ mark, of: Number(mark.dataset.transition) }));
    this.#svg = svg;
    this.#place.replaceChildren(svg);
    this.hush();
  }

  // The active steps, those entered and the transitions cleared in the cycle that is shown, and the transitions that are enabled.
  mark({ steps, entered, cleared, enabled }) {
    for (const { mark, of } of this.#steps) {
      mark.classList.toggle("on", of.some(step => steps.has(step)));
      mark.classList.toggle("entered", of.some(step => entered.has(step)));
    }
    for (const { mark, of } of this.#bars) {
      mark.classList.toggle("cleared", cleared.has(of));
      mark.classList.toggle("enabled", enabled.has(of));
    }
  }

  // The steps that are chosen, for something that is still to happen.
  choose(steps) {
    for (const { mark, of } of this.#steps) mark.classList.toggle("chosen", of.length === 1 && steps.has(of[0]));
  }

  clear() { this.mark({ steps: new Set(), entered: new Set(), cleared: new Set(), enabled: new Set() }); }

  get isDrawn() { return this.#svg !== null; }

  hush() { this.#hint.hidden = true; }

  #tell(mark, nodes) {
    this.#hint.replaceChildren(...nodes);
    this.#hint.hidden = false;
    const at = mark.getBoundingClientRect(), size = this.#hint.getBoundingClientRect();
    const x = Math.max(8, Math.min(at.right + 10, innerWidth - size.width - 8));
    const y = at.bottom + size.height + 8 < innerHeight ? at.bottom + 6 : at.top - size.height - 6;
    this.#hint.style.left = `${x}px`;
    this.#hint.style.top = `${Math.max(8, y)}px`;
  }
}
