/* gradient.h - the words of a pigment that is a gradient, in the order of
 * rt/kernels/frame/records.s. */
#ifndef RT_GRADIENT_H
#define RT_GRADIENT_H

#include "rt/scene/scene.h"
#include "vm/c205.h"

/* Of P_PATTERN so many stand before its stops. */
enum { GRADIENT_STOPS = 4 };

/* How a point's value grows with its three coordinates, and what it is at the
 * origin. */
void gradient_words(const struct pigment *pigment,
                    double words[GRADIENT_STOPS]);
/* The rows of its map, one more than there are stops, and how many words these
 * are; NULL: no memory.  The caller frees them. */
size_t gradient_size(const struct color_map *map);
c205_word *gradient_stops(const struct color_map *map);

#endif
