// Light, dark, or as the system has it.

const NAMES = { "": "as the system", light: "light", dark: "dark" };
const SIGNS = { "": "◐", light: "☀", dark: "☾" };

// What a private window does not let us keep is not kept.
export function kept(key) {
  try { return localStorage.getItem(key); } catch { return null; }
}

export function keep(key, value) {
  try { localStorage.setItem(key, value); } catch { /* then not */ }
}

export function theme(button) {
  let now = kept("grafcet.theme") ?? "";
  if (!(now in NAMES)) now = "";
  const show = () => {
    document.documentElement.dataset.theme = now;
    button.textContent = SIGNS[now];
    button.setAttribute("aria-label", `Colours: ${NAMES[now]}`);
    button.title = button.getAttribute("aria-label");
  };
  button.addEventListener("click", () => {
    const order = Object.keys(NAMES);
    now = order[(order.indexOf(now) + 1) % order.length];
    keep("grafcet.theme", now);
    show();
  });
  show();
}
