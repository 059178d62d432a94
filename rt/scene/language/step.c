/* step.c - parses transforms. The steps of a block are applied in the order of the
 * text. */
#include "rt/scene/language/scene_expression.h"
#include "rt/scene/language/scene_statement.h"

enum step { STEP_TRANSLATE, STEP_ROTATE, STEP_SCALE, STEP_MATRIX, STEP_NAMED };

#define SCALED_BY_0 "scale by 0 along %c is replaced by 1"

static bool read_scaling(struct reader *reader, const struct item *item,
                         struct placement *step)
{
    double by[3];
    if (!read_vector(reader, by))
        return false;
    for (int i = 0; i < 3; i++)
        if (by[i] == 0) {
            by[i] = 1;
            reader_report(reader, &item->at, SCALED_BY_0, "xyz"[i]);
        }
    *step = placement_scaling(by);
    return true;
}

/* Replaces a zero column of a matrix, which would flatten everything, by a column with
 * a 1, as POV-Ray does. */
static void fill_columns(struct reader *reader, const struct item *item,
                         double values[12])
{
    for (int i = 0; i < 3; i++) {
        if (values[i] != 0 || values[i + 3] != 0 || values[i + 6] != 0)
            continue;
        values[4 * i] = 1;
        reader_report(reader, &item->at, SCALED_BY_0, "xyz"[i]);
    }
}

static bool read_matrix(struct reader *reader, const struct item *item,
                        struct placement *step)
{
    double values[12];
    if (!reader_expect_sign(reader, '<'))
        return false;
    for (int i = 0; i < 12; i++) {
        if (!read_number(reader, &values[i]))
            return false;
        reader_comma(reader);
    }
    if (!reader_expect_sign(reader, '>'))
        return false;
    fill_columns(reader, item, values);
    return placement_matrix(values, step)
           || reader_fault(reader, &item->at, "the matrix has no inverse");
}

static bool read_named(struct reader *reader, struct placement *step)
{
    const struct scene_value *value = reader_use(reader, VALUE_TRANSFORM);
    if (!value)
        return transform_read(reader, step);
    *step = value->is.transform;
    reader_next(reader);
    return true;
}

static bool read_step(struct reader *reader, const struct item *item,
                      struct placement *step)
{
    enum step kind = (enum step)item->keyword->detail;
    double vector[3];
    if (kind == STEP_SCALE)
        return read_scaling(reader, item, step);
    if (kind == STEP_MATRIX)
        return read_matrix(reader, item, step);
    if (kind == STEP_NAMED)
        return read_named(reader, step);
    if (!read_vector(reader, vector))
        return false;
    *step = kind == STEP_ROTATE ? placement_rotation(vector)
                                : placement_translation(vector);
    return true;
}

/* Reads a transform such as rotate, and applies it to the subject with the function
 * that the grammar of the block specifies. */
static bool item_step(struct reader *reader, const struct item *item)
{
    struct placement step;
    if (!read_step(reader, item, &step))
        return false;
    item->grammar->move(item->subject, &step);
    return true;
}

const struct keyword step_words[] = {
    { "translate", item_step, STEP_TRANSLATE }, { "rotate", item_step, STEP_ROTATE },
    { "scale", item_step, STEP_SCALE },         { "matrix", item_step, STEP_MATRIX },
    { "transform", item_step, STEP_NAMED },     { NULL, NULL, 0 },
};

struct transform_reading {
    struct placement placement; /* first member: a named transform replaces it */
    bool inverse;
};

static void move(void *subject, const struct placement *step)
{
    struct transform_reading *reading = subject;
    reading->placement = placement_then(&reading->placement, step);
}

static const struct keyword words[] = {
    { "inverse", item_flag, offsetof(struct transform_reading, inverse) },
    { NULL, NULL, 0 },
};

static const struct grammar grammar = { "translate, rotate, scale, matrix or inverse",
                                        { words },
                                        .move = move };

bool transform_read(struct reader *reader, struct placement *placement)
{
    struct transform_reading reading = { placement_none, false };
    struct scene_token at = reader->token;
    if (!block_read_from(reader, &grammar, VALUE_TRANSFORM, &reading,
                         sizeof reading.placement))
        return false;
    *placement = reading.inverse ? placement_inverse(&reading.placement)
                                 : reading.placement;
    return placement_is_finite(placement)
           || reader_fault(reader, &at, "the transform is out of range");
}
