/* bumps.c - writes bump maps and other changes of normals as records. */
#include "rt/layout/bumps.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "rt/layout/pigment.h"
#include "rt/scene/transform.h"
#include "rt/scene/vector3.h"
#include "rt/shapes/primitive.h"

enum { CORNERS = 4, CORNER_WORDS = 6, HEIGHT_SIZE = 6 };
#define BEYOND 4e30 /* greater than `big` of the kernels */
#define STEP 1e-30  /* a smaller distance counts as 0 */

/* The directions in which POV-Ray samples heights for a normal: the corners of a
 * tetrahedron, with POV-Ray's digits. */
static const double corners[CORNERS][3] = {
    { .942809041, -.333333333, 0 },
    { -.471404521, -.333333333, .816496581 },
    { -.471404521, -.333333333, -.816496581 },
    { 0, 1, 0 },
};

bool scene_has_bumps(const struct scene *scene)
{
    for (size_t i = 0; i < scene->primitive_count; i++)
        if (bumps_show(&scene->primitives[i].bumps))
            return true;
    return false;
}

static bool have_one_record(const struct bumps *a, const struct bumps *b)
{
    return a->list == b->list && a->unscaled == b->unscaled
           && !memcmp(&a->to_local, &b->to_local, sizeof a->to_local);
}

static bool is_quilted(const struct bump *bump)
{
    return bump->pattern.kind == PIGMENT_PATTERN
           && bump->pattern.pattern.function == PATTERN_QUILTED;
}

/* ---- Heights ------------------------------------------------------------- */

/* Returns the number of rows of heights. A list has one row for each entry. A map has
 * an additional row before its first entry. */
static size_t height_rows(const struct bump *bump)
{
    size_t listed = pigment_list_count(&bump->pattern);
    if (listed > 0)
        return listed;
    return bump->stop_count > 0 ? bump->stop_count + 1 : 0;
}

static size_t height_words(const struct bump *bump)
{
    size_t rows = height_rows(bump);
    return rows > 0 ? (rows + 1) * HEIGHT_SIZE : 0;
}

static void put_level(double at, double height, double row[HEIGHT_SIZE])
{
    memset(row, 0, HEIGHT_SIZE * sizeof *row);
    row[0] = at;
    row[2] = height;
}

static void put_slope(const struct slope_stop *stop, const struct slope_stop *next,
                      double row[HEIGHT_SIZE])
{
    double far = next->at - stop->at, rise = next->height - stop->height;
    put_level(stop->at, stop->height, row);
    if (far <= STEP)
        return;
    row[1] = 1 / far;
    row[3] = stop->slope;
    row[4] = 3 * rise - 2 * stop->slope - next->slope;
    row[5] = stop->slope + next->slope - 2 * rise;
}

/* Writes the heights of a list. The kernels assign equally spaced values from 0 to 1 to
 * the entries of the list. */
static void put_listed(const struct bump *bump, size_t count,
                       double rows[][HEIGHT_SIZE])
{
    for (size_t i = 0; i < count; i++)
        put_level(((double)i - .5) / ((double)count - 1),
                  pigment_list_value(&bump->pattern, i), rows[i]);
}

static void put_slopes(const struct bump *bump, double rows[][HEIGHT_SIZE])
{
    const struct slope_stop *stops = bump->stops;
    size_t last = bump->stop_count - 1;
    put_level(-1, stops[0].height, rows[0]);
    for (size_t i = 0; i <= last; i++)
        put_slope(&stops[i], &stops[i < last ? i + 1 : i], rows[i + 1]);
}

static void put_heights(struct record *record, const struct bump *bump)
{
    size_t count = height_rows(bump), size = height_words(bump);
    double(*rows)[HEIGHT_SIZE] = calloc(count + 1, sizeof *rows);
    c205_word *words = calloc(size + 1, sizeof *words);

    if (!rows || !words) {
        layout_fail(record->layout, "out of memory");
    } else if (size > 0) {
        if (pigment_list_count(&bump->pattern) > 0)
            put_listed(bump, count, rows);
        else
            put_slopes(bump, rows);
        put_level(BEYOND, 0, rows[count]);
        record_check(record, rows[0], size);
        put_numbers(words, rows[0], size);
        record_table(record, "BUMP_HEIGHTS", words, size);
    }
    free(rows);
    free(words);
}

