/* solids.c - writes a scene's primitives and regions into memory. */
#include "rt/layout/solids.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "rt/layout/bumps.h"
#include "rt/layout/images.h"
#include "rt/layout/materials.h"
#include "rt/layout/pigment.h"
#include "rt/layout/regions.h"
#include "rt/layout/surface.h"
#include "rt/layout/trees.h"
#include "rt/shapes/shape_words.h"

/* Converts the elements of a primitive's table that represent integers to the integer
 * format of the machine. Returns false if out of memory. */
static bool put_integers(const struct primitive *primitive,
                         const struct viewpoints *viewpoints, const double *table,
                         size_t count, c205_word *words)
{
    const struct shape *shape = shape_of(primitive);
    bool *marks;
    if (!shape->mark_integers)
        return true;
    marks = calloc(count + 1, sizeof *marks);
    if (!marks)
        return false;
    shape->mark_integers(primitive, viewpoints, marks);
    for (size_t i = 0; i < count; i++)
        if (marks[i])
            words[i] = c205_from_integer((int64_t)table[i]);
    free(marks);
    return true;
}

static void put_shape_table(struct record *record, const struct primitive *primitive,
                            const struct viewpoints *viewpoints)
{
    size_t count = shape_table_count(primitive, viewpoints);
    double *table = shape_table(primitive, viewpoints, count);
    c205_word *words = calloc(count + 1, sizeof *words);
    if (!table || !words) {
        layout_fail(record->layout, "out of memory");
    } else if (count > 0) {
        record_check(record, table, count);
        put_numbers(words, table, count);
        if (put_integers(primitive, viewpoints, table, count, words))
            record_table(record, "P_TABLE", words, count);
        else
            layout_fail(record->layout, "out of memory");
    }
    free(table);
    free(words);
}

/* Returns the value of P_ON_PATCH for a mesh. The value states whether the mesh is
 * invisible, and whether it has an outside. */
static size_t mesh_sort(const struct primitive *primitive,
                        const struct shape_words *shape)
{
    enum { NO_OUTSIDE = 2, OUTSIDE, INVISIBLE };
    return primitive->invisible ? INVISIBLE : shape->state ? OUTSIDE : NO_OUTSIDE;
}

static void put_shape(struct record *record, const struct primitive *primitive,
                      const struct leaf_plan *plan, const struct viewpoints *viewpoints)
{
    struct shape_words shape;
    const char *kernel;
    bool carried; /* the ray is transformed into the primitive's space */
    if (!plan->simple || !shape_words_historical(primitive, &shape)
        || !object_symbol(record->layout->program, shape.kernel))
        shape_words(primitive, &shape);
    kernel = plan->simple ? shape.kernel : shape.solid;
    carried = shape.transformed && !primitive->invisible;
    record_routine(record, "P_KERNEL", carried ? "transformed" : kernel);
    record_routine(record, "P_INNER", kernel);
    record_routine(record, "P_NORMAL", shape.normal);
    if (!plan->simple && shape.state) {
        record_routine(record, "P_STATE_KERNEL",
                       shape.transformed ? "transformed" : shape.state);
        record_routine(record, "P_STATE_INNER", shape.state);
    }
    record_integer(record, "P_TRANSFORMED", shape.transformed);
    record_integer(record, "P_ON_PATCH",
                   shape.on_mesh && !plan->simple ? mesh_sort(primitive, &shape)
                                                  : shape.on_patch);
    record_integer(record, "P_SEGMENTS", shape.segments);
    record_integer(record, "P_EVENTS", shape.events);
    record_integer(record, "P_INVERTED", primitive->inverted);
    record_numbers(record, "P_SHAPE", shape.words, shape.count);
    put_shape_table(record, primitive, plan->simple ? viewpoints : NULL);
    record_numbers(record, "P_LOCAL", &primitive->to_local.rows[0][0], 12);
}

/* The stops of the last map, which the next pigment may share, and the address of each
 * image. */
