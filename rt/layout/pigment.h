/* pigment.h - the words of a pigment that has a map, in the order of
 * rt/kernels/frame/records.s and rt/kernels/light/pattern.s. */
#ifndef RT_LAYOUT_PIGMENT_H
#define RT_LAYOUT_PIGMENT_H

#include "rt/scene/scene.h"
#include "vm/c205.h"

/* Of P_PATTERN so many are before a gradient's stops; of a pattern there are so
 * many words, and of its P_MAP so many numbers. */
enum { GRADIENT_STOPS = 4, PATTERN_ROWS = 12, MAP_NUMBERS = 4 };

/* Whether the kernels need light/pattern.s for one of its pigments or normals. */
bool scene_has_patterns(const struct scene *scene);
/* How a point's value grows with its three coordinates, and what it is at the
 * origin. */
void gradient_words(const struct pigment *pigment, double words[GRADIENT_STOPS]);
/* From world points to those whose value a pattern has. */
void pattern_rows(const struct pigment *pigment, double words[PATTERN_ROWS]);
/* What makes a wave of its values, NULL if they go in none; by which numbers; and
 * what finds them. */
const char *pattern_wave(const struct pigment *pigment);
void pattern_numbers(const struct pattern *pattern, double numbers[MAP_NUMBERS]);
const char *pattern_routine(const struct pattern *pattern);
/* The stops of its map, of a list as steps; whether they are another one's. */
size_t stop_count(const struct pigment *pigment);
bool has_stops_of(const struct pigment *pigment, const struct pigment *other);
/* Their rows, one more than there are stops, and how many words these are; NULL:
 * no memory.  The caller frees them. */
size_t stops_size(const struct pigment *pigment);
c205_word *stops_words(const struct pigment *pigment);

#endif
