/* deck.js - the keys of a deck: to the next or previous slide, and n for the speaker's
 * notes. The fragment #notes shows the notes from the start. */
const slides = [...document.querySelectorAll("section")];

function current() {
    const middle = innerHeight / 2;
    return slides.findIndex(slide =>
        slide.getBoundingClientRect().bottom > middle);
}

const moves = {
    ArrowRight: 1, ArrowDown: 1, PageDown: 1, " ": 1,
    ArrowLeft: -1, ArrowUp: -1, PageUp: -1,
    Home: -slides.length, End: slides.length,
};

addEventListener("keydown", event => {
    if (event.key === "n")
        document.body.classList.toggle("notes");
    const move = moves[event.key];
    if (!move || event.ctrlKey || event.altKey || event.metaKey)
        return;
    event.preventDefault();
    const to = Math.max(0, Math.min(slides.length - 1, current() + move));
    slides[to].scrollIntoView();
});

/* Reduces the font size of blocks with long lines until the lines fit. */
for (const block of document.querySelectorAll("pre"))
    if (block.scrollWidth > block.clientWidth)
        block.style.fontSize =
            `calc(80% * ${block.clientWidth} / ${block.scrollWidth + 4})`;
document.body.classList.toggle("notes", location.hash === "#notes");
/* Marks slides that do not fit, for the test. */
for (const slide of slides)
    slide.toggleAttribute("data-too-long",
        [slide, ...slide.querySelectorAll("pre")].some(part =>
            part.scrollHeight > part.clientHeight + 1 ||
            part.scrollWidth > part.clientWidth + 1));
