/* normal.c - parses normals, which are bumps by patterns without noise, and their
 * modifiers. */
#include "rt/scene/language/scene_expression.h"
#include "rt/scene/language/pattern.h"

#include <string.h>

/* POV-Ray's defaults; without a pattern there are no bumps. */
static const struct bump bump_default = {
    .pattern = { .kind = PIGMENT_COLOR, .pattern = { .frequency = 1, .exponent = 1 } },
    .amount = .5,
    .accuracy = .02,
};

void normal_begin(struct normal_reading *reading, const struct bumps *bumps)
{
    memset(reading, 0, sizeof *reading);
    reading->list.bump = bump_default;
    if (bumps->list)
        reading->list = *bumps->list;
    reading->list.bump.pattern.to_local = bumps->to_local;
    reading->unscaled = bumps->unscaled;
}

/* Reads the optional bump size after the pattern of a normal. */
static bool read_amount(struct reader *reader, struct normal_reading *reading)
{
    reader_comma(reader);
    return !starts_expression(reader)
           || read_number(reader, &reading->list.bump.amount);
}

/* Reads the pattern of a normal. A pattern with a list, such as checker, may have one
 * normal for each kind of its cells. If it has no normals, the heights of the cells are
 * their indices in the list. */
static bool read_function(struct reader *reader, const struct item *item)
{
    struct normal_reading *reading = item->subject;
    struct bump_list *list = &reading->list;
    struct bump *bump = &list->bump;
    size_t count;
    if (item->keyword->detail == PATTERN_GRADIENT
        && !gradient_pattern_read(reader, item))
        return false;
    pattern_begin(&bump->pattern, (enum pattern_function)item->keyword->detail);
    list->average = false;
    if (item->keyword->detail == PATTERN_QUILTED) {
        bump->pattern.pattern.frequency = 0;
        bump->controls[0] = bump->controls[1] = 1;
    }
    count = pigment_list_count(&bump->pattern);
    if (count > 0) {
        bump->pattern.pattern.frequency = 0;
        bump->accuracy = bump_default.accuracy;
        bump->stop_count = list->count = 0;
        if (!normal_list_read(reader, reading, count))
            return false;
    }
    return read_amount(reader, reading);
}

static bool read_average(struct reader *reader, const struct item *item)
{
    struct normal_reading *reading = item->subject;
    bool good = read_function(reader, item);
    reading->list.average = true;
    return good;
}

/* Removes the maps of a quilted normal, which has no values to which maps apply. */
static void finish_quilted(struct reader *reader, struct bump_list *list,
                           const struct scene_token *at)
{
    if (list->bump.pattern.kind != PIGMENT_PATTERN
        || list->bump.pattern.pattern.function != PATTERN_QUILTED)
        return;
    list->bump.stop_count = 0;
    if (list->count == 0)
        return;
    reader_report(reader, at, "the 'normal_map' of a quilted normal is ignored");
    list->count = 0;
}

/* Skips a normal whose pattern is not supported, and makes it a normal without effect.
 * As an entry of a map it still needs a valid pattern function. */
static bool read_unsupported(struct reader *reader, const struct item *item)
{
    struct normal_reading *reading = item->subject;
    struct bump_list *list = &reading->list;
    reader_report(reader, &item->at,
                  "a normal of the pattern '%.*s' is not supported and is ignored",
                  ITEM_WORD(item));
    list->bump.pattern.kind = PIGMENT_COLOR;
    list->bump.pattern.pattern.function = PATTERN_PLANAR;
    list->average = false;
    list->bump.stop_count = list->count = 0;
    block_pass(reader, reading->block);
    return true;
}

static bool read_accuracy(struct reader *reader, const struct item *item)
{
    const double *accuracy = item_member(item);
    return item_number(reader, item)
           && (*accuracy != 0
               || reader_fault(reader, &item->at, "the accuracy must not be 0"));
}

#define OF(member) offsetof(struct normal_reading, member)

static const struct keyword words[] = {
#define PATTERN(KIND, name, ...) { #name, read_function, PATTERN_##KIND },
#include "rt/scene/patterns.def"
    { "average", read_average, PATTERN_PLANAR },
    { "bump_map " UNSUPPORTED_PATTERNS, read_unsupported, 0 },
    { "accuracy", read_accuracy, OF(list.bump.accuracy) },
    { "bump_size", item_number, OF(list.bump.amount) },
    { "control0", item_number, OF(list.bump.controls[0]) },
    { "control1", item_number, OF(list.bump.controls[1]) },
    { "no_bump_scale", item_flag, OF(unscaled) },
    { "normal_map", read_normal_map, 0 },
    { "slope_map", read_slope_map, 0 },
    { NULL, NULL, 0 },
};

static const struct grammar grammar = { "a keyword of normal",
                                        { words, pattern_words,
                                          pattern_words_left_out },
                                        .move = pigment_move };

/* Reads the block of a normal, which may begin with the name of a normal. */
bool normal_body(struct reader *reader, const struct block *block, void *subject)
{
    const struct scene_value *value = reader_use(reader, VALUE_NORMAL);
    struct normal_reading *reading = subject;
    if (value) {
        normal_begin(reading, &value->is.bumps);
        reader_next(reader);
    }
    reading->block = block;
    if (!block_items(reader, block, &grammar, reading, read_amount(reader, reading)))
        return false;
    finish_quilted(reader, &reading->list, &block->open);
    return !reading->list.average || reading->list.count > 0
           || reader_fault(reader, &block->open, "'average' requires 'normal_map'");
}

static bool keep(struct reader *reader, const struct normal_reading *reading,
                 struct bumps *bumps)
{
    bumps->list = reader_keep(reader, &reading->list, sizeof reading->list);
    if (!bumps->list)
        return false;
    bumps->to_local = reading->list.bump.pattern.to_local;
    bumps->unscaled = reading->unscaled;
    return true;
}

bool normal_read(struct reader *reader, struct bumps *bumps)
{
    struct normal_reading reading;
    struct block block;
    normal_begin(&reading, bumps);
    return block_open(reader, &block, '{') && normal_body(reader, &block, &reading)
           && keep(reader, &reading, bumps);
}
