/* pigment.h - computes the words of a pigment that has a map, in the order of
 * rt/kernels/frame/records.s and rt/kernels/light/pattern.s. */
#ifndef RT_LAYOUT_PIGMENT_H
#define RT_LAYOUT_PIGMENT_H

#include "rt/scene/scene.h"
#include "vm/c205.h"

/* Sizes: the words of P_PATTERN before the stops of a gradient, the words of a
 * pattern, and the numbers of its P_MAP. */
enum { GRADIENT_STOPS = 4, PATTERN_ROWS = 12, MAP_NUMBERS = 4 };

/* Returns true if a pigment or normal of the scene needs light/pattern.s. */
bool scene_has_patterns(const struct scene *scene);
/* Computes the linear function of the three coordinates that gives a point's
 * value: three factors, then the value at the origin. */
void gradient_words(const struct pigment *pigment, double words[GRADIENT_STOPS]);
/* Computes the map from world points to points of the pattern's space. */
void pattern_rows(const struct pigment *pigment, double words[PATTERN_ROWS]);
/* Return the routine of the pattern's wave form (NULL: none), and the parameters. */
const char *pattern_wave(const struct pigment *pigment);
void pattern_numbers(const struct pattern *pattern, double numbers[MAP_NUMBERS]);
/* Return the number of stops of its map (the steps of a list count as stops), and
 * whether it has the same stops as another pigment. */
size_t stop_count(const struct pigment *pigment);
bool has_stops_of(const struct pigment *pigment, const struct pigment *other);
/* Return the number of words of the stops, which have one more row than stops, and
 * the words themselves. The words are NULL if out of memory; the caller frees
 * them. */
size_t stops_size(const struct pigment *pigment);
c205_word *stops_words(const struct pigment *pigment);

#endif
