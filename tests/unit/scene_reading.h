/* scene_reading.h - reads scenes from texts, for the tests of the scene language. */
#ifndef TESTS_SCENE_READING_H
#define TESTS_SCENE_READING_H

#include "rt/scene/language/scene_read.h"
#include "tests/unit/unit.h"

#include <math.h>

#define CLOSE 1e-12
#define PRINTED 1e-6 /* POV-Ray prints six decimals */

extern const struct scene_options reading_options, strict_options;
/* Options that also read images. */
extern const struct scene_options with_images;

/* Writes a file of these bytes. */
void write_bytes(const char *path, const char *bytes, size_t count);

void assert_close(double a, double b, double within);
void assert_vector(const double a[3], double x, double y, double z);
/* Compares each number; a failure reports `what` and the number's position. */
void assert_numbers(const char *what, const double *found, const double *expected,
                    size_t count, double within);

/* Returns `head` with `count` copies of `part` after it. The caller frees the text. */
char *repeated(const char *head, const char *part, size_t count);

/* Calls scene_read_text on a text after prefixing #version 3.7. Columns of line 1 in
 * reports are corrected to those of the text. */
struct scene *read_versioned(const char *name, const char *text,
                             const struct scene_options *how,
                             struct diagnostics *reports);

/* Calls read_versioned on a text that must be accepted, with any reports. */
struct scene *read_reported(const char *text, const struct scene_options *how,
                            struct diagnostics *reports);
/* Reads a scene that must have no error and exactly `expected` reports. */
struct scene *read_with(const char *text, size_t expected);
struct scene *read_scene(const char *text);
/* Calls read_scene on a text that is formatted by printf. */
#define read_format(...) read_scene(formatted(__VA_ARGS__))

/* Return the triangles of primitive i, which must be a mesh, or of a scene of one
 * mesh. */
const struct triangles *triangles_of_part(const struct scene *scene, size_t i);
const struct triangles *triangles_of(const struct scene *scene);

/* Fails unless the text is rejected with exactly one error at this position and
 * `message` in its text. */
void assert_error(const char *text, const struct scene_options *how, size_t line,
                  size_t column, const char *message);

/* A text of one line and its only error. */
struct line_error {
    const char *text;
    size_t column;
    const char *message; /* part of the error's text */
};
void assert_errors(const struct line_error *errors, size_t count);

/* A text of any lines and its only error. */
struct place_error {
    const char *text;
    size_t line, column;
    const char *message; /* part of the error's text */
};
void assert_place_errors(const struct place_error *errors, size_t count,
                         const struct scene_options *how);

/* Fails unless the text is rejected with at most `most` reports, and the first error, or
 * the last report, contains `message`. */
void assert_refused(const char *text, size_t most, const char *message);
void assert_refused_last(const char *text, size_t most, const char *message);

#endif
