/* svg.h - what the pictures have in common that are drawn as SVG: a white sheet, so that
 * dark pages show them as light ones do, a title, and round numbers on their axes. */
#ifndef BASE_SVG_H
#define BASE_SVG_H

#include <stdint.h>

#include "base/sink.h"

/* Pixels; the style is that of the picture's own classes, in CSS. */
struct svg_sheet {
    int width, height, left;
    const char *style;
};

/* The title begins at left. */
void svg_begin(const struct sink *sink, const struct svg_sheet *sheet,
               const char *title);
void svg_end(const struct sink *sink);
/* Text as it is to be read. */
void svg_put_escaped(const struct sink *sink, const char *text);

/* 1, 2 or 5 times a power of ten, of which no more than so many go into a span. */
uint64_t svg_round_step(uint64_t span, uint64_t most);

#endif
