// A page of the manual: its colours, its list of pages, and itself without a network.

import { theme } from "../../../cargo-grafcet/src/watch/page/theme.js";

theme(document.getElementById("theme"));

// Beside the text there is room for it; above the text it is opened by who wants it.
const pages = document.querySelector(".pages details"), beside = matchMedia("(min-width: 1000px)");
const lay = () => { pages.open = beside.matches; };
beside.addEventListener("change", lay);
lay();

if ("serviceWorker" in navigator) navigator.serviceWorker.register("offline.js").catch(() => { /* then with a network alone */ });