/* ---- Spaces -------------------------------------------------------------- */

/* Writes the pattern of a bump: its space, its routines, their parameters and its
 * heights. */
static void put_pattern(struct record *record, const struct bump *bump,
                        const struct transform *to_local)
{
    struct pigment pattern = bump->pattern;
    const char *wave = pattern_wave(&pattern);
    double rows[PATTERN_ROWS], numbers[MAP_NUMBERS];
    pattern.to_local = *to_local;
    pattern_rows(&pattern, rows);
    pattern_numbers(&pattern.pattern, numbers);
    record_numbers(record, "BUMP_TO_LOCAL", rows, PATTERN_ROWS);
    record_routine(record, "BUMP_FUNCTION",
                   pattern_rules[pattern.pattern.function].routine);
    if (wave)
        record_routine(record, "BUMP_WAVE", wave);
    record_numbers(record, "BUMP_NUMBERS", numbers, MAP_NUMBERS);
    put_heights(record, bump);
}

/* Writes a quilt, whose height depends on the distance from the centre of a cube. The
 * constant has the digits of POV-Ray's constant. */
static void put_quilt(struct record *record, const struct bump *bump)
{
    double scale = 1.154700538 * bump->amount;
    double first = 3 * bump->controls[0], second = 3 * bump->controls[1];
    double words[3] = { first, second - 2 * first, 1 + first - second };
    scale3(scale, words);
    record_numbers(record, "BUMP_CORNERS", words, 3);
}

static void put_corners(struct record *record, const struct bump *bump)
{
    const struct pigment *pattern = &bump->pattern;
    bool gradient = pattern->pattern.function == PATTERN_GRADIENT;
    bool flat = pattern->kind == PIGMENT_COLOR;
    double push = flat ? 0 : -5 * bump->amount * .02 / bump->accuracy;
    double words[CORNERS * CORNER_WORDS] = { 0 };
    for (int i = 0; i < CORNERS; i++) {
        double *word = words + CORNER_WORDS * i;
        if (gradient)
            word[0] = dot3(corners[i], pattern->axis);
        else
            copy3(corners[i], word);
        scale3(bump->accuracy, word);
        copy3(corners[i], word + 3);
        scale3(push, word + 3);
    }
    record_numbers(record, "BUMP_CORNERS", words, CORNERS * CORNER_WORDS);
}

/* Writes the transposed linear part of a map to the field. */
static void put_back(struct record *record, const struct transform *map,
                     const char *field)
{
    double words[9];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            words[3 * i + j] = map->rows[j][i];
    record_numbers(record, field, words, 9);
}

/* Writes the transposed linear part of the map from local to world space, multiplied by
 * `length`. */
static void put_carry(struct record *record, const struct transform *to_local,
                      double length)
{
    struct transform to_world;
    if (transform_invert(to_local, &to_world)) {
        for (int i = 0; i < 3; i++)
            scale3(length, to_world.rows[i]);
        put_back(record, &to_world, "BUMP_TRANSFORM");
    } else {
        layout_fail(record->layout, "the normal of line %zu is out of range",
                    record->line);
    }
}

/* Writes a bump. `to_local` maps points to the space of the bump. If `around` is not
 * NULL, the bump belongs to a map, and `around` first maps the points to the space of
 * this map. If `unscaled` is true, the length of a normal matters, and lengths are in
 * the unit of the scene file. */
static void put_bump(struct record *record, const struct bump *bump,
                     const struct transform *around, const struct transform *to_local,
                     bool unscaled, double unit)
{
    struct transform whole = around ? transform_then(around, to_local) : *to_local;
    if (is_quilted(bump)) {
        record_numbers(record, "BUMP_TO_LOCAL", &whole.rows[0][0], 12);
        put_quilt(record, bump);
    } else {
        put_pattern(record, bump, &whole);
        put_corners(record, bump);
    }
    put_carry(record, &whole, unscaled ? unit : 1);
    put_back(record, to_local, "BUMP_BACK");
    record_integer(record, "BUMP_SCALED", !unscaled);
    record_integer(record, "BUMP_NORMALISED", !unscaled || !around);
}

/* ---- Maps ---------------------------------------------------------------- */

/* Returns the number of entries that are written. The kernels choose between two
 * entries, so a single entry is written twice. */
