/* font.h - extracts the outlines of characters from the bytes of a font file.
 *
 * FreeType reads the file. Its library is loaded when the first font is opened. Lengths
 * are in the em of the font. The x axis points right and the y axis up; the origin is
 * the start of the character on the baseline.
 */
#ifndef RT_SCENE_FONT_H
#define RT_SCENE_FONT_H

#include "base/arena.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The outline of a character: a list of closed loops. Each loop ends with its first
 * corner, which occurs nowhere else in the loop. A point is ink if it is inside an odd
 * number of loops. If any edge is a curve, all edges are parabolas with one handle
 * between two corners. The array has room for one more point. */
struct glyph {
    size_t count;
    size_t apart; /* index distance of successive corners: 1, or 2 with handles */
    double (*points)[2];
    double bearing; /* x coordinate of the left edge of the ink */
    double advance; /* x coordinate where the next character starts */
};

struct font;

/* Opens a font from its bytes. The bytes must outlive the font. Returns NULL after an
 * error and sets *fault to the reason. */
struct font *font_open(const char *bytes, size_t length, const char **fault);
void font_close(struct font *font);

/* Reads the glyph of a character. For a character that the font does not have, the
 * glyph may be a box. Returns false if out of memory, or if the font is invalid. */
bool font_glyph(const struct font *font, uint32_t character, struct arena *arena,
                struct glyph *glyph);
/* Rotates a loop so that its first corner occurs only once. A loop ends where its first
 * corner is repeated, so without the rotation a loop that touches itself there would
 * count as two loops. The last point of the loop is not yet a copy of the first. If the
 * loop touches itself at all of its first 100 corners, it is not changed. `apart` is
 * the index distance of successive corners. */
void font_turn_loop(double (*points)[2], size_t count, size_t apart);
/* Returns the kerning of two adjacent characters. It is negative if they are closer
 * than their advance. */
double font_kerning(const struct font *font, uint32_t left, uint32_t right);

#endif