struct map_place {
    const struct pigment *pigment;
    c205_word address;
    const uint64_t *images;
};

/* Returns the number of a primitive's space. Consecutive primitives with the same space
 * have the same number: the index of the first one, plus 1. Rays are then transformed
 * only once for these primitives. `before` is the number of the previous primitive's
 * space. */
static size_t space_of(const struct scene *scene, size_t i, size_t before)
{
    const struct transform *space = &scene->primitives[i].to_local;
    return i > 0
                   && memcmp(space, &scene->primitives[i - 1].to_local, sizeof *space)
                          == 0
               ? before
               : i + 1;
}

/* Writes the finish. Its ambient, emission and diffuse light is multiplied by
 * `opacity`, which is 1 if the colours in the record already contain the opacity. */
static void put_finish(struct record *record, const struct scene *scene,
                       const struct finish *finish, double opacity)
{
    double words[8];
    for (size_t i = 0; i < 3; i++)
        words[i] = (finish->ambient[i] * scene->ambient_light[i] + finish->emission[i])
                   * opacity;
    words[3] = finish->diffuse * opacity;
    words[4] = finish->phong;
    words[5] = finish->phong_size;
    words[6] = finish->specular;
    words[7] = finish->roughness > 0 ? 1 / finish->roughness : 0;
    record_numbers(record, "P_FINISH", words, 8);
}

/* Writes the part of a finish that depends on the angle, if the program contains
 * light/gloss.s. */
static void put_gloss(struct record *record, const struct finish *finish)
{
    const double gloss[2] = { finish->brilliance, finish->metallic };
    double range[3];
    if (!object_symbol(record->layout->program, "P_GLOSS"))
        return;
    for (size_t i = 0; i < 3; i++)
        range[i] = finish->reflection_most[i] - finish->reflection[i];
    record_numbers(record, "P_GLOSS", gloss, 2);
    record_numbers(record, "P_REFLECTION_RANGE", range, 3);
    record_numbers(record, "P_REFLECTION_FALLOFF", &finish->reflection_falloff, 1);
    record_numbers(record, "P_REFLECTION_METALLIC", &finish->reflection_metallic, 1);
    record_integer(record, "P_REFLECTION_KIND", surface_mirror_kind(finish));
}

/* Writes the stops of the pigment's map, and records the pigment and the address of the
 * stops in `map`. Does nothing if `map` has recorded equal stops. */
static void put_stops(struct record *record, const struct pigment *pigment,
                      struct map_place *map)
{
    c205_word *stops;
    if (map->pigment && has_stops_of(pigment, map->pigment))
        return;
    stops = stops_words(pigment);
    if (stops)
        record_table(record, "P_STOPS", stops, stops_size(pigment));
    else
        layout_fail(record->layout, "out of memory");
    free(stops);
    map->pigment = pigment;
    record_read(record, "P_STOPS", &map->address, 1);
}

static void put_gradient(struct record *record, const struct pigment *pigment,
                         struct map_place *map)
{
    double words[GRADIENT_STOPS];
    put_stops(record, pigment, map);
    gradient_words(pigment, words);
    record_numbers(record, "P_PATTERN", words, GRADIENT_STOPS);
    record_address(record, "P_STOPS", map->address);
    record_integer(record, "P_STOP_COUNT", stop_count(pigment));
}

static void put_pattern(struct record *record, const struct pigment *pigment,
                        struct map_place *map)
{
    const char *wave = pattern_wave(pigment);
    double words[PATTERN_ROWS], numbers[MAP_NUMBERS];
    put_stops(record, pigment, map);
    pattern_rows(pigment, words);
    pattern_numbers(&pigment->pattern, numbers);
    record_numbers(record, "P_PATTERN", words, PATTERN_ROWS);
    record_routine(record, "P_MAP_FUNCTION",
                   pattern_rules[pigment->pattern.function].routine);
    if (wave)
        record_routine(record, "P_MAP_WAVE", wave);
    record_numbers(record, "P_MAP_NUMBERS", numbers, MAP_NUMBERS);
    record_address(record, "P_MAP_STOPS", map->address);
    record_integer(record, "P_MAP_STOP_COUNT", stop_count(pigment));
}

