// What the chart is given and what it gives: inputs to click, outputs to read.

function made(tag, properties, ...children) {
  const element = Object.assign(document.createElement(tag), properties);
  element.append(...children);
  return element;
}

// Longer is held and not clicked, in milliseconds.
const HELD = 350;

// A click turns the input around; who holds it, as one does with a push button, lets go of it again.
function held(button, is, set) {
  let was = false, since = 0;
  button.addEventListener("pointerdown", event => {
    if (event.button !== 0) return;
    button.setPointerCapture(event.pointerId);
    was = is();
    since = event.timeStamp;
    if (!was) set(true);
  });
  button.addEventListener("pointerup", event => { if (!was && event.timeStamp - since > HELD) set(false); });
  // It was the beginning of a scroll.
  button.addEventListener("pointercancel", () => { if (!was) set(false); });
  button.addEventListener("click", event => {
    const byKey = event.detail === 0;
    if (byKey) set(!is());
    else if (was) set(false);
  });
}

export class Signals {
  #place;
  #names = null;
  #inputs = [];
  #params = [];
  #outputs = [];

  // `set` and `setParam` get a place and a value; without them inputs and parameters are only read.
  constructor(place, { set, setParam } = {}) {
    this.#place = place;
    this.set = set;
    this.setParam = setParam;
  }

  show(simulation) {
    const { names, values, params, moment } = simulation;
    if (names !== this.#names) this.#build(names);
    this.#inputs.forEach((input, place) => input(values[place], moment.number > 0 && values[place] !== moment.values[place]));
    this.#params.forEach((param, place) => param(params[place], false));
    this.#outputs.forEach(output => output(moment));
  }

  #build(names) {
    this.#names = names;
    this.#inputs = [];
    this.#params = [];
    this.#outputs = [];
    const group = (title, rows) => rows.length === 0 ? [] : [made("h3", { textContent: title }), made("div", { className: "group" }, ...rows)];
    const controls = names.signals.map((signal, place) => this.#control(signal, this.set && (value => this.set(place, value)), this.#inputs));
    const params = names.params.map((signal, place) => this.#control(signal, this.setParam && (value => this.setParam(place, value)), this.#params));
    const outputs = (list, field) => list.map((signal, place) => this.#output(signal, moment => moment[field][place]));
    this.#place.replaceChildren(
      ...group("Inputs", controls.slice(0, names.inputs)), ...group("Of the program", controls.slice(names.inputs)), ...group("Parameters", params),
      ...group("Outputs", outputs(names.outputs, "outputs")), ...group("Variables", outputs(names.variables, "variables")));
  }

  #control({ name, kind }, set, all) {
    if (!set) return this.#row({ name, kind }, all);
    if (kind.is === "bool") {
      const lamp = made("span", { className: "lamp" });
      const button = made("button", { type: "button", className: "input" }, lamp, name);
      held(button, () => button.getAttribute("aria-pressed") === "true", set);
      all.push((value, waits) => {
        button.setAttribute("aria-pressed", String(value === true));
        button.classList.toggle("waits", waits);
      });
      return button;
    }
    const field = kind.is === "listed" ? made("select", {}, ...kind.list.map(one => made("option", { value: one, textContent: one })))
      : made("input", { type: kind.is === "other" ? "text" : "number", step: kind.is === "float" ? "any" : "1" });
    const label = made("label", { className: "input" }, made("span", { textContent: name }), field);
    field.addEventListener("change", () => set(field.value));
    all.push((value, waits) => {
      if (document.activeElement !== field || kind.is === "listed") field.value = String(value);
      label.classList.toggle("waits", waits);
    });
    return label;
  }

  #output(signal, of) {
    const shown = [], row = this.#row(signal, shown);
    this.#outputs.push(moment => shown[0](of(moment)));
    return row;
  }

  // A name with a value to read.
  #row({ name, kind }, all) {
    const lamp = made("span", { className: "lamp" }), value = made("span", { className: "value" });
    const row = made("div", { className: "output" }, ...(kind.is === "bool" ? [lamp] : []), made("span", { textContent: name }), value);
    all.push(now => {
      row.classList.toggle("on", now === true);
      value.textContent = typeof now === "boolean" ? (now ? "on" : "off") : String(now);
    });
    return row;
  }
}
