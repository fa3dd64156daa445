// Signals and steps over the time, as far as the simulation has come. Somebody drags along it to look at the past.

const ROW = 22, HEAD = 20, SIGNAL = 14, LEFT = 118, RIGHT = 12;
// So many changes are shown at most; what is older has left the paper.
const MOST = 400;
const NS = "http://www.w3.org/2000/svg";

function element(name, attributes, text) {
  const made = document.createElementNS(NS, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  if (text !== undefined) made.textContent = text;
  return made;
}

// Times as a person reads them: `2.5 s`.
export function time(ticks, nanosPerTick) {
  const nanos = ticks * nanosPerTick;
  if (nanos === 0) return "0 s";
  const [unit, size] = [["s", 1e9], ["ms", 1e6], ["µs", 1e3], ["ns", 1]].find(([, size]) => nanos >= size) ?? ["ns", 1];
  return `${Number((nanos / size).toFixed(3))} ${unit}`;
}

// Steps of 1, 2 or 5 between the marks of an axis.
function distance(span, most) {
  const raw = span / most, power = 10 ** Math.floor(Math.log10(raw));
  return Math.max(1, [1, 2, 5, 10].map(one => one * power).find(one => one >= raw));
}

export class Chronogram {
  #place;
  #svg = element("svg", { "aria-hidden": "true", focusable: "false" });
  #from = 0;
  #ticksPerPixel = 1;
  #first = 0;
  #simulation = null;

  // `looked` gets the number of the moment somebody points at.
  constructor(place, looked) {
    this.#place = place;
    place.append(this.#svg);
    let dragging = false;
    const point = event => looked(this.#at(event.clientX - this.#svg.getBoundingClientRect().left));
    place.addEventListener("pointerdown", event => {
      if (event.button !== 0 || !this.#simulation) return;
      dragging = true;
      place.setPointerCapture(event.pointerId);
      point(event);
    });
    place.addEventListener("pointermove", event => { if (dragging) point(event); });
    place.addEventListener("lostpointercapture", () => { dragging = false; });
    place.addEventListener("keydown", event => {
      if (!this.#simulation) return;
      const { shown, history } = this.#simulation;
      const to = { ArrowLeft: shown - 1, ArrowRight: shown + 1, PageUp: shown - 10, PageDown: shown + 10, Home: 0, End: history.length - 1 }[event.key];
      if (to === undefined) return;
      event.preventDefault();
      looked(Math.max(0, Math.min(history.length - 1, to)));
    });
    new ResizeObserver(() => { if (this.#simulation) this.draw(this.#simulation); }).observe(place);
  }

  // The last moment that began at this place or before.
  #at(x) {
    const tick = this.#from + (x - LEFT) * this.#ticksPerPixel, { history } = this.#simulation;
    let low = 0, high = history.length - 1;
    while (low < high) {
      const middle = Math.ceil((low + high) / 2);
      if (this.#simulation.begins(history[middle]) <= tick) low = middle; else high = middle - 1;
    }
    return low;
  }

  draw(simulation) {
    this.#simulation = simulation;
    const { names, history, shown, step } = simulation;
    if (!names) return;
    if (history.length === 0) return this.#svg.replaceChildren();
    const first = this.#first = this.#beginning(history.length, shown), seen = history.slice(first, first + MOST);
    const wide = Math.max(260, this.#place.clientWidth), length = wide - LEFT - RIGHT;
    const from = simulation.begins(seen[0]), end = Math.max(seen[seen.length - 1].elapsed + step, from + 50 * step);
    this.#from = from;
    this.#ticksPerPixel = (end - from) / length;
    const x = elapsed => Math.round((LEFT + (elapsed - from) / this.#ticksPerPixel) * 10) / 10;
    const rows = this.#rows(names);
    const high = HEAD + rows.length * ROW + 4;
    const parts = [];
    this.#axis(parts, { from, end, x, high, names });
    const starts = seen.map(moment => x(simulation.begins(moment))), last = x(seen[seen.length - 1].elapsed + step);
    // A moment lasts up to the next one; of the time before a gap nobody knows more than the moment itself.
    const ends = seen.map((moment, index) => index + 1 === seen.length ? last : seen[index + 1].gap ? Math.min(x(moment.elapsed + step), starts[index + 1]) : starts[index + 1]);
    rows.forEach((row, index) => this.#row(parts, row, HEAD + index * ROW, seen, starts, ends));
    this.#gaps(parts, seen, starts, ends, high);
    if (shown >= first && shown - first < starts.length) {
      const at = starts[shown - first], to = ends[shown - first];
      parts.push(element("rect", { class: "span", x: at, y: HEAD - 4, width: Math.max(2, to - at), height: high - HEAD + 4 }));
    }
    this.#svg.setAttribute("viewBox", `0 0 ${wide} ${high}`);
    this.#svg.setAttribute("width", wide);
    this.#svg.setAttribute("height", high);
    this.#svg.replaceChildren(...parts);
    this.#place.setAttribute("aria-valuemax", history.length - 1);
    this.#place.setAttribute("aria-valuenow", shown);
    this.#place.setAttribute("aria-valuetext", `${simulation.moment.time}, cycle ${simulation.moment.number}, in ${simulation.moment.steps.map(one => names.steps[one]).join(", ") || "no step"}`);
  }

  // The first moment that is shown: the last ones are, or those around the one that is looked at.
  #beginning(length, shown) {
    const latest = Math.max(0, length - MOST);
    if (shown >= latest) return latest;
    const is = shown >= this.#first && shown < this.#first + MOST;
    return is ? Math.min(this.#first, latest) : Math.max(0, Math.min(latest, shown - MOST / 2));
  }

  // Where nobody knows what was.
  #gaps(parts, seen, starts, ends, high) {
    seen.forEach((moment, index) => {
      if (!moment.gap) return;
      const from = index > 0 ? ends[index - 1] : starts[0] - 3;
      const gap = element("rect", { class: "gap", x: from, y: HEAD - 4, width: Math.max(3, starts[index] - from), height: high - HEAD + 4 });
      gap.append(element("title", {}, moment.gap.reason));
      parts.push(gap);
    });
  }

  // Everything that has a value: a name, what kind of row it is, and how to read it of a moment.
  #rows(names) {
    const signals = (list, field, kind) => list.map((signal, place) => ({ name: signal.name, kind, is: signal.kind.is, of: moment => moment[field][place] }));
    const steps = names.steps.map((name, place) => ({ name, kind: "step", is: "bool", of: moment => moment.steps.includes(place) }));
    return [...signals(names.signals, "values", "input"), ...steps, ...signals(names.outputs, "outputs", "output"), ...signals(names.variables, "variables", "variable")];
  }

  #axis(parts, { from, end, x, high, names }) {
    const apart = distance(end - from, Math.max(3, Math.min(8, (x(end) - LEFT) / 80)));
    for (let tick = Math.ceil(from / apart) * apart; tick <= end; tick += apart) {
      parts.push(element("path", { class: "grid", d: `M${x(tick)} ${HEAD - 4}V${high}` }), element("text", { class: "label", x: x(tick), y: 10 }, time(tick, names.nanosPerTick)));
    }
  }

  #row(parts, { name, kind, is, of }, top, seen, starts, ends) {
    const text = element("text", { class: `name ${kind}`, x: 8, y: top + ROW / 2 + 1 }, name.length > 15 ? `${name.slice(0, 14)}…` : name);
    text.append(element("title", {}, name));
    parts.push(text);
    const low = top + (ROW + SIGNAL) / 2, highest = low - SIGNAL;
    const values = seen.map(of);
    if (is === "bool") {
      let path = "", area = "";
      values.forEach((value, index) => {
        const end = ends[index], y = value ? highest : low;
        // After a gap a value may not be known yet.
        if (value === "?") return;
        path += index === 0 || seen[index].gap || values[index - 1] === "?" ? `M${starts[index]} ${y}` : value === values[index - 1] ? "" : `V${y}`;
        path += `H${end}`;
        if (value) area += `M${starts[index]} ${low}V${highest}H${end}V${low}Z`;
      });
      parts.push(element("path", { class: `area ${kind}`, d: area }), element("path", { class: `wave ${kind}`, d: path }));
      return;
    }
    for (let index = 0; index < values.length;) {
      let next = index + 1;
      while (next < values.length && values[next] === values[index] && !seen[next].gap) next++;
      const begin = starts[index], end = ends[next - 1];
      parts.push(element("rect", { class: `band ${kind}`, x: begin, y: highest, width: Math.max(0.5, end - begin), height: SIGNAL }));
      const said = String(values[index]);
      if (end - begin > said.length * 7 + 6) parts.push(element("text", { class: "value", x: begin + 4, y: top + ROW / 2 + 1 }, said));
      index = next;
    }
  }
}
