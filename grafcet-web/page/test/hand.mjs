// A cycle by hand, of a chart that lets itself be put anywhere.

import assert from "node:assert/strict";

import { MOTOR } from "./charts.mjs";

const PRESS = `sfc Press {
    forceable;
    input go, done: bool;
    output down, lamp: bool;
    initial step Up;
    step Down { N down; }
    step Light { N lamp; }
    Up -[go]-> (Down, Light);
    (Down, Light) -[done]-> Up;
}
`;

// Steps of `page.mjs`, with what it looks at a page with.
export const hand = ({ write, ready, input, active, marked, accessible }) => ({
  async "a cycle by hand"(page) {
    await write(page, MOTOR);
    await page.click("#restart");
    await ready(page);
    assert.ok(await page.isHidden("#by-hand"), "a chart that is not forceable");
    await write(page, PRESS);
    await page.click("#restart");
    await ready(page);
    await page.waitForFunction(() => playground.simulation.latest?.number === 0 && playground.simulation.text.includes("Press"));
    await page.click("#cycle");
    await page.click("#by-hand");
    // In the drawing a click chooses, and the text stays where it is.
    const step = name => page.evaluate(name => {
      const at = playground.simulation.names.steps.indexOf(name), { x, y, width, height } = document.querySelector(`#drawing [data-steps="${at}"]`).getBoundingClientRect();
      return { x: x + width / 2, y: y + height / 2 };
    }, name);
    const { x, y } = await step("Down");
    await page.mouse.click(x, y);
    assert.equal(await page.locator("#drawing .chosen").count(), 1);
    await page.locator("#situation label", { hasText: /^Light$/ }).click();
    assert.equal(await page.locator("#drawing .chosen").count(), 2);
    await accessible(page, "a situation to choose");
    await page.click("#situation .force");
    await page.waitForFunction(() => playground.simulation.latest.number === 2);
    assert.deepEqual([await active(page), (await marked(page)).sort()], [["Down", "Light"], ["Down", "Light"]]);
    assert.ok(await page.isHidden("#situation"));
    assert.equal(await page.evaluate(() => document.activeElement.id), "by-hand");
    // What the chart is never in is refused, with words, and nothing has happened.
    await page.keyboard.press("Enter");
    await page.locator("#situation label", { hasText: /^Up$/ }).click();
    await page.locator("#situation label", { hasText: /^Light$/ }).click();
    await page.click("#situation .force");
    await page.locator("#trouble", { hasText: "Up and Light are never active together" }).waitFor();
    assert.equal(await page.evaluate(() => playground.simulation.latest.number), 2);
    // It goes on from there, and is there on the way back.
    await input(page, "done").click();
    await page.click("#cycle");
    await page.waitForFunction(() => playground.simulation.latest.number === 3);
    assert.deepEqual(await active(page), ["Up"]);
    assert.ok(await page.isHidden("#trouble"));
    await page.focus("#waves");
    await page.keyboard.press("ArrowLeft");
    assert.deepEqual(await active(page), ["Down", "Light"]);
    // Left again nothing has been asked for.
    await page.click("#by-hand");
    await page.locator("#situation label", { hasText: /^Up$/ }).click();
    await page.click("#situation .leave");
    assert.equal(await page.locator("#drawing .chosen").count(), 0);
    assert.ok(await page.isHidden("#situation"));
    await write(page, MOTOR);
    await page.click("#restart");
    await ready(page);
  },
});
