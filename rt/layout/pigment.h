/* pigment.h - computes the words of a pigment that has a map.
 * rt/kernels/frame/records.s and rt/kernels/light/pattern.s define their order. */
#ifndef RT_LAYOUT_PIGMENT_H
#define RT_LAYOUT_PIGMENT_H

#include "rt/scene/scene.h"
#include "vm/c205.h"

/* Numbers of words in the record of a primitive. In the field P_PATTERN, a gradient has
 * GRADIENT_STOPS words before its stops, and any other pattern has PATTERN_ROWS words.
 * The field P_MAP contains MAP_NUMBERS parameters. */
enum { GRADIENT_STOPS = 4, PATTERN_ROWS = 12, MAP_NUMBERS = 4 };

/* Returns true if a pigment or normal of the scene needs light/pattern.s. */
bool scene_has_patterns(const struct scene *scene);
/* Computes the linear function that maps a point to its value: the factors of x, y and
 * z, then the value at the origin. */
void gradient_words(const struct pigment *pigment, double words[GRADIENT_STOPS]);
/* Computes the matrix that maps world points to the pattern's space. */
void pattern_rows(const struct pigment *pigment, double words[PATTERN_ROWS]);
/* Return the routine of the pattern's waveform (NULL: none), and its parameters. */
const char *pattern_wave(const struct pigment *pigment);
void pattern_numbers(const struct pattern *pattern, double numbers[MAP_NUMBERS]);
/* Return the number of stops of the map, where each step of a list counts as a stop,
 * and whether two pigments have the same stops. */
size_t stop_count(const struct pigment *pigment);
bool has_stops_of(const struct pigment *pigment, const struct pigment *other);
/* Return the number of words of the stops, and the words. There is one row more than
 * stops. stops_words returns NULL if out of memory; the caller frees the words. */
size_t stops_size(const struct pigment *pigment);
c205_word *stops_words(const struct pigment *pigment);

#endif
