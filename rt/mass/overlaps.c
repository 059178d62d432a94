/* overlaps.c - lists the parts that may overlap, and writes their tables. */
#include "rt/mass/overlaps.h"

#include <math.h>
#include <stdlib.h>

#include "base/array.h"
#include "rt/layout/bounds.h"

/* ---- Objects and their boxes --------------------------------------------- */

/* The boxes of the objects and parts of a scene, and the objects with bodies, grouped
 * by part. */
struct boxes {
    struct bound *of_objects; /* an empty box for objects without a body */
    struct bound *of_parts;
    size_t *first; /* for each part: index of its first object in `list`; then the end
                    * of the list */
    size_t *list;  /* indices of objects */
};

static const struct bound empty = { .low = { INFINITY, INFINITY, INFINITY },
                                    .high = { -INFINITY, -INFINITY, -INFINITY } };

static void join_bounds(struct bound *bound, const struct bound *more)
{
    for (int i = 0; i < 3; i++) {
        bound->low[i] = fmin(bound->low[i], more->low[i]);
        bound->high[i] = fmax(bound->high[i], more->high[i]);
    }
}

static bool meet(const struct bound *one, const struct bound *other)
{
    bool good = true;
    for (int i = 0; i < 3; i++)
        good = good && one->low[i] <= other->high[i] && other->low[i] <= one->high[i];
    return good;
}

static bool has_body(const struct bound *bound)
{
    return bound->low[0] <= bound->high[0];
}

static bool box_objects(const struct scene *scene, struct bound *boxes)
{
    struct bound *bounds = calloc(scene->node_count + 1, sizeof *bounds);
    bool good = bounds && bound_nodes(scene, bounds);
    for (size_t i = 0; i < scene->object_count; i++)
        boxes[i] = empty;
    for (size_t i = 0; good && i < scene->region_count; i++) {
        const struct region *region = &scene->regions[i];
        join_bounds(&boxes[scene->primitives[region->first_primitive].object],
                    &bounds[region->first_node]);
    }
    free(bounds);
    return good;
}

/* Groups the objects by part, with a counting sort. */
static void list_objects(const struct scene *scene, const size_t *part_of,
                         struct overlaps *overlaps, struct boxes *boxes)
{
    size_t count = overlaps->part_count;
    for (size_t i = 0; i < count; i++)
        boxes->of_parts[i] = empty;
    for (size_t i = 0; i < scene->object_count; i++)
        if (has_body(&boxes->of_objects[i])) {
            overlaps->objects[part_of[i]]++;
            join_bounds(&boxes->of_parts[part_of[i]], &boxes->of_objects[i]);
        }
    for (size_t i = 0; i < count; i++)
        boxes->first[i + 1] = boxes->first[i] + overlaps->objects[i];
    for (size_t i = scene->object_count; i-- > 0;)
        if (has_body(&boxes->of_objects[i]))
            boxes->list[--boxes->first[part_of[i] + 1]] = i;
    for (size_t i = 0; i < count; i++)
        boxes->first[i] = boxes->first[i + 1];
    boxes->first[count] = count > 0
                              ? boxes->first[count - 1] + overlaps->objects[count - 1]
                              : 0;
}

static bool find_boxes(const struct scene *scene, const size_t *part_of,
                       struct overlaps *overlaps, struct boxes *boxes)
{
    size_t objects = scene->object_count + 1, parts = overlaps->part_count;
    boxes->of_objects = calloc(objects, sizeof *boxes->of_objects);
    boxes->of_parts = calloc(parts + 1, sizeof *boxes->of_parts);
    boxes->first = calloc(parts + 1, sizeof *boxes->first);
    boxes->list = calloc(objects, sizeof *boxes->list);
    if (!boxes->of_objects || !boxes->of_parts || !boxes->first || !boxes->list
        || !box_objects(scene, boxes->of_objects))
        return false;
    list_objects(scene, part_of, overlaps, boxes);
    return true;
}

static void free_boxes(struct boxes *boxes)
{
    free(boxes->of_objects);
    free(boxes->of_parts);
    free(boxes->first);
    free(boxes->list);
}

/* ---- Pairs --------------------------------------------------------------- */

/* Returns true if an object of one part may overlap an object of the other part. */
static bool may_overlap(const struct boxes *boxes, size_t one, size_t other)
{
    if (!meet(&boxes->of_parts[one], &boxes->of_parts[other]))
        return false;
    for (size_t i = boxes->first[one]; i < boxes->first[one + 1]; i++)
        for (size_t k = one == other ? i + 1 : boxes->first[other];
             k < boxes->first[other + 1]; k++)
            if (meet(&boxes->of_objects[boxes->list[i]],
                     &boxes->of_objects[boxes->list[k]]))
                return true;
    return false;
}