static size_t entry_rows(const struct bump_list *list)
{
    return list->count == 1 ? 2 : list->count;
}

static const struct bump_entry *entry_of(const struct bump_list *list, size_t row)
{
    return &list->entries[row < list->count ? row : list->count - 1];
}

/* Writes the range of map values for which entry i has weight. Between BUMP_FROM and
 * BUMP_TO the entry is the upper one of the two that are mixed, and above BUMP_TO the
 * lower one. The first entry is always the lower one, and the last is always the upper
 * one; their ranges are unbounded. */
static void put_share(struct record *record, const struct bump_list *list, size_t i)
{
    size_t last = entry_rows(list) - 1;
    double at = entry_of(list, i)->at;
    double from = i > 1 ? entry_of(list, i - 1)->at : i == 1 ? -BEYOND : BEYOND;
    double to = i == 0 ? -BEYOND : i < last ? at : BEYOND;
    double far = entry_of(list, i + 1)->at - at;
    double rise = list->average ? at : far > STEP ? 1 / far : BEYOND;
    record_numbers(record, "BUMP_FROM", &from, 1);
    record_numbers(record, "BUMP_TO", &to, 1);
    record_numbers(record, "BUMP_LOW", &at, 1);
    record_numbers(record, "BUMP_RISE", &rise, 1);
}

static void put_entries(struct record *record, const struct bumps *bumps,
                        const struct bump_list *list, double unit)
{
    for (size_t i = 0; i < entry_rows(list); i++) {
        const struct bump *bump = &entry_of(list, i)->bump;
        put_bump(record, bump, &bumps->to_local, &bump->pattern.to_local,
                 bumps->unscaled, unit);
        put_share(record, list, i);
        record_write(record);
    }
}

static void put_map(struct record *record, const struct bumps *bumps, double unit)
{
    const struct bump_list *list = bumps->list;
    put_back(record, &bumps->to_local, "BUMP_BACK");
    if (!list->average)
        put_pattern(record, &list->bump, &bumps->to_local);
    record_address(record, "BUMP_ENTRIES",
                   record->address + UINT64_C(64) * record->size);
    record_integer(record, "BUMP_ENTRY_COUNT", entry_rows(list));
    record_write(record);
    put_entries(record, bumps, list, unit);
}

static void put_bumps(struct record *record, const struct bumps *bumps, double unit)
{
    const struct bump_list *list = bumps->list;
    if (list->count > 0) {
        put_map(record, bumps, unit);
        return;
    }
    put_bump(record, &list->bump, NULL, &bumps->to_local, bumps->unscaled, unit);
    record_write(record);
}

/* ---- The whole scene ----------------------------------------------------- */

/* Counts the records of bumps, and the words of their height tables. Consecutive equal
 * bumps are counted once. */
static void count_bumps(const struct scene *scene, size_t *records, size_t *words)
{
    const struct bumps *before = NULL;
    *records = *words = 0;
    for (size_t i = 0; i < scene->primitive_count; i++) {
        const struct bumps *bumps = &scene->primitives[i].bumps;
        if (!bumps_show(bumps) || (before && have_one_record(bumps, before)))
            continue;
        before = bumps;
        *records += 1 + entry_rows(bumps->list);
        *words += height_words(&bumps->list->bump);
        for (size_t k = 0; k < entry_rows(bumps->list); k++)
            *words += height_words(&entry_of(bumps->list, k)->bump);
    }
}

void layout_bumps(struct record_layout *layout, const struct scene *scene,
                  uint64_t *addresses)
{
    const struct bumps *before = NULL;
    size_t records, words;
    uint64_t address = 0;
    struct record record;
    count_bumps(scene, &records, &words);
    if (records == 0)
        return;
    record_begin(&record, layout, "BUMP_SIZE", records, words);
    for (size_t i = 0; i < scene->primitive_count && !layout->failed; i++) {
        const struct bumps *bumps = &scene->primitives[i].bumps;
        if (!bumps_show(bumps))
            continue;
        record.line = scene->primitives[i].line;
        if (!before || !have_one_record(bumps, before)) {
            before = bumps;
            address = record.address;
            put_bumps(&record, bumps, ldexp(1, scene->unit_log));
        }
        addresses[i] = address;
    }
    record_end(&record);
}
