// dom.js - elements of the page: found, made, filled; numbers as they are shown.

export const $ = (id) => document.getElementById(id);

const there = (children) => children.flat(Infinity).filter((child) => child != null && child !== false);

function furnish(node, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") node.addEventListener(name, value);
    else if (value === true) node.setAttribute(name, "");
    else if (value !== false && value != null) node.setAttribute(name, value);
  }
  node.append(...there(children));
  return node;
}

/** Children in place of those that a node has. */
export function fill(node, ...children) {
  node.replaceChildren(...there(children));
}

/** An element; an attribute that is a function listens, a child that is null is none. */
export function el(name, attributes = {}, ...children) {
  return furnish(document.createElement(name), attributes, children);
}

/** The same of a drawing. */
export function draw(name, attributes = {}, ...children) {
  return furnish(document.createElementNS("http://www.w3.org/2000/svg", name), attributes, children);
}

export function icon(name) {
  return draw("svg", { "aria-hidden": "true" }, draw("use", { href: `#icon-${name}` }));
}

/** What a panel has on top: its heading and what is said beside it. */
export function heading(panel, title, ...aside) {
  return el("div", { class: "heading" },
    el("h2", { id: `${panel}-heading` }, title), el("div", { class: "aside" }, ...aside));
}

/** A table: columns of [title, class], rows of cells (texts or elements). */
export function table(caption, columns, rows) {
  return el("table", {},
    el("caption", { class: "unseen" }, caption),
    el("thead", {}, el("tr", {},
      columns.map(([title, kind]) => el("th", { scope: "col", class: kind }, title)))),
    el("tbody", {}, rows.map(({ cells, ...attributes }) => el("tr", attributes,
      cells.map((cell, i) => i === 0
        ? el("th", { scope: "row", class: columns[0][1] }, cell)
        : el("td", { class: columns[i][1] }, cell))))));
}

/** Choices of a select: a list of {value, title}, or of {group, choices}.  What was chosen stays so
 * if it is still there. */
export function choices(select, list) {
  const before = select.value;
  const option = ({ value, title }) => el("option", { value }, title);
  fill(select, list.map((entry) => entry.choices
    ? el("optgroup", { label: entry.group }, entry.choices.map(option))
    : option(entry)));
  if ([...select.options].some(({ value }) => value === before)) select.value = before;
}

export const count = (n) => n.toLocaleString("en");
// Rounded as printf does: toLocaleString alone rounds the shortest decimal form of the number.
export const fixed = (x, places, signed = false) => Number.isFinite(x)
  ? Number(x.toFixed(places)).toLocaleString("en", { minimumFractionDigits: places,
    maximumFractionDigits: places, signDisplay: signed ? "always" : "negative" })
  : "-";
/** "1 clock", "2 clocks". */
export const some = (n, what) => `${count(n)} ${what}${n === 1 ? "" : "s"}`;
/** A time in the unit that suits it. */
export function duration(microseconds) {
  const [unit, by] = microseconds < 1000 ? ["µs", 1] : microseconds < 1e6 ? ["ms", 1e3] : ["s", 1e6];
  return `${fixed(microseconds / by, 2)} ${unit}`;
}

/** The class that has the colour of a cause: vector start-up, vector_startup .. */
export const colour = (cause) => `cause-${cause.toLowerCase().replace(/[^a-z]/g, "")}`;

const lost = new Map(); // names of values that could not be stored: why

function report() {
  const [why] = lost.values();
  $("unstored").hidden = !why;
  $("unstored").textContent = why ? `${why} Your text is lost when this page is closed: copy it, or use Share.` : "";
}

/** Values that are stored between visits.  The page reports it if one cannot be stored.  What is
 * read may be anything: other versions of the page, and other pages, write there. */
export const kept = {
  get(name) {
    try { return JSON.parse(localStorage.getItem(`c205.${name}`)); } catch { return null; }
  },
  /** A text; null: there is none. */
  text(name) {
    const value = kept.get(name);
    return typeof value === "string" ? value : null;
  },
  set(name, value) {
    try {
      localStorage.setItem(`c205.${name}`, JSON.stringify(value));
      lost.delete(name);
    } catch (fault) {
      lost.set(name, /quota/i.test(fault.name) ? "The storage of this browser is full."
        : "This browser stores no data for this page.");
    }
    report();
  },
};
