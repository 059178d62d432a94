/* random_solids.h - solids that no one has chosen, in the scene language.
 *
 * Trees of all kinds of shapes and of each other, moved, turned and stretched.
 * On a grid all sizes and places are multiples of a quarter and all turns are
 * right angles, so that faces, edges and axes of different shapes coincide;
 * now and then a shape stands twice in one solid.
 */
#ifndef TESTS_RANDOM_SOLIDS_H
#define TESTS_RANDOM_SOLIDS_H

#include "tests/unit/traced_frame.h"

/* What is drawn. */
extern struct solids {
    bool clear; /* some parts are; their solids, too, are mirrors */
    bool gridded;
    bool patches; /* where they are not reported, unless reports may be */
    bool meshes;  /* likewise */
} solids;

size_t below(size_t count);

/* Of a shape: a size, which is above 0, or a place. */
double size_between(double low, double high);
double place_between(double low, double high);
double angle(void);

/* A motion that turns a shape any way, so many times as large. */
void add_turn(char *text, size_t size, double larger);
void add_gradient(char *text, size_t size);
void add_look(char *text, size_t size);
void add_solid(char *text, size_t size, size_t depth);

/* Two solids of some parts each, two of three of which are the shape that is begun by
 * these words: one frame of all stages, of both ways to the nearest, and without
 * bounds, the plain tracer's. */
void check_solids_with(void (*add_shape)(char *text, size_t size));

#endif
