/* scene_reading.h - scenes from texts, for the tests of the scene language. */
#ifndef TESTS_SCENE_READING_H
#define TESTS_SCENE_READING_H

#include "rt/scene/language/scene_read.h"
#include "tests/unit/unit.h"

#include <math.h>

#define CLOSE 1e-12
#define PRINTED 1e-6 /* POV-Ray's six places */

extern const struct scene_options reading_options, strict_options;
/* .. to read images, too. */
extern const struct scene_options with_images;

/* A file of these bytes. */
void write_bytes(const char *path, const char *bytes, size_t count);

void assert_close(double a, double b, double within);
void assert_vector(const double a[3], double x, double y, double z);

/* scene_read_text of a text of #version 3.7.  In reports the columns of line 1
 * are those of the text. */
struct scene *read_versioned(const char *name, const char *text,
                             const struct scene_options *how,
                             struct diagnostics *reports);

/* A scene without errors and with that many reports. */
struct scene *read_with(const char *text, size_t expected);
struct scene *read_scene(const char *text);
/* read_scene of a text that printf would write. */
struct scene *read_format(const char *format, ...)
    __attribute__((format(printf, 1, 2)));

/* Of a primitive that is a mesh; of a scene that is one. */
const struct triangles *triangles_of_part(const struct scene *scene, size_t i);
const struct triangles *triangles_of(const struct scene *scene);

/* A text is not read, for one error, at that place and with a message of which
 * this is a part. */
void assert_error(const char *text, const struct scene_options *how, size_t line,
                  size_t column, const char *message);

/* Texts of one line, each with this one error. */
struct line_error {
    const char *text;
    size_t column;
    const char *message; /* a part of it */
};
void assert_errors(const struct line_error *errors, size_t count);

/* A text is not read; there are so many reports at most, and one of them
 * says so. */
void assert_refused(const char *text, size_t most, const char *message);

#endif
