// The page in a browser, used as a person uses it: `node page.mjs PAGE PICTURES`.

import assert from "node:assert/strict";
import { mkdir, readFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";

import { open, serve, start } from "./browser.mjs";
import { MOTOR, ring } from "./charts.mjs";
import { hand } from "./hand.mjs";
import { links } from "./links.mjs";
import { tabs } from "./tabs.mjs";

const [folder, pictures] = process.argv.slice(2).map(path => resolve(path));
const axe = await readFile(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
await mkdir(pictures, { recursive: true });
const server = await serve(folder), browser = await start();
// So many milliseconds from a key to the drawing, of a chart of 100 steps, say that something is wrong. The page means to take less than 100, which is
// printed and not asked here: a machine that does other things, too, takes several times as long.
const LONGEST = 1000;

const ready = page => page.waitForSelector("#run:not(:disabled)");
const settled = (page, text) => page.waitForFunction(text => globalThis.playground.looked?.text === text && playground.drawn?.text === text, text);
const text = (page, selector) => page.locator(selector).innerText();
const input = (page, name) => page.locator("#signals button.input", { hasText: new RegExp(`^${name}$`) });
const active = page => page.evaluate(() => playground.simulation.moment.steps.map(step => playground.simulation.names.steps[step]));

async function write(page, chart) {
  await page.locator("#editor .cm-content").click();
  await page.keyboard.press("Control+A");
  await page.evaluate(chart => navigator.clipboard.writeText(chart), chart);
  await page.keyboard.press("Control+V");
  await settled(page, chart);
}

// The steps that are marked in the drawing, by the text that stands in them.
const marked = page => page.evaluate(() => [...document.querySelectorAll("#drawing [data-steps].on")].map(mark => {
  const at = mark.getBoundingClientRect();
  const inside = [...document.querySelectorAll("#drawing text")].filter(text => {
    const { x, y, width, height } = text.getBoundingClientRect();
    return x >= at.x && x + width <= at.right && y >= at.y && y + height <= at.bottom;
  });
  return inside.map(text => text.textContent).join(" ");
}));

async function accessible(page, what) {
  const before = page.problems?.length;
  await page.evaluate(axe);
  const { violations } = await page.evaluate(() => axe.run(document));
  // Styles that axe would set, the page's policy refuses: no fault of the page.
  if (page.problems) page.problems.length = before;
  const serious = violations.filter(one => ["serious", "critical"].includes(one.impact));
  assert.deepEqual(serious.map(one => `${one.id}: ${one.nodes.map(node => node.target.join(" ")).join(", ")}`), [], what);
}

const steps = {
  async "a mistake is shown at its place, and mended"(page) {
    await write(page, MOTOR);
    assert.equal(await text(page, "#verdict"), "No complaints");
    assert.equal(await text(page, "#chart-name"), "Motor");
    // A letter too much, by keyboard: after `on` of the first condition.
    await page.evaluate(at => playground.editor.go(at, at), MOTOR.indexOf("[on ") + 3);
    await page.keyboard.type("n");
    await page.keyboard.press("Escape");
    await page.waitForFunction(() => playground.looked.text.includes("[onn &&") && !playground.looked.runs);
    assert.equal(await text(page, "#verdict"), "1 error");
    const marks = await page.evaluate(() => playground.editor.marks);
    assert.deepEqual(marks.map(({ text, severity }) => [text, severity]), [["onn", "error"]]);
    assert.match(await text(page, "#problems"), /onn/);
    const underlined = page.locator("#editor .cm-lintRange-error");
    assert.equal(await underlined.innerText(), "onn");
    await underlined.hover();
    await page.locator("#editor .cm-diagnostic").waitFor();
    assert.match(await page.locator("#editor .cm-diagnostic").innerText(), /onn/);
    // From the list of messages back to the place.
    await page.locator("#problems button").first().click();
    await page.keyboard.type("on");
    await settled(page, MOTOR);
    assert.equal(await text(page, "#verdict"), "No complaints");
    assert.equal(await page.locator("#editor .cm-lintRange").count(), 0);
    // Letters of more than one byte, and of two units, in front of it.
    const far = MOTOR.replace("    input", "    // größer als 𝄞\n    input").replace("[on ", "[/* é𝄞 */ onn ");
    await page.evaluate(chart => playground.editor.replace(chart), far);
    await page.waitForFunction(chart => playground.looked.text === chart, far);
    assert.deepEqual(await page.evaluate(() => playground.editor.marks.map(mark => mark.text)), ["onn"]);
    const own = "sfc Öffner {\n    input größe: bool;\n    output ärger: bool;\n    initial step Übergang { N ärger; }\n    step Zu;\n    Übergang -[größe]-> Zu -[!größe]-> Übergang;\n}\n";
    await page.evaluate(chart => playground.editor.replace(chart), own);
    await settled(page, own);
    assert.deepEqual([await text(page, "#verdict"), await text(page, "#chart-name")], ["No complaints", "Öffner"]);
    await write(page, MOTOR);
  },

  async "the motor goes through its cycle"(page) {
    await page.click("#restart");
    await ready(page);
    assert.deepEqual([await active(page), await marked(page)], [["Off"], ["Off"]]);
    await page.click("#cycle");
    await input(page, "on").click();
    await page.click("#cycle");
    await page.waitForFunction(() => playground.simulation.moment.number === 2);
    assert.deepEqual([await active(page), await marked(page)], [["On"], ["On"]]);
    assert.match(await text(page, "#signals"), /relay\s+on\s+green\s+on\s+red\s+off/);
    assert.equal(await text(page, "#waits"), "On → Off waits for off (false) or over_temp (false)");
    assert.equal(await page.textContent("#spoken"), "Cycle 2: in On; relay, green on");
    const bars = kind => page.locator(`#drawing [data-transition].${kind}`).evaluateAll(all => all.map(mark => mark.dataset.transition));
    assert.deepEqual([await bars("enabled"), await bars("cleared")], [["1"], ["0"]]);
    // What a transition waits for, where somebody points at it.
    await page.locator("#drawing [data-transition='1']").hover();
    assert.match(await text(page, "#hint"), /waits for off \(false\) or over_temp \(false\)/);
    await page.locator("#drawing [data-transition='0']").hover();
    assert.match(await text(page, "#hint"), /is not asked/);
    await input(page, "on").click();
    await input(page, "over_temp").click();
    await page.click("#skip");
    await page.waitForFunction(() => playground.simulation.moment.number === 3);
    assert.deepEqual([await active(page), await marked(page)], [["Off"], ["Off"]]);
    assert.equal(await text(page, "#waits"), "Off → On waits for on (false); !over_temp (over_temp = true)");
  },

  async "back in time, and on from there"(page) {
    const shown = () => page.evaluate(() => playground.simulation.moment.number);
    const box = await page.locator("#waves svg").boundingBox();
    await page.mouse.move(box.x + box.width - 20, box.y + 60);
    await page.mouse.down();
    await page.mouse.move(box.x + 119, box.y + 60, { steps: 8 });
    await page.mouse.up();
    assert.equal(await shown(), 0);
    assert.deepEqual([await active(page), await marked(page)], [["Off"], ["Off"]]);
    await page.focus("#waves");
    await page.keyboard.press("ArrowRight");
    await page.keyboard.press("ArrowRight");
    assert.equal(await shown(), 2);
    assert.deepEqual(await marked(page), ["On"]);
    assert.match(await page.locator("#waves").getAttribute("aria-valuetext"), /cycle 2, in On$/);
    await page.click("#cycle");
    await page.waitForFunction(() => playground.simulation.isLive && playground.simulation.moment.number === 3);
    assert.deepEqual(await active(page), ["On"], "the over-temperature has not come any more");
    assert.equal(await page.evaluate(() => playground.simulation.history.length), 4);
  },

  async "it runs by itself"(page) {
    await page.click("#restart");
    await ready(page);
    await page.waitForFunction(() => playground.simulation.latest?.number === 0);
    await page.selectOption("#speed", "10");
    await input(page, "on").click();
    await page.waitForFunction(() => playground.simulation.moment.elapsed > 2000);
    assert.equal(await page.getAttribute("#run", "aria-pressed"), "true");
    assert.deepEqual(await active(page), ["On"]);
    assert.deepEqual(await page.evaluate(() => playground.simulation.history.slice(0, 3).map(moment => moment.values[0])), [false, false, true]);
    const kept = await page.evaluate(() => playground.simulation.history.map(moment => moment.number));
    assert.ok(kept.length <= 5, `of ${kept.at(-1)} cycles those are kept in which something changed: ${kept}`);
    // Held as a push button is.
    await input(page, "off").click({ delay: 700 });
    await page.waitForFunction(() => playground.simulation.latest.values.join() === "true,false,false");
    assert.ok(await page.evaluate(() => playground.simulation.history.some(moment => moment.values.join() === "true,true,false")));
    // Looked at in the middle of its run, while much is asked and not done yet: nothing of it is forgotten.
    const [before, after] = await page.evaluate(async () => {
      const { simulation } = playground, { number } = simulation.latest;
      for (let turn = 0; turn < 60; turn++) void simulation.set(1, false);
      await simulation.look(1);
      return [number, simulation.latest.number];
    });
    assert.ok(after >= before, `${after} of ${before} cycles`);
    await page.click("#live");
    await page.click("#run");
    await page.click("#run");
    // After what was asked before it was stopped.
    await page.evaluate(() => playground.simulation.cycle(0));
    const stopped = await page.evaluate(() => playground.simulation.latest.number);
    await page.waitForTimeout(150);
    assert.equal(await page.evaluate(() => playground.simulation.latest.number), stopped);
    await page.selectOption("#speed", "1");
  },

  async "a click after Restart is not lost"(page) {
    // A chart that has not run yet is begun anew a moment after it was changed; who restarts it meanwhile has one that stays.
    const again = `${MOTOR}// again\n`;
    await page.click("#restart");
    await ready(page);
    const stays = await page.evaluate(async text => {
      const { editor, simulation: before } = playground;
      if (before.latest.number !== 0) return "it has run";
      editor.replace(text);
      while (playground.looked.text !== text) await new Promise(resolve => setTimeout(resolve, 5));
      document.querySelector("#restart").click();
      const restarted = playground.simulation;
      if (restarted === before) return "it was not restarted";
      await new Promise(resolve => setTimeout(resolve, 600));
      return playground.simulation === restarted && restarted.text === text;
    }, again);
    assert.equal(stays, true);
    // Nor is what is clicked before the new one has begun.
    await page.evaluate(() => {
      document.querySelector("#restart").click();
      if (playground.simulation.moment) throw new Error("it has begun already");
      [...document.querySelectorAll("#signals button.input")].find(button => button.textContent === "on").click();
    });
    await page.waitForFunction(() => playground.simulation.latest?.number > 1);
    assert.deepEqual([await active(page), await page.evaluate(() => playground.simulation.values)], [["On"], [true, false, false]]);
    await write(page, MOTOR);
    await page.click("#restart");
    await ready(page);
  },

  ...links({ browser, server, ready, settled, text, accessible }),

  async "without a network"(page) {
    const { page: other, context, problems } = await open(browser, server.address);
    await ready(other);
    await other.evaluate(() => navigator.serviceWorker.ready);
    await other.reload();
    await ready(other);
    assert.deepEqual(problems, []);
    await context.setOffline(true);
    await other.reload();
    await ready(other);
    assert.equal(await text(other, "#verdict"), "No complaints");
    await other.click("#open-gallery");
    await other.locator("#shelves button").first().waitFor();
    await context.close();
  },

  async "what was not loaded is loaded with the next change"() {
    const context = await browser.newContext(), other = await context.newPage();
    await other.route("**/grafcet_bg.wasm", route => route.abort());
    await other.goto(server.address);
    await other.waitForFunction(() => document.querySelector("#verdict").textContent === "The compiler has failed");
    assert.match(await text(other, "#problems"), /fetch/i);
    await other.unroute("**/grafcet_bg.wasm");
    await other.evaluate(() => playground.editor.replace(`${playground.editor.text}\n`));
    await ready(other);
    assert.equal(await text(other, "#verdict"), "No complaints");
    assert.equal(await other.locator("#problems li").count(), 0);
    await context.close();
  },

  ...tabs({ write, text, accessible }),
  ...hand({ write, ready, input, active, marked, accessible }),

  async "the gallery, and a rule"(page) {
    await page.click("#open-gallery");
    await page.fill("#find", "two-hand");
    await accessible(page, "the gallery");
    await page.locator("#shelves button:visible").first().click();
    await page.waitForFunction(() => playground.drawn.name === "TwoHand" && playground.looked.runs && playground.looked.text === playground.drawn.text);
    const dead = MOTOR.replace("Off;\n}", "Off;\n    On -[off && over_temp]-> Off;\n}");
    await write(page, dead);
    const link = page.locator("#problems a").first();
    const [rule] = await Promise.all([page.waitForEvent("popup"), link.click()]);
    await rule.waitForLoadState();
    const found = await rule.evaluate(() => document.querySelector(":target")?.textContent);
    assert.equal(`grafcet::${found}`, await link.innerText());
    await accessible(rule, "the rules");
    await rule.close();
  },

  async "with the keyboard alone"(page) {
    await write(page, MOTOR);
    // A name is completed.
    await page.evaluate(at => playground.editor.go(at, at), MOTOR.indexOf("[on ") + 1);
    await page.keyboard.type("ov");
    await page.locator("#editor .cm-tooltip-autocomplete li", { hasText: "over_temp" }).waitFor();
    await page.waitForTimeout(120);
    await page.keyboard.press("Enter");
    await page.waitForFunction(() => playground.editor.text.includes("[over_tempon"));
    await page.keyboard.press("Control+Z");
    await page.keyboard.press("Control+Z");
    await write(page, MOTOR);
    // Escape, then Tab, leads out of the editor; a list of names that is open takes the first one.
    await page.keyboard.press("Escape");
    await page.keyboard.press("Escape");
    await page.keyboard.press("Tab");
    assert.equal(await page.evaluate(() => document.activeElement.id), "tab-drawing");
    await page.keyboard.press("Tab");
    assert.equal(await page.evaluate(() => document.activeElement.id), "panel");
    await page.keyboard.press("Tab");
    assert.equal(await page.evaluate(() => document.activeElement.id), "run");
  },

  async "what takes long is given up for what was typed since"(page) {
    const newer = MOTOR.replace("Motor", "Newer");
    await page.evaluate(chart => playground.editor.replace(chart), ring(6000));
    await page.waitForTimeout(100);
    const begin = Date.now();
    await page.evaluate(chart => playground.editor.replace(chart), newer);
    await settled(page, newer);
    console.log(`    ${Date.now() - begin} ms after a chart of 6,000 steps`);
    // To the end of that chart it takes several times as long.
    assert.ok(Date.now() - begin < 6000);
    await ready(page);
  },

  async "drawn while one types"(page) {
    const chart = ring(100);
    await write(page, chart);
    await page.waitForTimeout(500);
    const times = [];
    for (let turn = 0; turn < 9; turn++) {
      times.push(await page.evaluate(async name => {
        const drawn = new Promise(resolve => new MutationObserver((_, observer) => {
          observer.disconnect();
          resolve(performance.now());
        }).observe(document.querySelector("#drawing"), { childList: true }));
        const begin = performance.now();
        playground.editor.replace(playground.editor.text.replace(/S99\w*/g, name));
        return await drawn - begin;
      }, `S99${"x".repeat(turn + 1)}`));
    }
    times.sort((a, b) => a - b);
    const [least, middle, most] = [times[0], times[4], times[8]].map(Math.round);
    console.log(`    100 steps, from a change to the drawing: ${middle} ms (${least} to ${most})`);
    assert.ok(middle < LONGEST, `${middle} ms`);
  },
};

const views = [
  ["light", { colorScheme: "light" }],
  ["dark", { colorScheme: "dark" }],
  ["phone", { colorScheme: "light", viewport: { width: 390, height: 844 }, hasTouch: true }],
  ["phone-dark", { colorScheme: "dark", viewport: { width: 390, height: 844 }, hasTouch: true }],
];

// How it looks, with a chart that has run and a message.
async function looks(name, options) {
  const { page, context, problems } = await open(browser, server.address, options);
  await ready(page);
  await page.selectOption("#speed", "10");
  for (const [signal, wait] of [["on", 250], ["on", 100], ["off", 120], ["off", 250], ["on", 300]]) {
    await input(page, signal).click();
    await page.waitForTimeout(wait);
  }
  await page.click("#run");
  const wide = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
  assert.equal(wide, 0, "the page is as wide as its window");
  assert.ok(await page.isVisible("#manual"));
  await accessible(page, name);
  await page.screenshot({ path: join(pictures, `${name}.png`), fullPage: true });
  await page.evaluate(() => playground.editor.replace(playground.editor.text.replace("[on &&", "[onn &&").replace("N green;", "N green; N gren;")));
  await page.waitForFunction(() => playground.looked.messages.length > 1);
  await page.waitForTimeout(100);
  await accessible(page, `${name}, with messages`);
  await page.screenshot({ path: join(pictures, `${name}-messages.png`) });
  assert.deepEqual(problems, []);
  await context.close();
}

// A page with tables, a picture and a chart, and a long one. That they are accessible depends on what they show and on their colours: each is asked for once.
async function reads(name, options, asked) {
  for (const file of ["manual.html", "language.html"]) {
    const { page, context, problems } = await open(browser, server.address + file, options);
    await page.waitForSelector("html[data-theme]");
    const wide = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
    assert.equal(wide, 0, `${file} is as wide as its window`);
    if (asked === file) await accessible(page, `${file}, ${name}`);
    await page.screenshot({ path: join(pictures, `${file.replace(".html", "")}-${name}.png`), clip: { x: 0, y: 0, width: page.viewportSize().width, height: 2400 }, fullPage: true });
    assert.deepEqual(problems, []);
    await context.close();
  }
}

const failed = [];
async function step(name, work) {
  const begin = Date.now();
  try {
    await work();
    console.log(`ok      ${name} (${Date.now() - begin} ms)`);
  } catch (error) {
    failed.push(name);
    console.log(`FAILED  ${name}\n${error.stack ?? error}`);
  }
}

const { page, problems } = await open(browser, server.address);
page.setDefaultTimeout(15_000);
await ready(page);
for (const [name, work] of Object.entries(steps)) await step(name, () => work(page));
await step("nothing went wrong in the console, and nobody else was asked", () => assert.deepEqual(problems, []));
for (const [name, options] of views) await step(`how it looks: ${name}`, () => looks(name, options));
const asked = { light: "language.html", dark: "manual.html", phone: "manual.html" };
for (const [name, options] of views) await step(`how the manual looks: ${name}`, () => reads(name, options, asked[name]));
await browser.close();
server.close();
if (failed.length > 0) {
  console.error(`${failed.length} failed: ${failed.join("; ")}`);
  process.exitCode = 1;
}
