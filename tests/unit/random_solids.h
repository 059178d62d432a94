/* random_solids.h - random solids in the scene language.
 *
 * Solids are trees of all kinds of shapes and of other solids, moved, turned and
 * stretched. On a grid all sizes and positions are multiples of a quarter and all turns
 * are right angles, so that faces, edges and axes of different shapes coincide;
 * sometimes a shape occurs twice in one solid.
 */
#ifndef TESTS_RANDOM_SOLIDS_H
#define TESTS_RANDOM_SOLIDS_H

#include "tests/unit/traced_frame.h"

/* Options of the random solids. */
extern struct solids {
    bool clear; /* some parts are clear; their solids may be mirrors */
    bool gridded;
    bool patches; /* draw patches that cause no report, or any if allowed */
    bool meshes;  /* draw meshes, by the same rule */
} solids;

size_t below(size_t count);

/* Return a size of a shape, which is above 0, or a coordinate. */
double size_between(double low, double high);
double place_between(double low, double high);
double angle(void);

/* Adds a format of printf with random parts:
 *   ^4.3:1.2^  a number from .3 to 1.2 with 4 decimals; ^4s.3:1.2^ is a size,
 *              ^4p-1:1^ a coordinate and ^2a^ an angle
 *   $3[a|b|]   one of three texts; the last one for each that is missing
 *   @1.3@      a point of this reach, by add_point
 * Numbers and choices up to the next point, or up to $., are drawn from right to left. */
void add_random(char *text, size_t size, const char *format, ...);

/* Writes a motion that turns a shape in any direction and scales it by `larger`. */
void add_turn(char *text, size_t size, double larger);
void add_gradient(char *text, size_t size);
void add_look(char *text, size_t size);
void add_solid(char *text, size_t size, size_t depth);

/* Draws two solids of several parts. Two of three parts are the shape that `add_shape`
 * begins. Fails unless all stages, both methods of visibility, and a run without bounds
 * give the same frame, and the plain tracer gives it too. */
void check_solids_with(void (*add_shape)(char *text, size_t size));

#endif
