/* field_reading.c - reads height fields from a file and finds points of triangles. */
#include "tests/unit/field_reading.h"

#include <unistd.h>

char field_path[64];

int field_begin(STATE)
{
    snprintf(field_path, sizeof field_path, "/tmp/rt205-heights-%ld", (long)getpid());
    return 0;
}

int field_end(STATE)
{
    remove(field_path);
    return 0;
}

void field_keep(const char *bytes, size_t count)
{
    write_bytes(field_path, bytes, count);
}

struct scene *field_read(const char *words, const char *modifiers,
                         const struct scene_options *how, struct diagnostics *reports)
{
    const char *text = formatted("height_field { %s \"%s\" %s }", words, field_path,
                                 modifiers);
    return read_versioned("test.pov", text, how, reports);
}

struct scene *field_expect(const char *words, const char *modifiers)
{
    SCOPED_VALUE(diagnostics) reports = { 0 };
    struct scene *scene = field_read(words, modifiers, &with_images, &reports);
    diagnostics_print(&reports, stderr);
    assert_non_null(scene);
    assert_int_equal(reports.count, 0);
    return scene;
}

void field_expect_fault(const char *words, const char *modifiers, size_t column,
                        const char *message)
{
    SCOPED_VALUE(diagnostics) reports = { 0 };
    struct scene *scene = field_read(words, modifiers, &with_images, &reports);
    if (scene || reports.count != 1 || reports.items->column != column
        || !strstr(reports.items->message, message)) {
        diagnostics_print(&reports, stderr);
        fail_msg("not '%s' at %zu", message, column);
    }
}

bool field_shares(const struct triangle *triangle, double x, double z, double shares[3])
{
    const double(*at)[3] = triangle->corners;
    double area = (at[1][0] - at[0][0]) * (at[2][2] - at[0][2])
                  - (at[2][0] - at[0][0]) * (at[1][2] - at[0][2]);
    for (int k = 0; k < 3; k++) {
        const double *a = at[(k + 1) % 3], *b = at[(k + 2) % 3];
        shares[k] = ((a[0] - x) * (b[2] - z) - (b[0] - x) * (a[2] - z)) / area;
    }
    return shares[0] > 0 && shares[1] > 0 && shares[2] > 0;
}

int field_meet(const struct triangles *triangles, double x, double z, double *height)
{
    int count = 0;
    for (size_t i = 0; i < triangles->count; i++) {
        double shares[3];
        if (!field_shares(&triangles->list[i], x, z, shares))
            continue;
        *height = 0;
        for (int k = 0; k < 3; k++)
            *height += shares[k] * triangles->list[i].corners[k][1];
        count++;
    }
    return count;
}
