// The chart in other notations, a tab each: what they show, and that a long text holds nobody.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";

import { MOTOR, ring } from "./charts.mjs";

// Steps of `page.mjs`, with what it looks at a page with.
export const tabs = ({ write, text, accessible }) => ({
  async "other notations"(page) {
    const shows = async (tab, wanted) => {
      await page.click(`#tab-${tab}`);
      await page.locator("#translation pre", { hasText: wanted }).waitFor();
    };
    await shows("rust", "fn is_active");
    await shows("case", "CASE StepNo OF");
    await shows("flip-flops", "FUNCTION_BLOCK Motor");
    await shows("sfc", "INITIAL_STEP OffStep:");
    await shows("plcopen", "http://www.plcopen.org/xml/tc6_0201");
    await shows("pnml", "<pnml");
    await shows("aiger", "aag ");
    await shows("btor2", "1 sort bitvec 1");
    await accessible(page, "a notation");
    // To the clipboard and to a file, the same text.
    const shown = await text(page, "#translation pre");
    await page.click("#translation .copy button:has-text('Copy')");
    await page.locator("#translation .copy button", { hasText: "Copied" }).waitFor();
    assert.equal((await page.evaluate(() => navigator.clipboard.readText())).trim(), shown.trim());
    // Where there is no clipboard it is said.
    await page.evaluate(() => Object.defineProperty(navigator, "clipboard", { value: undefined, configurable: true }));
    await page.click("#translation .copy button:has-text('Copied')");
    await page.locator("#translation .copy button", { hasText: "No clipboard: download it" }).waitFor();
    await page.evaluate(() => { delete navigator.clipboard; });
    const [download] = await Promise.all([page.waitForEvent("download"), page.locator("#translation .copy button", { hasText: /^Download$/ }).click()]);
    assert.equal(download.suggestedFilename(), "Motor.btor2");
    assert.equal((await readFile(await download.path(), "utf8")).trim(), shown.trim());
    // What has errors has no translation; mended it has one again.
    await write(page, MOTOR.replace("[on ", "[onn "));
    await page.locator("#translation .note", { hasText: "the chart has an error: mend that first" }).waitFor();
    await write(page, MOTOR);
    await page.locator("#translation pre", { hasText: "1 sort bitvec 1" }).waitFor();
    await page.focus("#tab-btor2");
    await page.keyboard.press("ArrowRight");
    assert.equal(await page.evaluate(() => document.activeElement.id), "tab-drawing");
    assert.ok(await page.isVisible("#drawing"));
  },

  async "a text that is too large or takes too long holds nobody"(page) {
    // Each step multiplies, so that the circuit has millions of gates.
    const wide = steps => `sfc Wide {\n    input go: bool;\n${Array.from({ length: steps }, (_, at) => `    output n${at}: u64; ${at === 0 ? "initial " : ""}step S${at} { P1 { n${at} = n${at} * n${at} + 1; } } S${at} -[go]-> S${(at + 1) % steps};\n`).join("")}}\n`;
    await page.click("#tab-aiger");
    await write(page, wide(60));
    await page.locator("#translation .note", { hasText: /too large for this page; cargo grafcet export writes larger ones|longer than 10 seconds/ }).waitFor();
    // Of a long text the beginning is shown.
    await write(page, ring(1000));
    await page.click("#tab-plcopen");
    await page.locator("#translation .note", { hasText: "The first 300,000 of 2," }).waitFor();
    assert.equal((await page.textContent("#translation pre")).length, 300_000);
    // What is typed meanwhile is looked at at once.
    await page.click("#tab-rust");
    const begin = Date.now();
    await write(page, MOTOR);
    console.log(`    ${Date.now() - begin} ms to what is typed while 1,000 steps are translated`);
    assert.ok(Date.now() - begin < 5000);
    await page.locator("#translation pre", { hasText: "fn is_active" }).waitFor();
    await page.click("#tab-drawing");
  },
});