/* Writes the address of the image's table in place of the stops. */
static void put_image(struct record *record, const struct pigment *pigment,
                      const struct map_place *map)
{
    const struct image_map *image = &pigment->image;
    double numbers[MAP_NUMBERS];
    image_numbers(image, numbers);
    record_numbers(record, "P_PATTERN", &pigment->to_local.rows[0][0], PATTERN_ROWS);
    record_routine(record, "P_MAP_FUNCTION", image_routine(image));
    record_routine(record, "P_MAP_WAVE", image_sampler(image));
    record_numbers(record, "P_MAP_NUMBERS", numbers, MAP_NUMBERS);
    record_address(record, "P_MAP_STOPS", map->images[image->table->number]);
}

static void put_surface(struct record *record, const struct scene *scene,
                        const struct primitive *primitive, struct map_place *map)
{
    const struct pigment *pigment = &primitive->pigment;
    bool metal = surface_is_metal(pigment, &primitive->finish);
    double color[2][3], passing[2][4];
    for (int i = 0; i < 2; i++) {
        if (metal)
            memcpy(color[i], pigment->color[i], sizeof color[i]);
        else
            surface_color(pigment, i, color[i]);
        surface_passing(pigment, i, passing[i]);
        passing[i][3] = surface_passing_weight(passing[i], scene->adc_bailout);
    }
    record_integer(record, "P_PIGMENT", pigment->kind);
    record_numbers(record, "P_COLOR", &color[0][0], 6);
    if (pigment->kind == PIGMENT_GRADIENT)
        put_gradient(record, pigment, map);
    else if (pigment->kind == PIGMENT_PATTERN)
        put_pattern(record, pigment, map);
    else if (pigment->kind == PIGMENT_IMAGE)
        put_image(record, pigment, map);
    else
        record_numbers(record, "P_PATTERN", &pigment->to_local.rows[0][0], 12);
    record_integer(record, "P_CLEAR", pigment_is_clear(pigment));
    record_numbers(record, "P_TRANSMITTED", &passing[0][0], 8);
    put_finish(record, scene, &primitive->finish,
               metal ? surface_opacity(pigment, 0) : 1);
    put_gloss(record, &primitive->finish);
}

static void put_interior(struct record *record, const struct interiors *interiors,
                         const struct primitive *primitive)
{
    double number = (double)interiors_number(interiors, primitive);
    if (object_symbol(record->layout->program, "P_INTERIOR"))
        record_numbers(record, "P_INTERIOR", &number, 1);
}

/* The state while ranks are assigned. Each region with a transparent part gets a rank,
 * which orders its faces among coincident faces (docs/solids.md). */
struct clear_ranks {
    size_t region; /* the next region */
    size_t end;    /* end of the previous region's primitives */
    size_t rank;   /* rank of the previous region, or 0 */
    double yield;  /* yield of opaque surfaces of the previous region */
    size_t used, count;
};

static bool has_clear_part(const struct scene *scene, const struct region *region)
{
    for (size_t i = 0; i < region->primitive_count; i++)
        if (pigment_is_clear(&scene->primitives[region->first_primitive + i].pigment))
            return true;
    return false;
}

static struct clear_ranks ranks_of(const struct scene *scene)
{
    struct clear_ranks ranks = { .count = 0 };
    for (size_t i = 0; i < scene->region_count; i++)
        ranks.count += has_clear_part(scene, &scene->regions[i]);
    return ranks;
}

/* Writes the rank and the tie offset of primitive i, which order coincident faces. Must
 * be called for all primitives in ascending order, which is the order of their
 * regions. */
