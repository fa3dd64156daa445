// The page without a network: what was loaded last is shown where nothing can be loaded.

const KEPT = "grafcet-playground";
// The pages of the manual are told by who builds this.
const FILES = ["./", "index.html", "main.js", "worker.js", "style.css", "icon.svg", "grafcet_bg.wasm", "gallery.json", "LICENSES.txt", "manual.js", ...BOOK];

addEventListener("install", event => {
  event.waitUntil(caches.open(KEPT).then(kept => kept.addAll(FILES)).then(() => skipWaiting()));
});

addEventListener("activate", event => { event.waitUntil(clients.claim()); });

async function fresh(request) {
  const kept = await caches.open(KEPT);
  try {
    const response = await fetch(request);
    if (response.ok) await kept.put(request, response.clone());
    return response;
  } catch (error) {
    const last = await kept.match(request, { ignoreSearch: true });
    if (last) return last;
    throw error;
  }
}

addEventListener("fetch", event => {
  const { request } = event;
  if (request.method === "GET" && new URL(request.url).origin === location.origin) event.respondWith(fresh(request));
});
