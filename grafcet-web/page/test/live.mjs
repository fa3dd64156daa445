// The live view in a browser, of the emulated board that runs the cell: `node live.mjs TOOL CHART EXPECTED PICTURES EMULATOR WORD…`. The board's serial line
// comes through a socket; here it is held, damaged and cut.

import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { once } from "node:events";
import { mkdir, readFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { createServer } from "node:net";
import { join, resolve } from "node:path";
import { createInterface } from "node:readline";

import { open, start } from "./browser.mjs";

const [tool, chart, table, pictures, emulator, ...words] = process.argv.slice(2);
const axe = await readFile(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
// What the script of the cell does, worked out by hand: a line a cycle.
const expected = (await readFile(table, "utf8")).trim().split("\n").map(line => {
  const [before, , outputs] = line.split(" | ");
  const [, steps] = before.split(" ");
  return { steps: steps.split("+").sort(), outputs: outputs.split(" ").filter(one => one !== "-") };
});
await mkdir(pictures, { recursive: true });

// A port of this machine to which others connect, one after the other.
async function listen() {
  const waiting = [], came = [];
  const server = createServer(socket => {
    socket.on("error", () => { /* it was cut */ });
    const take = waiting.shift();
    if (take) take(socket); else came.push(socket);
  });
  server.listen(0, "127.0.0.1");
  await once(server, "listening");
  return { port: server.address().port, next: () => came.length > 0 ? came.shift() : new Promise(take => waiting.push(take)), close: () => server.close() };
}

const board = await listen(), lines = [await listen(), await listen()];
const watching = spawn(tool, ["grafcet", "watch", "--file", chart, ...lines.map(line => `tcp:127.0.0.1:${line.port}`)], { stdio: ["ignore", "pipe", "inherit"] });
const emulated = spawn(emulator, [...words, "-serial", `tcp:127.0.0.1:${board.port}`], { stdio: ["ignore", "ignore", "inherit"] });
const browser = await start();
try {
  const [address] = await once(createInterface(watching.stdout), "line");
  const [serial, first, second] = [await board.next(), await lines[0].next(), await lines[1].next()];
  const came = [];
  serial.on("data", bytes => came.push(bytes));
  await Promise.race([once(serial, "close"), new Promise((_, fail) => setTimeout(() => fail(new Error("the board does not end")), 60_000).unref())]);
  const bytes = Buffer.concat(came);
  assert.ok(bytes.length > 200, `${bytes.length} bytes came over the serial line`);
  await look(address, bytes, first, second);
  console.log(`live: ${bytes.length} bytes of the emulated board, and every moment of them on the page`);
} finally {
  await browser.close();
  watching.kill();
  emulated.kill();
  board.close();
  lines.forEach(line => line.close());
}
process.exit(0);

async function look(address, bytes, first, second) {
  const { page, problems } = await open(browser, address, { colorScheme: "light" });
  await page.waitForFunction(() => live.views.length === 2);
  const seen = at => page.evaluate(at => {
    const { names, history, line } = live.views[at].seen;
    if (!line) return { moments: [], line: {} };
    const names_of = moment => ({
      number: moment.number, gap: moment.gap?.reason ?? null, steps: moment.steps.map(step => names.steps[step]).sort(),
      outputs: names.outputs.filter((one, place) => one.kind.is === "bool" && moment.outputs[place] === true).map(one => one.name),
      unknown: moment.outputs.includes("?"),
    });
    return { moments: history.map(names_of), line };
  }, at);
  // The page's policy refuses functions from texts, so it is asked again and again.
  const until = async (at, holds) => {
    for (const end = Date.now() + 30_000; ;) {
      const now = await seen(at);
      if (holds(now)) return;
      if (Date.now() > end) throw new Error(`${holds}: ${JSON.stringify(now.line)}, ${now.moments.length} moments`);
      await new Promise(resolve => setTimeout(resolve, 50));
    }
  };
  const right = ({ moments }) => {
    for (const { number, steps, outputs, unknown } of moments) {
      const is = expected[number - 1];
      assert.deepEqual(steps, is.steps, `cycle ${number}`);
      if (!unknown) assert.deepEqual(outputs.sort(), is.outputs.filter(one => !one.includes("=")).sort(), `cycle ${number}`);
    }
  };
  const controller = at => page.locator(".controller").nth(at);
  const marked = at => controller(at).locator("[data-steps].on").count();
  const picture = name => page.screenshot({ path: join(resolve(pictures), `live-${name}.png`), fullPage: true });

  // Frames end with a zero; of the first run some come now, the end of the last one cut in two.
  const ends = [...bytes.keys()].filter(at => bytes[at] === 0);
  const half = ends[8] + 4;
  first.write(bytes.subarray(0, half));
  second.write(bytes.subarray(0, half));
  await until(0, ({ moments }) => moments.length > 3);
  right(await seen(0));
  assert.ok(await marked(0) > 0);
  assert.equal(await controller(0).locator("h2").innerText(), "Cell");
  assert.ok(await controller(0).locator(".steering").isHidden(), "nobody has allowed it");

  // One line goes on, of the other a byte is wrong.
  first.write(bytes.subarray(half));
  const wrong = Buffer.from(bytes.subarray(half));
  wrong[2] ^= 0x10;
  second.write(wrong.subarray(0, 40));
  await until(0, ({ moments }) => moments.at(-1)?.number === 16 && moments.some(one => one.gap));
  const all = await seen(0);
  right(all);
  assert.deepEqual(all.moments.filter(one => one.gap).map(one => [one.number, one.gap]), [[1, "the chart began anew here"]]);
  assert.deepEqual([all.line.damaged, all.line.lost, all.line.unknown], [0, 0, null]);
  assert.equal(all.moments.at(-1).steps.join(), "Stopped");
  assert.match(await controller(0).locator(".waits").innerText(), /Stopped.* waits for/);
  assert.equal(await controller(0).locator(".chronogram .gap").count(), 1);
  await until(1, ({ line }) => line.unknown);
  assert.match(await controller(1).locator(".unknown").innerText(), /a frame was damaged/);
  assert.equal(await marked(1), 0, "nothing is marked where nothing is known");
  right(await seen(1));
  await picture("light");

  await page.evaluate(axe);
  const before = problems.length;
  const { violations } = await page.evaluate(() => axe.run(document));
  problems.length = before;
  const serious = violations.filter(one => ["serious", "critical"].includes(one.impact));
  assert.deepEqual(serious.map(one => `${one.id}: ${one.nodes.map(node => node.target.join(" ")).join(", ")}`), []);

  // Back in time, and to the present.
  await controller(0).locator(".chronogram").focus();
  await page.keyboard.press("Home");
  await page.waitForFunction(() => live.views[0].seen.shown === 0);
  // It is drawn with the next frame.
  await controller(0).locator(".past").filter({ hasText: "The past" }).waitFor();
  const box = await controller(0).locator(".chronogram svg").boundingBox();
  await page.mouse.move(box.x + 130, box.y + 60);
  await page.mouse.down();
  await page.mouse.move(box.x + 118 + (box.width - 130) * 0.3, box.y + 60, { steps: 6 });
  await page.mouse.up();
  assert.ok(await page.evaluate(() => live.views[0].seen.shown) > 3);
  await controller(0).locator(".now").click();
  await page.waitForFunction(() => live.views[0].seen.isLive);

  await page.emulateMedia({ colorScheme: "dark" });
  await picture("dark");
  await page.setViewportSize({ width: 390, height: 844 });
  await page.waitForTimeout(200);
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth) <= 390, "nothing is wider than the screen");
  await picture("390");
  assert.deepEqual(problems, []);

  // The line is cut: nothing is marked as if it were now.
  first.destroy();
  await until(0, ({ line }) => line.unknown);
  await page.waitForFunction(() => !document.querySelector(".controller .unknown").hidden);
  assert.match(await controller(0).locator(".unknown").innerText(), /the source has ended/);
  assert.equal(await marked(0), 0);
  // It is connected again, in the middle of the second run: the next state brings it back.
  const again = await lines[0].next();
  again.write(bytes);
  await until(0, ({ moments, line }) => moments.at(-1)?.number === 16 && !line.unknown);
  right(await seen(0));
}
