/* svg.h - the common parts of SVG pictures: the background, a title, and round numbers
 * for the axes. The background is white, so a picture looks the same on dark pages.
 */
#ifndef BASE_SVG_H
#define BASE_SVG_H

#include <stdint.h>

#include "base/sink.h"

/* Sizes are in pixels. style is CSS for the classes of the picture. */
struct svg_sheet {
    int width, height, left;
    const char *style;
};

/* Begins a picture. The x coordinate of the title is sheet->left. */
void svg_begin(const struct sink *sink, const struct svg_sheet *sheet,
               const char *title);
void svg_end(const struct sink *sink);
/* Writes text and escapes the characters of markup. */
void svg_put_escaped(const struct sink *sink, const char *text);

/* Returns the smallest step that divides a span into at most `most` parts. It is 1, 2
 * or 5 times a power of ten. */
uint64_t svg_round_step(uint64_t span, uint64_t most);

#endif
