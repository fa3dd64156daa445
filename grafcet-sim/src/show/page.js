"use strict";
const data = JSON.parse(document.getElementById("data").textContent);
const at = id => document.getElementById(id);
const chart = document.querySelector(".chart"), waves = document.querySelector(".waves");
const steps = [...chart.querySelectorAll("[data-steps]")].map(mark => ({ mark, of: mark.dataset.steps.split(" ").map(Number) }));
const bars = [...chart.querySelectorAll("[data-transition]")].map(mark => ({ mark, of: Number(mark.dataset.transition) }));
const last = data.cycles.length - 1;
// The cycle that is shown, and how many of its evolutions have taken place.
let cycle = 0, done = 0;
// While one drags, nothing but the pointer moves.
let dragging = false;

const place = tick => data.left + tick * data.length / data.starts[data.starts.length - 1];

for (const { mark, of } of steps) mark.classList.toggle("never", of.every(step => data.entered[step] === 0));
for (const { mark, of } of bars) mark.classList.toggle("never", data.cleared[of] === 0);

// Text with what stands between backquotes as code.
function said(list, lines) {
  list.replaceChildren(...lines.map(line => {
    const item = document.createElement("li");
    line.split("`").forEach((part, index) => {
      const piece = index % 2 ? document.createElement("code") : document.createTextNode(part);
      if (index % 2) piece.textContent = part;
      item.append(piece);
    });
    return item;
  }));
}

function values(kind) {
  const now = data.cycles[cycle][kind], before = cycle > 0 ? data.cycles[cycle - 1][kind] : now;
  at(kind).replaceChildren(...data[kind].flatMap((name, index) => {
    const [term, value] = ["dt", "dd"].map(tag => document.createElement(tag));
    term.textContent = name;
    term.title = name;
    value.textContent = now[index] === true ? "1" : now[index] === false ? "0" : now[index];
    for (const cell of [term, value]) cell.classList.toggle("on", now[index] === true);
    term.classList.toggle("new", now[index] !== before[index]);
    return [term, value];
  }));
  at(kind).parentElement.hidden = data[kind].length === 0;
}

// The active steps in front of a cycle: those of the cycle before, unless there is a gap between them.
function before(number) {
  const { evolutions, steps } = data.cycles[number];
  if (evolutions.length === 0) return steps;
  const { left, entered, steps: after } = evolutions[0];
  return [...left, ...after.filter(step => !entered.includes(step))];
}

function show() {
  const shown = data.cycles[cycle];
  if (!shown) return;
  const all = shown.evolutions, evolution = done > 0 ? all[done - 1] : null;
  const active = new Set(done === all.length ? shown.steps : done > 0 ? all[done - 1].steps : before(cycle));
  for (const { mark, of } of steps) {
    mark.classList.toggle("on", of.some(step => active.has(step)));
    mark.classList.toggle("entered", !!evolution && of.some(step => evolution.entered.includes(step)));
    mark.classList.toggle("left", !!evolution && of.every(step => !active.has(step)) && of.some(step => evolution.left.includes(step)));
  }
  for (const { mark, of } of bars) mark.classList.toggle("cleared", !!evolution && evolution.cleared.includes(of));
  at("time").value = cycle;
  at("time").setAttribute("aria-valuetext", ["cycle " + cycle, shown.time].filter(Boolean).join(", "));
  at("now").textContent = ["cycle " + cycle, shown.time].filter(Boolean).join(" · ");
  at("which").textContent = all.length === 0 ? "no evolution" : `evolution ${done} of ${all.length}`;
  at("back").disabled = cycle === 0;
  at("on").disabled = cycle === last;
  at("up").disabled = cycle === 0 && done === 0;
  at("down").disabled = cycle === last && done === all.length;
  const name = list => list.map(step => "`" + data.steps[step] + "`").join(", ");
  const took = all.slice(0, done).map(one => {
    const cleared = one.cleared.map(id => "`" + data.transitions[id] + "`").join(", ");
    const entered = one.entered.length ? ", entered " + name(one.entered) : "", left = one.left.length ? ", left " + name(one.left) : "";
    return (cleared ? "cleared " + cleared : "forced") + left + entered;
  });
  const end = done === all.length;
  said(at("did"), [...took, ...(end ? shown.did : []), ...(end && !shown.stable ? ["the search for a stable situation was stopped by its bound"] : [])]);
  if (!at("did").children.length) said(at("did"), ["nothing"]);
  said(at("waits"), end ? shown.waits : ["in the middle of the cycle"]);
  at("gap").hidden = shown.gap === null;
  at("gap").textContent = shown.gap === null ? "" : "Gap in front of this cycle: " + shown.gap;
  ["inputs", "outputs", "variables"].forEach(values);
  const from = place(data.starts[cycle]), to = place(data.starts[cycle + 1]);
  at("span").setAttribute("x", from);
  at("span").setAttribute("width", Math.max(2, to - from));
  if (dragging) return;
  if (from < waves.scrollLeft || to > waves.scrollLeft + waves.clientWidth) waves.scrollLeft = from - waves.clientWidth / 2;
}

function go(to, evolutions) {
  cycle = Math.max(0, Math.min(last, to));
  const all = data.cycles[cycle] ? data.cycles[cycle].evolutions.length : 0;
  done = evolutions === undefined ? all : Math.max(0, Math.min(all, evolutions));
  show();
}

// Through the evolutions of a cycle, then on to the next.
function step(by) {
  const all = data.cycles[cycle].evolutions.length;
  if (done + by >= 0 && done + by <= all) go(cycle, done + by);
  else if (by > 0 && cycle < last) go(cycle + 1, Math.min(1, data.cycles[cycle + 1].evolutions.length));
  else if (by < 0 && cycle > 0) go(cycle - 1);
}

// The cycle at a place of the chronogram.
function pointed(event) {
  const x = event.clientX - at("chronogram").getBoundingClientRect().left;
  const tick = (x - data.left) * data.starts[data.starts.length - 1] / data.length;
  let low = 0, high = last;
  while (low < high) {
    const middle = Math.ceil((low + high) / 2);
    if (data.starts[middle] <= tick) low = middle; else high = middle - 1;
  }
  go(low);
}

at("chronogram").addEventListener("pointerdown", event => {
  if (event.button !== 0) return;
  at("chronogram").setPointerCapture(event.pointerId);
  dragging = true;
  pointed(event);
});
at("chronogram").addEventListener("pointermove", event => { if (dragging) pointed(event); });
at("chronogram").addEventListener("lostpointercapture", () => { dragging = false; });
at("time").addEventListener("input", () => go(Number(at("time").value)));
at("back").addEventListener("click", () => go(cycle - 1));
at("on").addEventListener("click", () => go(cycle + 1));
at("up").addEventListener("click", () => step(-1));
at("down").addEventListener("click", () => step(1));
at("covered").addEventListener("change", () => chart.classList.toggle("covered", at("covered").checked));
document.addEventListener("keydown", event => {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const keys = { ",": () => step(-1), ".": () => step(1), Home: () => go(0), End: () => go(last) };
  if (event.target !== at("time")) Object.assign(keys, { ArrowLeft: () => go(cycle - 1), ArrowRight: () => go(cycle + 1) });
  const does = keys[event.key];
  if (!does) return;
  event.preventDefault();
  does();
});

// `#12` or `#12.1`: this cycle, after so many evolutions.
function open() {
  const [first, evolutions] = location.hash.slice(1).split(".");
  go(Number(first) || 0, evolutions === undefined ? undefined : Number(evolutions) || 0);
}
addEventListener("hashchange", open);
open();
