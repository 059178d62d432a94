/* font.h - the outlines of characters, from the bytes of a font file.
 *
 * FreeType reads the file.  Its library is opened when the first font is, and
 * not before.  Lengths are in the font's em; x points to the right, y up; the
 * origin is where the character begins, on the baseline.
 */
#ifndef RT_SCENE_FONT_H
#define RT_SCENE_FONT_H

#include "base/arena.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Closed loops, one behind another, each ends with the corner that it begins
 * with, where it comes only then; what an odd number of them runs round is
 * ink.  Where curves are among their edges all of these are parabolas, with a handle
 * between two corners.  There is room for one point more. */
struct glyph {
    size_t count;
    size_t apart; /* how far one corner is from the next: 1 or, with handles,
                     2 */
    double (*points)[2];
    double bearing; /* where its ink begins, x */
    double advance; /* to where the next character begins */
};

struct font;

/* The bytes must outlive the font.  NULL, with *fault: why there is none. */
struct font *font_open(const char *bytes, size_t length, const char **fault);
void font_close(struct font *font);

/* Of a character, which the font may show by a box of its own.  False without
 * memory, or where the font is broken. */
bool font_glyph(const struct font *font, uint32_t character, struct arena *arena,
                struct glyph *glyph);
/* A loop, its last point not its first again yet, that touches itself begins
 * where it does not, for there it would be taken for two.  One that touches
 * itself in all of its first hundred corners stays as it is.  Corners are so
 * far apart. */
void font_turn_loop(double (*points)[2], size_t count, size_t apart);
/* How much nearer two neighbours stand, as the font says; below 0. */
double font_kerning(const struct font *font, uint32_t left, uint32_t right);

#endif
