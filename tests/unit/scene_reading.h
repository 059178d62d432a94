/* scene_reading.h - reads scenes from texts, for the tests of the scene language. */
#ifndef TESTS_SCENE_READING_H
#define TESTS_SCENE_READING_H

#include "rt/scene/language/scene_read.h"
#include "tests/unit/unit.h"

#include <math.h>

#define CLOSE 1e-12
#define PRINTED 1e-6 /* POV-Ray prints six decimals */

extern const struct scene_options reading_options, strict_options;
/* Options with which images other than PGM and PPM are read, too. */
extern const struct scene_options with_images;

/* Writes bytes to a file. */
void write_bytes(const char *path, const char *bytes, size_t count);

void assert_close(double a, double b, double within);
void assert_vector(const double a[3], double x, double y, double z);
/* Compares each number. A failure prints `what` and the index of the number. */
void assert_numbers(const char *what, const double *found, const double *expected,
                    size_t count, double within);

/* Returns `head` with `count` copies of `part` after it. The caller frees the text. */
char *repeated(const char *head, const char *part, size_t count);

/* Calls scene_read_text on "#version 3.7" and the text. Columns in line 1 of reports
 * are corrected to columns of the text. */
struct scene *read_versioned(const char *name, const char *text,
                             const struct scene_options *how,
                             struct diagnostics *reports);

/* Calls read_versioned on a text that must be accepted. It may have any reports. */
struct scene *read_reported(const char *text, const struct scene_options *how,
                            struct diagnostics *reports);
/* Reads a scene. It must have no error and exactly `expected` reports. */
struct scene *read_with(const char *text, size_t expected);
struct scene *read_scene(const char *text);
/* Calls read_scene on a text that printf formats. */
#define read_format(...) read_scene(formatted(__VA_ARGS__))

/* triangles_of_part returns the triangles of primitive i, which must be a mesh.
 * triangles_of returns the triangles of a scene with a single mesh. */
const struct triangles *triangles_of_part(const struct scene *scene, size_t i);
const struct triangles *triangles_of(const struct scene *scene);

/* Fails unless the text has exactly one error, here and with `message`. */
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

/* Fails unless the text is rejected with at most `most` reports. The first error must
 * contain `message`, or the last report for assert_refused_last. */
void assert_refused(const char *text, size_t most, const char *message);
void assert_refused_last(const char *text, size_t most, const char *message);

#endif
