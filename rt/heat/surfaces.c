/* surfaces.c - combines the factors of primitives into factors of surfaces. */
#include "rt/heat/surfaces.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "rt/scene/elementary.h"

/* ---- Listing -------------------------------------------------------------- */

static const char *name_of(struct surfaces *surfaces, const struct named_part *part,
                           enum surfaces_by by, size_t primitive)
{
    char number[24];
    if (by == BY_PART)
        return part->name;
    if (by == BY_MATERIAL)
        return part->material ? part->material : "none";
    snprintf(number, sizeof number, "%zu", primitive + 1);
    return arena_text(&surfaces->kept, number, strlen(number));
}

static size_t find_named(const struct surfaces *surfaces, const char *name)
{
    size_t i = 0;
    while (i < surfaces->count && strcmp(surfaces->list[i].name, name) != 0)
        i++;
    return i;
}

/* Finds the surface of primitive i, or adds a surface. */
static bool place(const struct scene *scene, const struct named_parts *parts,
                  enum surfaces_by by, size_t i, struct surfaces *surfaces)
{
    const struct primitive *primitive = &scene->primitives[i];
    size_t part = parts->part_of[primitive->object], found = surfaces->count;
    const char *name = name_of(surfaces, &parts->list[part], by, i);
    if (!name)
        return false;
    if (by != BY_PRIMITIVE)
        found = find_named(surfaces, name);
    if (found == surfaces->count)
        surfaces->list[surfaces->count++] = (struct surface){ .name = name,
                                                              .first = primitive,
                                                              .part = part };
    surfaces->surface_of[i] = found;
    surfaces->part_of[i] = part;
    return true;
}

static bool make_rows(struct surfaces *surfaces)
{
    bool good = true;
    for (size_t i = 0; good && i < surfaces->count; i++) {
        struct surface *surface = &surfaces->list[i];
        surface->count = calloc(surfaces->count + 1, sizeof *surface->count);
        surface->factor = calloc(surfaces->count + 1, sizeof *surface->factor);
        good = surface->count && surface->factor;
    }
    return good;
}

bool surfaces_find(const struct scene *scene, const struct named_parts *parts,
                   enum surfaces_by by, struct surfaces *surfaces)
{
    size_t count = scene->primitive_count + 1;
    bool good;
    *surfaces = (struct surfaces){ 0 };
    surfaces->list = calloc(count, sizeof *surfaces->list);
    surfaces->surface_of = calloc(count, sizeof *surfaces->surface_of);
    surfaces->part_of = calloc(count, sizeof *surfaces->part_of);
    surfaces->primitive_count = scene->primitive_count;
    good = surfaces->list && surfaces->surface_of && surfaces->part_of;
    for (size_t i = 0; good && i < scene->primitive_count; i++)
        good = place(scene, parts, by, i, surfaces);
    return good && make_rows(surfaces);
}

void surfaces_free(struct surfaces *surfaces)
{
    for (size_t i = 0; surfaces->list && i < surfaces->count; i++) {
        free(surfaces->list[i].count);
        free(surfaces->list[i].factor);
        free(surfaces->list[i].smooth);
    }
    free(surfaces->list);
    free(surfaces->surface_of);
    free(surfaces->part_of);
    arena_free(&surfaces->kept);
    *surfaces = (struct surfaces){ 0 };
}

/* ---- Areas and factors ------------------------------------------------------ */

static void add_row(struct surface *surface, const struct factor_row *row)
{
    double area = row->area.value;
    surface->area.value += area;
    surface->area.error = elementary_hypot(surface->area.error, row->area.error);
    surface->tried += row->tried;
    surface->sent += row->sent;
    for (size_t j = 0; j < row->receivers; j++) {
        surface->count[j] += row->count[j];
        surface->factor[j].value += area * row->factor[j].value;
    }
}

/* Adds the contribution of a primitive i to the errors of its surface's factors. A
 * factor of the surface is F = sum of A_i F_i / A, so it depends on the errors of all
 * F_i and A_i. */
static void add_errors(struct surface *surface, const struct factor_row *row)
{
    for (size_t j = 0; j < row->receivers; j++) {
        struct estimate *factor = &surface->factor[j];
        double own = row->area.value * row->factor[j].error;
        double beside = row->area.error * (row->factor[j].value - factor->value);
        factor->error = elementary_hypot(factor->error, elementary_hypot(own, beside)
                                                            / surface->area.value);
    }
}

void surfaces_combine(struct surfaces *surfaces, const struct factor_row *rows)
{
    size_t primitive_count = surfaces->primitive_count;
    for (size_t i = 0; i < primitive_count; i++) {
        struct surface *surface = &surfaces->list[surfaces->surface_of[i]];
        surface->receives_alone |= rows[i].receivers == 0;
        add_row(surface, &rows[i]);
    }
    for (size_t i = 0; i < surfaces->count; i++) {
        struct surface *surface = &surfaces->list[i];
        for (size_t j = 0; j <= surfaces->count && surface->sent > 0; j++)
            surface->factor[j].value /= surface->area.value;
    }
    for (size_t i = 0; i < primitive_count; i++)
        if (rows[i].sent > 0)
            add_errors(&surfaces->list[surfaces->surface_of[i]], &rows[i]);
}

void surfaces_take_lines(struct surfaces *surfaces, const struct global_lines *found)
{
    for (size_t i = 0; i < surfaces->count; i++) {
        struct surface *surface = &surfaces->list[i];
        surface->area = global_lines_area(found, i);
        for (size_t j = 0; j <= surfaces->count; j++) {
            surface->count[j] = global_lines_count(found, i, j);
            surface->sent += surface->count[j];
        }
        surface->tried = surface->sent;
        for (size_t j = 0; j <= surfaces->count && surface->sent > 0; j++)
            surface->factor[j] = global_lines_factor(found, i, j);
    }
}

double surface_factor(const struct surface *from, size_t to)
{
    return from->smooth ? from->smooth[to] : from->factor[to].value;
}

double surfaces_reciprocity(const struct surfaces *surfaces, size_t from, size_t to)
{
    const struct surface *one = &surfaces->list[from];
    const struct surface *other = &surfaces->list[to];
    double there, back, error;
    if (from == to || to == surfaces->count || other->receives_alone
        || other->sent == 0)
        return NAN;
    there = one->area.value * one->factor[to].value;
    back = other->area.value * other->factor[from].value;
    error = elementary_hypot(one->area.value * one->factor[to].error,
                             other->area.value * other->factor[from].error);
    if (fabs(there - back) <= 1e-12 * there) /* lines have exact reciprocity */
        return 0;
    return error > 0 ? (there - back) / error : NAN;
}
