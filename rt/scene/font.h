/* font.h - the outlines of characters, from the bytes of a font file.
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

/* The outline of a character: closed loops, one after another. Each loop ends with its
 * first corner, which occurs nowhere else in the loop. A point is ink if it is inside
 * an odd number of loops. If any edge is a curve, all edges are parabolas, with one
 * handle between two corners. The array has room for one more point. */
struct glyph {
    size_t count;
    size_t apart; /* the step from one corner to the next: 1 or, with handles, 2 */
    double (*points)[2];
    double bearing; /* x of the left edge of the ink */
    double advance; /* x of the start of the next character */
};

struct font;

/* Opens a font from its bytes, which must outlive it. Returns NULL after an error and
 * sets *fault to the reason. */
struct font *font_open(const char *bytes, size_t length, const char **fault);
void font_close(struct font *font);

/* Reads the glyph of a character. A font may show a box for a character that it does
 * not have. Fails without memory or if the font is broken. */
bool font_glyph(const struct font *font, uint32_t character, struct arena *arena,
                struct glyph *glyph);
/* Rotates a loop so that it does not begin at a corner where it touches itself. Without
 * this it would be taken for two loops, because a loop ends where its first corner is
 * repeated. The last point of the loop is not yet a copy of its first. A loop that
 * touches itself in all of its first 100 corners is not changed. `apart` is the step
 * between corners. */
void font_turn_loop(double (*points)[2], size_t count, size_t apart);
/* Returns the kerning of two adjacent characters: below 0 if they are closer than their
 * advance. */
double font_kerning(const struct font *font, uint32_t left, uint32_t right);

#endif
