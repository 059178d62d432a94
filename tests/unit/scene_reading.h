/* scene_reading.h - scenes from texts, for the tests of the scene language. */
#ifndef TESTS_SCENE_READING_H
#define TESTS_SCENE_READING_H

#include "rt/scene/language/scene_read.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#define COUNT(array) (sizeof(array) / sizeof *(array))
#define CLOSE 1e-12
#define PRINTED 1e-6 /* POV-Ray's six places */

static const struct scene_options options = { .width = 640, .height = 480 };
static const struct scene_options strict = { .width = 640,
                                             .height = 480,
                                             .strict = true };

static inline void assert_close(double a, double b, double within)
{
    if (!(fabs(a - b) <= within))
        fail_msg("%.15g is not %.15g", a, b);
}

static inline void assert_vector(const double a[3], double x, double y,
                                 double z)
{
    assert_close(a[0], x, CLOSE);
    assert_close(a[1], y, CLOSE);
    assert_close(a[2], z, CLOSE);
}

/* A scene without errors and with that many reports. */
static inline struct scene *read_with(const char *text, size_t expected)
{
    struct diagnostics reports = { 0 };
    struct scene *scene = scene_read_text("test.pov", text, &options,
                                          &reports);

    if (!scene || reports.count != expected) {
        diagnostics_print(&reports, stderr);
        fail_msg("%zu reports, expected %zu: %s", reports.count, expected,
                 text);
    }
    diagnostics_free(&reports);
    return scene;
}

static inline struct scene *read(const char *text)
{
    return read_with(text, 0);
}

/* A text is not read, for one error, at that place and with a message of which
 * this is a part. */
static inline void assert_error(const char *text,
                                const struct scene_options *how, size_t line,
                                size_t column, const char *message)
{
    struct diagnostics reports = { 0 };
    struct scene *scene = scene_read_text("test.pov", text, how, &reports);
    const struct diagnostic *report = reports.items;

    if (scene || reports.count != 1 || report->severity != SEVERITY_ERROR
        || report->line != line || report->column != column
        || !strstr(report->message, message)) {
        diagnostics_print(&reports, stderr);
        fail_msg("expected %zu:%zu %s, of: %s", line, column, message, text);
    }
    diagnostics_free(&reports);
}

/* A text is not read; there are so many reports at the most, and one of them
 * says so. */
static inline void assert_refused(const char *text, size_t most,
                                  const char *message)
{
    struct diagnostics reports = { 0 };
    struct scene *scene = scene_read_text("test.pov", text, &options,
                                          &reports);
    bool said = false;

    for (size_t i = 0; i < reports.count; i++)
        said = said || strstr(reports.items[i].message, message);
    if (scene || !said || reports.count > most) {
        diagnostics_print(&reports, stderr);
        fail_msg("%zu reports, not '%s', of: %.80s", reports.count, message,
                 text);
    }
    diagnostics_free(&reports);
}

#endif
