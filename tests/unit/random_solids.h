/* random_solids.h - random solids in the scene language.
 *
 * Solids are trees of all kinds of shapes and of other solids. They are moved, rotated
 * and stretched. On a grid, all sizes and positions are multiples of a quarter, and all
 * rotations are right angles, so that faces, edges and axes of different shapes
 * coincide. Sometimes a shape occurs twice in one solid.
 */
#ifndef TESTS_RANDOM_SOLIDS_H
#define TESTS_RANDOM_SOLIDS_H

#include "tests/unit/traced_frame.h"

/* Options of the random solids. */
extern struct solids {
    bool clear; /* some parts are clear, and solids with clear parts may be mirrors */
    bool gridded;
    bool surfaces; /* include shapes that have or may have no inside; those that cause a
                    * report are excluded unless reports are allowed */
} solids;

size_t below(size_t count);

/* Return a size of a shape above 0, and a coordinate. */
double size_between(double low, double high);
double place_between(double low, double high);
double angle(void);

/* Adds a text that printf formats. It has random parts:
 *
 *   ^4.3:1.2^  a number from .3 to 1.2 with 4 decimals; ^4s.3:1.2^ is a size,
 *              ^4p-1:1^ a coordinate and ^2a^ an angle
 *   $3[a|b|]   one of three texts; the last text stands for missing texts
 *   @1.3@      a point within this distance, from add_point
 *
 * Numbers and choices up to the next point, or up to $., are drawn from right to
 * left. */
void add_random(char *text, size_t size, const char *format, ...);

/* Writes a motion that rotates a shape in any direction, and scales it by `larger`. */
void add_turn(char *text, size_t size, double larger);
void add_gradient(char *text, size_t size);
void add_look(char *text, size_t size);
void add_solid(char *text, size_t size, size_t depth);

/* Functions that begin a random shape of each kind. They write the keyword and the
 * arguments, without a closing brace. */
typedef void add_words(char *text, size_t size);
extern add_words *const random_shapes[PRIMITIVE_KINDS];

/* Makes two solids of several parts. On average, two of three parts are the shape that
 * `add_shape` begins. Fails unless all stages, both CSG methods, a run without bounds
 * and the plain tracer give the same frame. */
void check_solids_with(add_words *add_shape);

#endif
