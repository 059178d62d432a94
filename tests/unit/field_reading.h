/* field_reading.h - a file that a height_field reads, and where the triangles are that it
 * becomes.
 */
#ifndef TESTS_FIELD_READING_H
#define TESTS_FIELD_READING_H

#include "rt/shapes/primitive.h"
#include "tests/unit/scene_reading.h"

/* The file has a name of its own, and is removed in the end. */
int field_begin(void **state);
int field_end(void **state);
/* The file's bytes. */
void field_keep(const char *bytes, size_t count);

/* height_field { words, the file, modifiers }. */
struct scene *field_read(const char *words, const char *modifiers,
                         const struct scene_options *how, struct diagnostics *reports);
/* .. without a report; */
struct scene *field_expect(const char *words, const char *modifiers);
/* .. or with one error. */
void field_expect_fault(const char *words, const char *modifiers, size_t column,
                        const char *message);

/* The shares of a triangle's corners at a point of the x-z plane; false: it is
 * outside. */
bool field_shares(const struct triangle *triangle, double x, double z,
                  double shares[3]);
/* How many triangles a line along y meets; the height is that of the last. */
int field_meet(const struct triangles *triangles, double x, double z, double *height);

#endif