static bool add_pair(struct overlaps *overlaps, size_t one, size_t other)
{
    struct overlap_pair pair = { { one, other } };
    return array_add(&overlaps->pairs, &overlaps->count, &pair, sizeof pair);
}

bool overlaps_find(const struct scene *scene, const size_t *part_of, size_t part_count,
                   struct overlaps *overlaps)
{
    struct boxes boxes = { NULL, NULL, NULL, NULL };
    bool good;
    *overlaps = (struct overlaps){ .part_count = part_count };
    overlaps->objects = calloc(part_count + 1, sizeof *overlaps->objects);
    good = overlaps->objects && find_boxes(scene, part_of, overlaps, &boxes);
    for (size_t i = 0; good && i < part_count; i++)
        for (size_t k = i; good && k < part_count; k++)
            if (may_overlap(&boxes, i, k))
                good = add_pair(overlaps, i, k);
    free_boxes(&boxes);
    if (!good)
        overlaps_free(overlaps);
    return good;
}

void overlaps_free(struct overlaps *overlaps)
{
    free(overlaps->pairs);
    free(overlaps->objects);
    *overlaps = (struct overlaps){ 0 };
}

/* ---- The machine's tables ------------------------------------------------ */

/* The number of bits in the word of a group, and the largest number of levels of a
 * part, as in overlaps.s. */
enum { GROUP_BITS = 47, LEVELS_OF_PART = 2 };

struct part_field {
    size_t group, shift, width; /* width 0: the part is in no pair */
    /* The part's range in the table of levels. A level that no pair uses is not in the
     * table. */
    size_t first_level, level_count;
    bool asked[LEVELS_OF_PART];
};

struct tables {
    const struct overlaps *overlaps;
    struct record_layout *layout;
    struct part_field *fields; /* one field for each part */
    c205_word *words;          /* buffer for tables */
    size_t group_count, level_count;
    struct row levels;
};

static size_t bits_for(size_t most)
{
    size_t bits = 1;
    while (most >> bits)
        bits++;
    return bits;
}

/* Returns true for a pair of a part with itself. Such a pair uses the second level of
 * the part. */
static bool is_own(const struct overlap_pair *pair)
{
    return pair->parts[0] == pair->parts[1];
}

/* Assigns a bit field and levels (overlaps.s) to a part. The field contains the number
 * of the part's objects that contain the ray, and is wide enough for all of them, so it
 * never overflows. The fields of several parts share the word of a group, so one
 * addition updates all of them. */
static void place_field(struct tables *tables, struct part_field *field, size_t objects,
                        size_t *end)
{
    field->first_level = tables->level_count;
    for (size_t k = 0; k < LEVELS_OF_PART; k++)
        field->level_count += field->asked[k];
    if (field->level_count == 0)
        return;
    tables->level_count += field->level_count;
    field->width = bits_for(objects);
    if (tables->group_count == 0 || *end + field->width > GROUP_BITS) {
        tables->group_count++;
        *end = 0;
    }
    field->group = tables->group_count - 1;
    field->shift = *end;
    *end += field->width;
}

static void place_fields(struct tables *tables)
{
    const struct overlaps *overlaps = tables->overlaps;
    size_t end = 0;
    for (size_t i = 0; i < overlaps->count; i++)
        for (size_t k = 0; k < 2; k++) {
            const struct overlap_pair *pair = &overlaps->pairs[i];
            tables->fields[pair->parts[k]].asked[is_own(pair)] = true;
        }
    for (size_t i = 0; i < overlaps->part_count; i++)
        place_field(tables, &tables->fields[i], overlaps->objects[i], &end);
}

static size_t level_of(const struct tables *tables, size_t part, bool own)
{
    const struct part_field *field = &tables->fields[part];
    return field->first_level + (own && field->asked[0]);
}

static void give_groups(struct tables *tables)
{
    size_t parts = tables->overlaps->part_count;
    struct record record;
    record_begin(&record, tables->layout, "GROUP_SIZE", tables->group_count,
                 tables->group_count * parts);
    layout_word(tables->layout, "overlap_group", record_row(&record).first);
    for (size_t group = 0; group < tables->group_count; group++) {
        size_t levels = 0;
        for (size_t i = 0; i < parts; i++) {
            const struct part_field *field = &tables->fields[i];
            bool there = field->width > 0 && field->group == group;
            tables->words[i] = c205_from_integer(there ? (int64_t)1 << field->shift
                                                       : 0);
            levels += there ? field->level_count : 0;
        }
        record_table(&record, "GROUP_STEPS", tables->words, parts);
        record_integer(&record, "GROUP_LEVELS", levels);
        record_write(&record);
    }
    record_end(&record);
}

