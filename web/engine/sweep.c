/* sweep.c - the request `sweep`, which runs one or two programs for many values of a
 * constant.
 */
#include <stdlib.h>
#include <string.h>

#include "asm/sweep/swept.h"
#include "web/engine/engine_internal.h"

/* A sweep and the data that it refers to. */
struct laboratory {
    struct arena arena;
    struct asm_options options;
    c205_model *model;
    struct text_buffer report; /* unused, because take_program has already reported all
                                  messages */
    struct program_sweep sweep;
};

void sweep_drop(struct engine *engine)
{
    struct laboratory *laboratory = engine->laboratory;
    if (!laboratory)
        return;
    swept_free(&laboratory->sweep);
    c205_model_free(laboratory->model);
    text_buffer_free(&laboratory->report);
    arena_free(&laboratory->arena);
    free(laboratory);
    engine->laboratory = NULL;
}

/* ---- The reply ------------------------------------------------------------------ */

static bool put_picture(const struct program_sweep *sweep, struct json *reply,
                        c205_error *error)
{
    struct text_buffer text = { .text = NULL };
    struct sink sink = text_buffer_sink(&text);
    char title[SWEPT_TITLE];
    swept_title(sweep, title);
    if (swept_svg(sweep, title, &sink, error))
        return put_buffer(reply, "svg", &text, error);
    text_buffer_free(&text);
    return false;
}

/* Writes the picture and the members of c205 sweep --json. */
static bool put_sweep(const struct program_sweep *sweep, struct json *reply,
                      c205_error *error)
{
    json_text(reply, "constant", sweep->constant);
    json_text(reply, "model", c205_model_name(sweep->model));
    return put_table(swept_points(sweep), "points", reply, error)
           && put_table(swept_lines(sweep), "lines", reply, error)
           && put_table(swept_causes(sweep), "causes", reply, error)
           && (sweep->program_count < SWEPT_PROGRAMS
               || put_table(swept_crossings(sweep), "crossings", reply, error))
           && put_picture(sweep, reply, error);
}

/* Runs points of the sweep until the end of the slice. The last slice writes the
 * results. */
static bool slice(struct engine *engine, struct json *reply, c205_error *error)
{
    struct program_sweep *sweep = &engine->laboratory->sweep;
    bool over = false, good = true;
    do {
        good = swept_step(sweep, &over, error);
        engine->slice.spent++;
    } while (good && !over && !slice_is_full(engine));
    engine->goes_on = good && !over ? slice : NULL;
    if (good)
        json_bool(reply, "done", over);
    if (good && !over)
        json_number(reply, "part", (double)sweep->done / (double)sweep->all);
    if (good && over)
        good = put_sweep(sweep, reply, error);
    if (!engine->goes_on)
        sweep_drop(engine);
    return good;
}

/* ---- The request --------------------------------------------------------- */

static bool take_values(const struct engine *engine, const struct json_value *request,
                        struct program_sweep *sweep, c205_error *error)
{
    struct swept_range *range = &sweep->range;
    uint64_t values[MAX_SWEPT_POINTS], points = 0;
    if (!take_count(request, "from", &range->from, error)
        || !take_count(request, "to", &range->to, error)
        || !take_count(request, "step", &range->step, error)
        || !take_count(request, "factor", &range->factor, error)
        || !take_count(request, "points", &points, error)
        || !take_limit(engine, request, &sweep->clocks_most, error))
        return false;
    sweep->asked = (size_t)points;
    if (range->from < 1 || range->from >= range->to || range->to > SWEPT_LARGEST
        || range->factor == 1 || (range->step > 0 && range->factor > 0))
        return error_set(
            error,
            "the range must rise from 1 or more, with a \"step\", a \"factor\" or "
            "neither");
    if (points == 1 || points > MAX_SWEPT_POINTS
        || swept_values(range, sweep->asked, values) < 2)
        return error_set(error, "a sweep must have 2 to %d points", MAX_SWEPT_POINTS);
    return true;
}

/* Returns the options with the first value of the constant added, or NULL if memory is
 * exhausted. */
static struct asm_options *at_first(struct laboratory *laboratory)
{
    struct arena *arena = &laboratory->arena;
    const struct asm_define *defines = laboratory->options.defines;
    struct asm_options *options = arena_take(arena, sizeof *options);
    struct asm_define *list;
    size_t count = 0;
    while (defines[count].name)
        count++;
    list = arena_take(arena, (count + 2) * sizeof *list);
    if (!options || !list)
        return NULL;
    memcpy(list, defines, count * sizeof *list);
    list[count].name = laboratory->sweep.constant;
    list[count].value = (int64_t)laboratory->sweep.range.from;
    *options = laboratory->options;
    options->defines = list;
    return options;
}

/* Reads a program and assembles it for the first value of the sweep, to report its
 * errors and warnings before any run. */
static bool take_program(struct engine *engine, const struct json_value *request,
                         const char *key, const char *name_key, c205_error *error)
{
    struct laboratory *laboratory = engine->laboratory;
    struct program_sweep *sweep = &laboratory->sweep;
    const char *text = NULL, *model = NULL;
    const char *name = swept_names[sweep->program_count];
    struct asm_options *first;
    struct object *object;
    if (!take_text_or(request, key, &text, error)
        || !take_text_or(request, name_key, &name, error)
        || !take_text_or(request, "model", &model, error))
        return false;
    if (!text)
        return true;
    first = at_first(laboratory);
    if (!first)
        return error_set(error, "out of memory");
    object = engine_assemble(engine, name, text, first, error);
    if (object && !laboratory->model)
        laboratory->model = program_model(model, object, error);
    if (!object || !laboratory->model) {
        object_free(object);
        return false;
    }
    object_free(object);
    sweep->programs[sweep->program_count++] = (struct swept_program){
        arena_text(&laboratory->arena, name, strlen(name)),
        arena_text(&laboratory->arena, text, strlen(text)), strlen(text)
    };
    return !laboratory->arena.failed || error_set(error, "out of memory");
}

static bool take_sweep(struct engine *engine, const struct json_value *request,
                       c205_error *error)
{
    struct laboratory *laboratory = engine->laboratory;
    struct program_sweep *sweep = &laboratory->sweep;
    bool given = json_member(request, "warm"), warm = false;
    const char *constant;
    if (!take_text(request, "constant", &constant, error)
        || !take_truth(request, "warm", &warm, error)
        || !take_values(engine, request, sweep, error)
        || !take_options(request, &laboratory->arena, &laboratory->options, error))
        return false;
    sweep->warm = given && warm;
    sweep->cold = given && !warm;
    sweep->constant = arena_text(&laboratory->arena, constant, strlen(constant));
    sweep->options = &laboratory->options;
    sweep->report = text_buffer_sink(&laboratory->report);
    if (!sweep->constant)
        return error_set(error, "out of memory");
    if (!take_program(engine, request, "text", "name", error)
        || !take_program(engine, request, "other", "other-name", error))
        return false;
    sweep->model = laboratory->model;
    return sweep->program_count > 0 || error_set(error, "\"text\" is missing");
}

bool answer_sweep(struct engine *engine, const struct json_value *request,
                  struct json *reply, c205_error *error)
{
    struct laboratory *laboratory = calloc(1, sizeof *laboratory);
    if (!laboratory)
        return error_set(error, "out of memory");
    engine->laboratory = laboratory;
    laboratory->sweep.clocks_most = ENGINE_SWEEP_LIMIT;
    if (take_slice(engine, request, error) && take_sweep(engine, request, error))
        return slice(engine, reply, error);
    sweep_drop(engine);
    return false;
}