static void put_rank(struct record *record, const struct scene *scene, size_t i,
                     struct clear_ranks *ranks)
{
    double yield;
    if (!object_symbol(record->layout->program, "P_TIE_OFFSET"))
        return;
    if (i == ranks->end) {
        const struct region *region = &scene->regions[ranks->region++];
        ranks->end += region->primitive_count;
        ranks->rank = has_clear_part(scene, region) ? ++ranks->used : 0;
        ranks->yield = region->yield;
    }
    yield = pigment_is_clear(&scene->primitives[i].pigment)
                ? 2 - (double)ranks->rank / (double)ranks->count
                : ranks->yield;
    if (object_symbol(record->layout->program, "P_RANK"))
        record_integer(record, "P_RANK", ranks->rank);
    record_numbers(record, "P_TIE_OFFSET", &yield, 1);
}

static void put_mirror(struct record *record, const struct primitive *primitive)
{
    const double index[2] = { primitive->ior, 1 / primitive->ior };
    double words[4];
    memcpy(words, primitive->finish.reflection, 3 * sizeof *words);
    words[3] = fmax(greatest_of(words), greatest_of(primitive->finish.reflection_most));
    record_integer(record, "P_MIRROR", surface_is_mirror(&primitive->finish));
    record_numbers(record, "P_REFLECTION", words, 4);
    record_numbers(record, "P_INDEX", index, 2);
}

static size_t table_words(const struct scene *scene, const struct leaf_plan *plans,
                          const struct viewpoints *viewpoints)
{
    const struct pigment *before = NULL;
    size_t count = 0;
    for (size_t i = 0; i < scene->primitive_count; i++) {
        const struct pigment *pigment = &scene->primitives[i].pigment;
        count += shape_table_count(&scene->primitives[i],
                                   plans[i].simple ? viewpoints : NULL);
        if (!pigment_has_map(pigment) || (before && has_stops_of(pigment, before)))
            continue;
        before = pigment;
        count += stops_size(pigment);
    }
    return count;
}

/* Returns the address of the primitive's material. Spheres in world space with equal
 * surfaces share a material; every other primitive has its own material. */
static uint64_t material_of(struct record *record, const struct primitive *primitive,
                            struct material_table *materials)
{
    static const struct {
        const char *field;
        size_t count; /* number of words */
    } fields[] = {
        { "P_PIGMENT", 1 }, { "P_COLOR", 6 },    { "P_PATTERN", 12 },
        { "P_FINISH", 8 },  { "P_INVERTED", 9 }, { "P_TRANSMITTED", 8 },
        { "P_GLOSS", 8 },   { "P_MAP", 8 },      { "P_INTERIOR", 1 },
        { "P_BUMP", 1 },
    };
    c205_word words[MATERIAL_WORDS] = { 0 }, transformed = 0;
    size_t at = 0;
    uint64_t material;
    record_read(record, "P_TRANSFORMED", &transformed, 1);
    if (primitive->kind != PRIMITIVE_SPHERE || transformed != 0)
        return record->address;
    for (size_t i = 0; i < sizeof fields / sizeof *fields; at += fields[i++].count)
        if (object_symbol(record->layout->program, fields[i].field)
            && (strcmp(fields[i].field, "P_PATTERN") != 0 || words[0] != 0))
            record_read(record, fields[i].field, &words[at], fields[i].count);
    material = materials_first(materials, words, record->address);
    if (material == 0)
        layout_fail(record->layout, "out of memory");
    return material;
}

/* Writes the addresses at which the kernels store the crossings of a primitive and its
 * value in the tree. */
static void put_part(struct record *record, const struct leaf_plan *plan,
                     const struct row *crossings, const struct row *values)
{
    record_address(record, "P_FIRST_STATE", row_at(crossings, plan->first_state));
    record_address(record, "P_FIRST_EVENT", row_at(crossings, plan->first_event));
    record_address(record, "P_VALUE", row_at(values, plan->value));
}