/* Lists the pairs that contain a level of the part: its second level if `own` is true,
 * else its first level. Each entry has the address of the other level and the number of
 * the pair. Returns the number of entries. */
static size_t list_partners(struct tables *tables, size_t part, bool own)
{
    const struct overlaps *overlaps = tables->overlaps;
    size_t count = 0;
    for (size_t i = 0; i < overlaps->count; i++) {
        const struct overlap_pair *pair = &overlaps->pairs[i];
        size_t other = pair->parts[pair->parts[0] == part];
        if (is_own(pair) != own || (pair->parts[0] != part && pair->parts[1] != part))
            continue;
        tables->words[2 * count] = row_at(&tables->levels,
                                          level_of(tables, other, own));
        tables->words[2 * count + 1] = c205_from_integer((int64_t)i);
        count++;
    }
    return count;
}

static void give_level(struct tables *tables, struct record *record, size_t part,
                       bool own)
{
    const struct part_field *field = &tables->fields[part];
    size_t least = own ? 2 : 1, mask = ((size_t)1 << field->width) - 1;
    size_t partners = list_partners(tables, part, own);
    record_integer(record, "LEVEL_MASK", mask << field->shift);
    record_integer(record, "LEVEL_REACHED", least << field->shift);
    record_integer(record, "LEVEL_MIN", least);
    record_integer(record, "LEVEL_ON", 0);
    record_table(record, "LEVEL_PARTNERS", tables->words, 2 * partners);
    record_integer(record, "LEVEL_PAIRS", partners);
    record_write(record);
}

static void give_levels(struct tables *tables)
{
    const struct overlaps *overlaps = tables->overlaps;
    struct record record;
    record_begin(&record, tables->layout, "LEVEL_SIZE", tables->level_count,
                 4 * overlaps->count);
    tables->levels = record_row(&record);
    layout_word(tables->layout, "overlap_levels", tables->levels.first);
    for (size_t i = 0; i < overlaps->part_count; i++)
        for (size_t k = 0; k < LEVELS_OF_PART; k++)
            if (tables->fields[i].asked[k])
                give_level(tables, &record, i, k > 0);
    record_end(&record);
}

static void give_pairs(struct tables *tables)
{
    const struct overlaps *overlaps = tables->overlaps;
    for (size_t i = 0; i < overlaps->count; i++)
        for (size_t k = 0; k < 2; k++) {
            const struct overlap_pair *pair = &overlaps->pairs[i];
            tables->words[2 * i + k] = c205_from_integer(
                (int64_t)level_of(tables, pair->parts[k], is_own(pair)));
        }
}

static void give_parts(struct tables *tables)
{
    struct record record;
    record_begin(&record, tables->layout, "PART_SIZE", tables->overlaps->part_count, 0);
    layout_word(tables->layout, "overlap_parts", record_row(&record).first);
    for (size_t i = 0; i < tables->overlaps->part_count; i++) {
        const struct part_field *field = &tables->fields[i];
        record_address(&record, "PART_LEVELS",
                       row_at(&tables->levels, field->first_level));
        record_integer(&record, "PART_LEVEL_COUNT", field->level_count);
        record_integer(&record, "PART_COUNT", 0);
        record_write(&record);
    }
    record_end(&record);
}

static void give_tables(struct tables *tables, struct single_run *run)
{
    size_t bits;
    place_fields(tables);
    give_groups(tables);
    give_levels(tables);
    give_pairs(tables);
    single_run_room(run, "overlap_pairs", tables->words, 2 * tables->overlaps->count);
    give_parts(tables);
    single_run_word(run, "overlap_groups", tables->group_count);
    single_run_room(run, "overlap_carries", NULL, tables->group_count);
    bits = (size_t)layout_symbol(&run->layout, "LEVEL_BITS");
    single_run_room(run, "overlap_bits", NULL, tables->level_count * bits / 64);
}

void overlaps_give(const struct overlaps *overlaps, struct single_run *run)
{
    size_t words = 2 * overlaps->count + overlaps->part_count;
    struct tables tables = {
        .overlaps = overlaps,
        .layout = &run->layout,
        .fields = calloc(overlaps->part_count + 1, sizeof *tables.fields),
        .words = calloc(words + 1, sizeof *tables.words),
    };
    if (tables.fields && tables.words)
        give_tables(&tables, run);
    else
        layout_fail(&run->layout, "out of memory");
    free(tables.fields);
    free(tables.words);
}
