/* field_reading.h - writes image files for a test, and finds triangles of the
 * height_field that such a file becomes. */
#ifndef TESTS_FIELD_READING_H
#define TESTS_FIELD_READING_H

#include "rt/shapes/primitive.h"
#include "tests/unit/scene_reading.h"

/* Fixtures that create and remove the image file, which has a unique name. */
extern char field_path[64];
int field_begin(void **state);
int field_end(void **state);
#undef FILE_FIXTURES
#define FILE_FIXTURES field_begin, field_end
/* Writes bytes to the file that field_read names. */
void field_keep(const char *bytes, size_t count);

/* Reads height_field { words, the file, modifiers }. */
struct scene *field_read(const char *words, const char *modifiers,
                         const struct scene_options *how, struct diagnostics *reports);
/* Reads a height_field that must cause no report. */
struct scene *field_expect(const char *words, const char *modifiers);
/* Reads a height_field that must cause exactly this error. */
void field_expect_fault(const char *words, const char *modifiers, size_t column,
                        const char *message);

/* Computes the barycentric coordinates in a triangle of a point in the x-z plane.
 * Returns false if the point is outside. */
bool field_shares(const struct triangle *triangle, double x, double z,
                  double shares[3]);
/* Returns the number of triangles that a line along y hits. Sets *height to the height
 * of the last hit. */
int field_meet(const struct triangles *triangles, double x, double z, double *height);

#endif
