// theme.js - light and dark colours: those of the system until the user selects others.

import { $, kept } from "./dom.js";

const liked = matchMedia("(prefers-color-scheme: dark)");
const root = document.documentElement;
const dark = () => root.dataset.theme ? root.dataset.theme === "dark" : liked.matches;

// Labels the switch with the theme that it selects.
function name() {
  $("theme").lastElementChild.textContent = dark() ? "Light" : "Dark";
}

export function switchTheme() {
  root.dataset.theme = dark() ? "light" : "dark";
  kept.set("theme", root.dataset.theme);
  name();
}

if (["light", "dark"].includes(kept.get("theme"))) root.dataset.theme = kept.get("theme");
liked.addEventListener("change", name);
name();
