// theme.js - light and dark colours. The system determines them until the user selects a theme.

import { $, storage } from "./dom.js";

const systemDark = matchMedia("(prefers-color-scheme: dark)");
const root = document.documentElement;
const dark = () => root.dataset.theme ? root.dataset.theme === "dark" : systemDark.matches;

// Labels the switch with the other theme, which it selects.
function name() {
  $("theme").lastElementChild.textContent = dark() ? "Light" : "Dark";
}

export function switchTheme() {
  root.dataset.theme = dark() ? "light" : "dark";
  storage.set("theme", root.dataset.theme);
  name();
}

if (["light", "dark"].includes(storage.get("theme"))) root.dataset.theme = storage.get("theme");
systemDark.addEventListener("change", name);
name();
