/* svg.h - the common parts of SVG pictures: a white background, so that dark pages show
 * them like light ones, a title, and round numbers for the axes.
 */
#ifndef BASE_SVG_H
#define BASE_SVG_H

#include <stdint.h>

#include "base/sink.h"

/* Sizes in pixels; style is CSS for the picture's own classes. */
struct svg_sheet {
    int width, height, left;
    const char *style;
};

/* The title begins at left. */
void svg_begin(const struct sink *sink, const struct svg_sheet *sheet,
               const char *title);
void svg_end(const struct sink *sink);
/* Writes text with the characters of markup escaped. */
void svg_put_escaped(const struct sink *sink, const char *text);

/* Returns the least step that is 1, 2 or 5 times a power of ten and divides a span into
 * no more than most parts. */
uint64_t svg_round_step(uint64_t span, uint64_t most);

#endif