static struct row
layout_primitives(struct record_layout *layout, const struct scene *scene,
                  const struct leaf_plan *plans, const struct interiors *interiors,
                  const uint64_t *images, const uint64_t *bumps,
                  const struct row *crossings, const struct row *values,
                  const struct viewpoints *viewpoints)
{
    struct material_table *materials = materials_new(scene->primitive_count);
    bool alike = false;
    struct record record;
    struct map_place map = { NULL, 0, images };
    struct clear_ranks ranks = ranks_of(scene);
    size_t space = 0;
    struct row row;
    uint64_t material;
    if (!materials)
        layout_fail(layout, "out of memory");
    record_begin(&record, layout, "P_SIZE", scene->primitive_count,
                 table_words(scene, plans, viewpoints));
    row = record_row(&record);
    for (size_t i = 0; i < scene->primitive_count && !layout->failed; i++) {
        record.line = scene->primitives[i].line;
        space = space_of(scene, i, space);
        record_integer(&record, "P_ID", i + 1);
        record_integer(&record, "P_SPACE", space);
        if (object_symbol(layout->program, "P_OBJECT"))
            record_integer(&record, "P_OBJECT", scene->primitives[i].object);
        put_shape(&record, &scene->primitives[i], &plans[i], viewpoints);
        put_part(&record, &plans[i], crossings, values);
        put_surface(&record, scene, &scene->primitives[i], &map);
        put_mirror(&record, &scene->primitives[i]);
        put_interior(&record, interiors, &scene->primitives[i]);
        put_rank(&record, scene, i, &ranks);
        if (bumps[i] != 0)
            record_address(&record, "P_BUMP", bumps[i]);
        material = material_of(&record, &scene->primitives[i], materials);
        alike = alike || material != record.address;
        record_address(&record, "P_MATERIAL", material);
        record_write(&record);
    }
    record_end(&record);
    materials_free(materials);
    layout_word(layout, "scene_shared_materials", alike);
    layout_word(layout, "scene_primitives", row.first);
    layout_word(layout, "scene_primitive_count",
                c205_from_integer((int64_t)scene->primitive_count));
    return row;
}

/* Reserves the memory in which the kernels evaluate a tree: the values, and the lists
 * of leaves and branches. The kernels may write one unused entry after the end of a
 * list. */
static struct row layout_values(struct record_layout *layout, const struct scene *scene)
{
    size_t most = most_leaves(scene);
    struct row values, leaves, branches;
    const struct row_wanted wanted[] = {
        { &values, "VALUE_SIZE", 2 * most - 1 },
        { &leaves, "LEAF_SIZE", most },
        { &branches, "BRANCH_SIZE", most },
    };
    layout_reserve_rows(layout, wanted, sizeof wanted / sizeof *wanted);
    layout_word(layout, "scene_leaves", leaves.first);
    layout_word(layout, "scene_branches", branches.first);
    return values;
}

void layout_solids(struct record_layout *layout, const struct scene *scene,
                   const struct interiors *interiors, const uint64_t *images,
                   const struct viewpoints *viewpoints, enum bounding bounding)
{
    struct leaf_plan *plans = calloc(scene->primitive_count + 1, sizeof *plans);
    uint64_t *bumps = calloc(scene->primitive_count + 1, sizeof *bumps);
    struct region_places places;
    struct row crossings;
    if (!plans || !bumps) {
        layout_fail(layout, "out of memory");
        free(plans);
        free(bumps);
        return;
    }
    layout_bumps(layout, scene, bumps);
    layout_reserve_rows(layout,
                        &(struct row_wanted){ &crossings, "CROSSING_SIZE",
                                              plan_leaves(scene, plans) },
                        1);
    places.values = layout_values(layout, scene);
    places.primitives = layout_primitives(layout, scene, plans, interiors, images,
                                          bumps, &crossings, &places.values,
                                          viewpoints);
    layout_regions(layout, scene, bounding, &places);
    free(plans);
    free(bumps);
}
