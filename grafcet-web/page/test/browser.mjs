// A server of one folder on this machine, and a headless Chromium that looks at it.

import { execFileSync } from "node:child_process";
import { createServer } from "node:http";
import { readFile } from "node:fs/promises";
import { extname, join, normalize } from "node:path";

import { chromium } from "playwright-core";

const TYPES = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".wasm": "application/wasm", ".json": "application/json", ".svg": "image/svg+xml", ".txt": "text/plain" };

export async function serve(folder) {
  const server = createServer(async (request, response) => {
    const path = normalize(new URL(request.url, "http://localhost").pathname);
    const file = join(folder, path.endsWith("/") ? `${path}index.html` : path);
    try {
      const body = await readFile(file);
      response.writeHead(200, { "content-type": TYPES[extname(file)] ?? "application/octet-stream" }).end(body);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise(resolve => server.listen(0, "127.0.0.1", resolve));
  return { address: `http://127.0.0.1:${server.address().port}/`, close: () => server.close() };
}

export function start() {
  const executablePath = ["chromium", "chromium-browser", "google-chrome"].map(name => {
    try { return execFileSync("which", [name], { encoding: "utf8", stdio: ["ignore", "pipe", "ignore"] }).trim(); } catch { return null; }
  }).find(Boolean);
  if (!executablePath) throw new Error("no Chromium in the PATH; on Debian `apt-get install chromium`");
  // Its sandbox does not work for root; the page is our own. It asks nobody for updates.
  const args = ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync"];
  return chromium.launch({ executablePath, headless: true, args });
}

// A page whose console and requests are watched: what goes wrong is in `problems`.
export async function open(browser, address, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1360, height: 900 }, permissions: ["clipboard-read", "clipboard-write"], ...options });
  const page = await context.newPage();
  const problems = [];
  page.on("console", message => { if (message.type() === "error" || message.type() === "warning") problems.push(`${message.text()} ${JSON.stringify(message.location())}`); });
  page.on("pageerror", error => problems.push(String(error)));
  page.on("request", request => { if (!request.url().startsWith(new URL(address).origin)) problems.push(`asks ${request.url()}`); });
  page.on("requestfailed", request => {
    const why = request.failure()?.errorText;
    // A page that is left no longer waits for its sign, which comes last; a worker that is ended while it is loaded is not waited for either.
    const isLeft = ["/icon.svg", "/worker.js"].some(file => request.url().endsWith(file));
    if (why !== "net::ERR_ABORTED" || !isLeft) problems.push(`${request.url()}: ${why}`);
  });
  page.problems = problems;
  await page.goto(address);
  return { page, context, problems };
}
