/* scene_reading.c - reads scene texts that must be accepted or rejected. */
#include "scene_reading.h"

#include "rt/picture/picture.h"

#define VERSION "#version 3.7;"

const struct scene_options reading_options = { .width = 640,
                                               .height = 480,
                                               .reading_most = 1 << 30 };
const struct scene_options strict_options = { .width = 640,
                                              .height = 480,
                                              .strict = true };
const struct scene_options with_images = { .width = 640,
                                           .height = 480,
                                           .read_raster = picture_read_raster };

void write_bytes(const char *path, const char *bytes, size_t count)
{
    FILE *file = NON_NULL(fopen(path, "wb"));
    assert_int_equal(fwrite(bytes, 1, count, file), count);
    assert_int_equal(fclose(file), 0);
}

void assert_close(double a, double b, double within)
{
    FAIL_IF(!(fabs(a - b) <= within), "%.15g is not %.15g", a, b);
}

void assert_vector(const double a[3], double x, double y, double z)
{
    assert_close(a[0], x, CLOSE);
    assert_close(a[1], y, CLOSE);
    assert_close(a[2], z, CLOSE);
}

void assert_numbers(const char *what, const double *found, const double *expected,
                    size_t count, double within)
{
    for (size_t i = 0; i < count; i++)
        FAIL_IF(!(fabs(found[i] - expected[i]) <= within),
                "%s: number %zu of %zu: %.15g is not %.15g", what, i + 1, count,
                found[i], expected[i]);
}

char *repeated(const char *head, const char *part, size_t count)
{
    size_t start = strlen(head), length = strlen(part);
    char *text = NON_NULL(malloc(start + count * length + 1));
    memcpy(text, head, start + 1);
    for (size_t i = 0; i < count; i++)
        memcpy(text + start + i * length, part, length + 1);
    return text;
}

struct scene *read_versioned(const char *name, const char *text,
                             const struct scene_options *how,
                             struct diagnostics *reports)
{
    FREED char *versioned = NON_NULL(malloc(strlen(VERSION) + strlen(text) + 1));
    strcpy(versioned, VERSION);
    strcat(versioned, text);
    struct scene *scene = scene_read_text(name, versioned, how, reports);
    for (size_t i = 0; i < reports->count; i++)
        if (reports->items[i].line == 1)
            reports->items[i].column -= strlen(VERSION);
    return scene;
}

struct scene *read_reported(const char *text, const struct scene_options *how,
                            struct diagnostics *reports)
{
    struct scene *scene = read_versioned("test.pov", text, how, reports);
    if (!scene) {
        diagnostics_print(reports, stderr);
        fail_msg("is not read: %.200s", text);
    }
    return scene;
}

struct scene *read_with(const char *text, size_t expected)
{
    SCOPED_VALUE(diagnostics) reports = { 0 };
    struct scene *scene = read_reported(text, &reading_options, &reports);
    if (reports.count != expected) {
        diagnostics_print(&reports, stderr);
        fail_msg("%zu reports, expected %zu: %s", reports.count, expected, text);
    }
    return scene;
}

struct scene *read_scene(const char *text)
{
    return read_with(text, 0);
}

void assert_error(const char *text, const struct scene_options *how, size_t line,
                  size_t column, const char *message)
{
    SCOPED_VALUE(diagnostics) reports = { 0 };
    struct scene *scene = read_versioned("test.pov", text, how, &reports);
    const struct diagnostic *report = reports.items;
    if (scene || reports.count != 1 || report->severity != SEVERITY_ERROR
        || report->line != line || report->column != column
        || !strstr(report->message, message)) {
        diagnostics_print(&reports, stderr);
        fail_msg("expected %zu:%zu %s, of: %s", line, column, message, text);
    }
}

void assert_errors(const struct line_error *errors, size_t count)
{
    for (size_t i = 0; i < count; i++)
        assert_error(errors[i].text, &reading_options, 1, errors[i].column,
                     errors[i].message);
}

void assert_place_errors(const struct place_error *errors, size_t count,
                         const struct scene_options *how)
{
    for (size_t i = 0; i < count; i++)
        assert_error(errors[i].text, how, errors[i].line, errors[i].column,
                     errors[i].message);
}

static void check_refused(const char *text, size_t most, bool last, const char *message)
{
    SCOPED_VALUE(diagnostics) reports = { 0 };
    struct scene *scene = read_versioned("test.pov", text, &reading_options, &reports);
    size_t i = last && reports.count > 0 ? reports.count - 1 : 0;
    while (!last && i < reports.count && reports.items[i].severity != SEVERITY_ERROR)
        i++;
    if (scene || reports.count > most || i == reports.count
        || !strstr(reports.items[i].message, message)) {
        diagnostics_print(&reports, stderr);
        fail_msg("%zu reports, not '%s', of: %.80s", reports.count, message, text);
    }
}

void assert_refused(const char *text, size_t most, const char *message)
{
    check_refused(text, most, false, message);
}

void assert_refused_last(const char *text, size_t most, const char *message)
{
    check_refused(text, most, true, message);
}

const struct triangles *triangles_of_part(const struct scene *scene, size_t i)
{
    assert_true(i < scene->primitive_count);
    assert_int_equal(scene->primitives[i].kind, PRIMITIVE_MESH);
    return &scene->primitives[i].shape.mesh.triangles;
}

const struct triangles *triangles_of(const struct scene *scene)
{
    assert_int_equal(scene->primitive_count, 1);
    return triangles_of_part(scene, 0);
}
