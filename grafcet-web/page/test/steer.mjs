// The live view steers a tank on the emulated board, in a browser: `node steer.mjs TOOL CHART PICTURES EMULATOR WORD…`. What goes over the board's serial line, in both
// directions, comes by here: it is counted, kept back, said twice and disturbed.

import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { once } from "node:events";
import { mkdir, readFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { createServer } from "node:net";
import { join, resolve } from "node:path";
import { createInterface } from "node:readline";

import { open, start } from "./browser.mjs";

const [tool, chart, pictures, emulator, ...words] = process.argv.slice(2);
const axe = await readFile(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
await mkdir(pictures, { recursive: true });

// A port of this machine, for one connection.
async function listen() {
  const server = createServer();
  server.listen(0, "127.0.0.1");
  await once(server, "listening");
  return { port: server.address().port, came: once(server, "connection").then(([socket]) => socket), close: () => server.close() };
}

const board = await listen(), line = await listen();
const watching = spawn(tool, ["grafcet", "watch", "--steer", "--file", chart, `tcp:127.0.0.1:${line.port}`], { stdio: ["ignore", "pipe", "inherit"] });
const emulated = spawn(emulator, [...words, "-serial", `tcp:127.0.0.1:${board.port}`], { stdio: ["ignore", "ignore", "inherit"] });
const browser = await start();
try {
  const [address] = await once(createInterface(watching.stdout), "line");
  const [serial, host] = await Promise.race([Promise.all([board.came, line.came]), new Promise((_, fail) => setTimeout(() => fail(new Error("nobody connects")), 60_000).unref())]);
  serial.on("data", bytes => host.write(bytes));
  // What the tool has said, and what of it is kept back.
  const way = { said: [], held: null };
  host.on("data", bytes => {
    way.said.push(bytes);
    if (way.held) way.held.push(bytes); else serial.write(bytes);
  });
  const count = await steer(address, way, bytes => serial.write(bytes));
  console.log(`steer: ${count} commands to the emulated board, carried out or refused as they should be`);
} finally {
  await browser.close();
  watching.kill();
  emulated.kill();
  board.close();
  line.close();
}
process.exit(0);

async function steer(address, way, toBoard) {
  const { page, problems } = await open(browser, address, { colorScheme: "light" });
  const steering = page.locator(".steering"), dialog = page.locator("#confirm");
  const picture = name => page.screenshot({ path: join(resolve(pictures), `steer-${name}.png`), fullPage: true });
  const now = () => page.evaluate(() => {
    const { names, latest, line } = live.views[0]?.seen ?? {};
    if (!latest || line.unknown) return null;
    const is = name => latest.values[names.signals.findIndex(one => one.name === name)];
    return {
      steps: latest.steps.map(step => names.steps[step]).join(), mode: ["paused", "manual", "semi_automatic"].find(is) ?? "automatic",
      outputs: names.outputs.filter((_, place) => latest.outputs[place] === true).map(one => one.name).join(), number: latest.number,
    };
  });
  const until = async (what, holds) => {
    for (const end = Date.now() + 30_000; ;) {
      const is = await now(), said = await steering.locator(".steered p").allInnerTexts();
      if (is && holds(is, said)) return is;
      if (Date.now() > end) throw new Error(`${what}: ${JSON.stringify({ is, said })}`);
      await new Promise(done => setTimeout(done, 30));
    }
  };
  // The last command is said first.
  const said = text => until(text, (_, [first]) => first === text);
  const sent = () => way.said.length;
  const press = name => steering.getByRole("button", { name, exact: true }).click();
  const stays = async steps => {
    const { number } = await until("a moment", () => true);
    await until(`still in ${steps}`, is => {
      assert.equal(is.steps, steps);
      return is.number > number + 60;
    });
  };

  // Nobody has to ask: it fills, heats and drains by itself.
  await until("it runs", is => is.steps === "Fill" && is.mode === "automatic" && is.outputs === "inlet");
  assert.equal(await steering.locator("[data-mode=automatic]").getAttribute("aria-pressed"), "true");

  // By hand in the automatic mode the program forces nothing.
  const choose = async steps => {
    await press("Force…");
    for (const step of steps) {
      const place = await page.evaluate(name => live.views[0].seen.names.steps.indexOf(name), step);
      await page.locator(`.drawing rect[data-steps="${place}"]`).first().click();
    }
    assert.deepEqual(await steering.locator(".steps label:has(:checked)").allInnerTexts(), steps);
    assert.equal(await page.locator(".drawing .chosen").count(), steps.length);
    await press("Force this situation…");
  };
  await choose(["Heat"]);
  assert.match(await dialog.innerText(), /Tank goes into the situation of exactly Heat, whatever its conditions say/);
  assert.equal(sent(), 0, "nothing is sent before somebody has confirmed it");
  await picture("dialog");
  await dialog.getByRole("button", { name: "Cancel" }).click();
  await press("Force this situation…");
  await dialog.getByRole("button", { name: "Force", exact: true }).click();
  await said("force Heat: refused: the program on the controller does not take it now");
  assert.equal(sent(), 1);

  // Paused, nothing clears; and then it may be forced.
  await press("Paused");
  await said("paused: accepted");
  const { steps } = await until("it is paused", is => is.mode === "paused");
  await stays(steps);
  assert.equal(await steering.locator("[data-mode=paused]").getAttribute("aria-pressed"), "true");
  // From whatever it was paused in, one of the two changes the situation; and the page says that it was not the chart itself.
  for (const [step, output] of [["Drain", "outlet"], ["Heat", "heater"]]) {
    await choose([step]);
    await dialog.getByRole("button", { name: "Force", exact: true }).click();
    await said(`force ${step}: accepted`);
    await until("it is forced", is => is.steps === step && is.outputs === output);
  }
  assert.ok(await page.evaluate(() => live.views[0].seen.history.some(one => one.gap?.reason.startsWith("the chart was changed from outside"))));
  await choose(["Fill", "Drain"]);
  await dialog.getByRole("button", { name: "Force", exact: true }).click();
  await said("force Fill, Drain: refused: Fill and Drain are never active together");
  await stays("Heat");
  await picture("light");

  await page.evaluate(axe);
  const before = problems.length;
  const { violations } = await page.evaluate(() => axe.run(document));
  problems.length = before;
  const serious = violations.filter(one => ["serious", "critical"].includes(one.impact));
  assert.deepEqual(serious.map(one => `${one.id}: ${one.nodes.map(node => node.target.join(" ")).join(", ")}`), []);

  // By hand the push button clears, and nothing else does.
  await press("Manual");
  await said("manual: accepted");
  await stays("Heat");
  await press("Push");
  await said("push: accepted");
  await until("it was pushed", is => is.steps === "Drain");
  const push = way.said.at(-1);
  await stays("Drain");
  const count = sent();
  await press("Init…");
  await page.keyboard.press("Escape");
  await stays("Drain");
  assert.equal(sent(), count, "who does not confirm sends nothing");
  await press("Init…");
  await dialog.getByRole("button", { name: "Init", exact: true }).click();
  await said("init: accepted");
  await until("it begins anew", is => is.steps === "Ready");
  const times = await page.evaluate(() => live.views[0].seen.history.map(one => one.elapsed));
  assert.ok(times.every((time, at) => at === 0 || time - times[at - 1] < 10_000), "the time goes on");

  // The line says the push button again, and half of it, with a wrong bit, and noise: nothing happens.
  const wrong = Buffer.from(push);
  wrong[5] ^= 4;
  for (const bytes of [push, push.subarray(0, 12), wrong, Buffer.from(Array.from({ length: 300 }, (_, index) => index * 91 % 256)), Buffer.from([0])]) toBoard(bytes);
  await stays("Ready");
  await press("Push");
  await said("push: accepted");
  await until("it takes commands as before", is => is.steps === "Fill");

  // A command that was kept back: nobody answers, and when it comes it is too late.
  way.held = [];
  await press("Push");
  await said("push: no answer. The program on the controller may not take commands");
  for (const bytes of way.held.splice(0)) toBoard(bytes);
  way.held = null;
  await said("push: refused: it has come too late");
  await stays("Fill");

  await press("Semi-automatic");
  await said("semi-automatic: accepted");
  await press("Automatic");
  await said("automatic: accepted");
  await until("it heats", is => is.steps === "Heat");
  await until("it drains", is => is.steps === "Drain");

  // With keys alone, in the dark, on a small screen.
  await page.emulateMedia({ colorScheme: "dark" });
  await page.setViewportSize({ width: 390, height: 844 });
  await steering.getByRole("button", { name: "Force…" }).focus();
  await page.keyboard.press("Enter");
  await steering.locator(".steps input").nth(1).focus();
  await page.keyboard.press("Space");
  assert.deepEqual(await steering.locator(".steps label:has(:checked)").allInnerTexts(), ["Fill"]);
  await page.waitForTimeout(200);
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth) <= 390, "nothing is wider than the screen");
  await picture("390");
  assert.deepEqual(problems, []);
  return sent();
}
