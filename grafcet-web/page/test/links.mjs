// Charts in links: those that are shared, those that are damaged, those of the manual.

import assert from "node:assert/strict";

import { open } from "./browser.mjs";
import { MOTOR } from "./charts.mjs";

// Steps of `page.mjs`, with what it looks at a page with.
export const links = ({ browser, server, ready, settled, text, accessible }) => ({
  async "the chart in a link"(page) {
    await page.click("#share");
    const address = await page.inputValue("#address");
    assert.ok(address.startsWith(`${server.address}#chart=`) && address.length < 400, address);
    await page.click("#copy");
    await page.waitForFunction(() => document.querySelector("#copied").textContent === "Copied");
    assert.equal(await page.evaluate(() => navigator.clipboard.readText()), address);
    await accessible(page, "the dialog of a link");
    await page.keyboard.press("Escape");
    const other = await open(browser, address);
    await settled(other.page, MOTOR);
    await ready(other.page);
    assert.equal(await text(other.page, "#verdict"), "No complaints");
    assert.deepEqual(other.problems, []);
    // Once it is changed, the address does not say any more what it was.
    await other.page.evaluate(() => playground.editor.replace(playground.editor.text.replaceAll("Motor", "Engine")));
    await other.page.waitForFunction(() => playground.looked.text.includes("Engine"));
    await other.page.reload();
    await other.page.waitForFunction(() => globalThis.playground?.drawn?.name === "Engine");
    assert.equal(new URL(other.page.url()).hash, "");
    // A link that is only looked at leaves what was typed.
    await other.page.goto(address);
    await other.page.reload();
    await settled(other.page, MOTOR);
    await other.page.goto(server.address);
    await other.page.waitForFunction(() => globalThis.playground?.drawn?.name === "Engine");
    await other.context.close();
    // Damaged, cut off, longer than it was, with what is no text, unfolding without end, of another version: it is said, and there is a chart all the same.
    const [noText, endless] = await page.evaluate(() => Promise.all([new Uint8Array([0xff, 0xfe]), new Uint8Array(1 << 24)].map(async bytes => {
      const stream = new Blob([bytes]).stream().pipeThrough(new CompressionStream("deflate-raw"));
      const packed = new Uint8Array(await new Response(stream).arrayBuffer());
      return btoa(Array.from(packed, byte => String.fromCharCode(byte)).join("")).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
    })));
    const code = address.split("#chart=")[1], damaged = /^The chart of this link cannot be read: it is damaged or was cut off\. Copy the whole link once more$/;
    const wrong = [["", damaged], ["AAAA", damaged], ["!!", damaged], ["%F0%9F", damaged], [code.slice(0, 40), damaged], [code.slice(4), damaged], [`${code}AAAA`, damaged], [noText, damaged]];
    const { page: linked, context, problems } = await open(browser, `${server.address}#chart=AAAA`);
    await linked.waitForFunction(() => globalThis.playground?.drawn?.name === "Motor");
    for (const [fragment, why] of [...wrong.map(([code, why]) => [`chart=${code}`, why]), [`chart=${endless}`, /more than a megabyte/], [`chart2=${code}`, /another version of this page/]]) {
      await linked.evaluate(hash => { location.hash = hash; }, fragment);
      await linked.waitForSelector("#trouble:not([hidden])");
      assert.match(await text(linked, "#trouble"), why, fragment.slice(0, 50));
      assert.match(await linked.evaluate(() => playground.editor.text), /^(pub )?sfc Motor \{/m, fragment.slice(0, 50));
      // A whole one takes it away.
      await linked.evaluate(hash => { location.hash = hash; }, `chart=${code}`);
      await linked.waitForSelector("#trouble", { state: "hidden" });
    }
    // What is no chart at all is none of the page's.
    await linked.evaluate(() => { location.hash = "what-else"; });
    await linked.reload();
    await ready(linked);
    assert.ok(await linked.isHidden("#trouble"));
    assert.deepEqual(problems, []);
    await context.close();
  },

  async "the manual's charts open"(page) {
    const { page: book, context, problems } = await open(browser, `${server.address}manual.html`);
    await book.click("text=The language");
    await book.waitForURL("**/language.html");
    await book.locator(".pages [aria-current]", { hasText: "The language" }).waitFor();
    await book.click(".pages >> text=Operating modes");
    assert.equal(await book.evaluate(() => document.querySelector(":target").textContent), "Operating modes");
    for (const [file, name] of [["manual.html", "Press"], ["language.html", "Line24V"], ["cookbook.html", "TwoHand"], ["semantics.html", "Modal"]]) {
      await book.goto(server.address + file);
      const link = book.locator(".open a").filter({ hasText: new RegExp(`^Open ${name} in`) }).first();
      const chart = await link.locator("xpath=ancestor::div[@class='code']//code").innerText();
      await link.click();
      await ready(book);
      assert.equal(await text(book, "#chart-name"), name);
      assert.equal(await text(book, "#verdict"), "No complaints");
      const lines = await book.evaluate(() => playground.editor.text.trim().split("\n").map(line => line.trim()));
      for (const line of lines) assert.ok(chart.includes(line), `${file}: ${line}`);
      await book.goBack();
      await book.locator(".open a").first().waitFor();
    }
    // The colours of the playground are those of the manual.
    await book.click("#theme");
    assert.equal(await book.evaluate(() => document.documentElement.dataset.theme), "light");
    await book.click("header >> text=Playground");
    await ready(book);
    assert.equal(await book.evaluate(() => document.documentElement.dataset.theme), "light");
    await book.click("#manual");
    await book.waitForURL("**/manual.html");
    // It is there without a network, too.
    await book.evaluate(() => navigator.serviceWorker.ready);
    await context.setOffline(true);
    await book.goto(`${server.address}proof.html`);
    assert.equal(await text(book, "h1"), "What is proved");
    assert.deepEqual(problems, []);
    await context.close();
  },
});
