/* compare.c - the request `compare`: runs two programs and compares their accounts. */
#include <stdlib.h>

#include "asm/compare/compared.h"
#include "asm/object/object_file.h"
#include "web/engine/engine_internal.h"

struct compared_text {
    char *name;
    struct object *object;
    c205_model *model;
    struct compared_run run;
};

struct text_comparison {
    struct compared_text sides[COMPARED_RUNS];
    int which;     /* the side that is running */
    c205 *machine; /* machine of this side, or NULL */
    uint64_t limit;
};

void compare_drop(struct engine *engine)
{
    struct text_comparison *comparison = engine->comparison;
    if (!comparison)
        return;
    for (int i = 0; i < COMPARED_RUNS; i++) {
        struct compared_text *side = &comparison->sides[i];
        compared_free(&side->run);
        object_free(side->object);
        c205_model_free(side->model);
        free(side->name);
    }
    c205_free(comparison->machine);
    free(comparison);
    engine->comparison = NULL;
}

/* ---- Runs -------------------------------------------------------------------- */

/* Runs one of the two programs for a slice. Sets *over if the run has ended and its
 * accounts are stored. */
static bool run_side(struct engine *engine, struct text_comparison *comparison,
                     bool *over, c205_error *error)
{
    enum { AT_ONCE = 1 << 18 };
    c205 *machine = comparison->machine;
    uint64_t clock = c205_clock(machine);
    bool last = comparison->limit <= clock + AT_ONCE;
    c205_stop stop = c205_run(machine, last ? comparison->limit : clock + AT_ONCE);
    engine->slice.spent += c205_clock(machine) - clock;
    *over = stop.trap == C205_TRAP_NONE;
    if (*over)
        return compared_take(&comparison->sides[comparison->which].run, machine)
               || error_set(error, "out of memory");
    if (stop.trap == C205_TRAP_CLOCK_LIMIT && !last)
        return true;
    c205_describe_stop(machine, &stop, error);
    return refuse_of(error, comparison->sides[comparison->which].name);
}

static bool begin_run(struct text_comparison *comparison, c205_error *error)
{
    const struct compared_text *side = &comparison->sides[comparison->which];
    comparison->machine = c205_new(side->model, error);
    return comparison->machine && object_check(side->object, error)
           && c205_load(comparison->machine, &side->object->program, error);
}

static bool continue_comparison(struct engine *engine,
                                struct text_comparison *comparison, c205_error *error)
{
    bool over = false;
    if (!comparison->machine && !begin_run(comparison, error))
        return false;
    if (!run_side(engine, comparison, &over, error))
        return false;
    if (over) {
        c205_free(comparison->machine);
        comparison->machine = NULL;
        comparison->which++;
    }
    return true;
}

/* ---- The reply ------------------------------------------------------------------ */

/* Writes a sentence that compares the runs, and the members of c205 compare --json. */
static bool put_comparison(const struct text_comparison *comparison, struct json *reply,
                           c205_error *error)
{
    struct compared_run runs[COMPARED_RUNS];
    char sentence[COMPARED_SENTENCE];
    json_array(reply, "programs");
    for (int i = 0; i < COMPARED_RUNS; i++) {
        runs[i] = comparison->sides[i].run;
        json_object(reply, NULL);
        json_text(reply, "name", comparison->sides[i].name);
        json_text(reply, "model", c205_model_name(comparison->sides[i].model));
        json_end(reply);
    }
    json_end(reply);
    compared_sentence(runs, sentence);
    json_text(reply, "sentence", sentence);
    return put_table(compared_causes(runs), "causes", reply, error)
           && put_table(compared_regions(runs), "regions", reply, error)
           && put_table(compared_figures(runs), "figures", reply, error);
}

static bool slice(struct engine *engine, struct json *reply, c205_error *error)
{
    struct text_comparison *comparison = engine->comparison;
    bool good = true;
    while (good && comparison->which < COMPARED_RUNS) {
        good = continue_comparison(engine, comparison, error);
        if (good && slice_is_full(engine))
            break;
    }
    engine->goes_on = good && comparison->which < COMPARED_RUNS ? slice : NULL;
    if (good)
        json_bool(reply, "done", !engine->goes_on);
    if (good && !engine->goes_on)
        good = put_comparison(comparison, reply, error);
    if (!engine->goes_on)
        compare_drop(engine);
    return good;
}

/* ---- The request --------------------------------------------------------- */

static bool take_side(struct engine *engine, const struct json_value *request,
                      const struct json_value *from, const struct asm_options *options,
                      struct compared_text *side, c205_error *error)
{
    const char *name = "program.s", *text, *model = NULL;
    if (!take_text_or(from, "name", &name, error)
        || !take_text(from, "text", &text, error)
        || !take_text_or(request, "model", &model, error)
        || !take_text_or(from, "model", &model, error))
        return false;
    side->name = copy_of(name);
    if (!side->name)
        return error_set(error, "out of memory");
    side->object = engine_assemble(engine, name, text, options, error);
    if (!side->object || !take_warm(request, side->object, error))
        return false;
    side->model = program_model(model, side->object, error);
    return side->model;
}

static bool take_sides(struct engine *engine, const struct json_value *request,
                       const struct asm_options *options, c205_error *error)
{
    const struct json_value *text = json_member_first(request, "texts");
    struct object *objects[COMPARED_RUNS];
    int count = 0;
    for (; text && count < COMPARED_RUNS; text = text->next)
        if (!take_side(engine, request, text, options,
                       &engine->comparison->sides[count++], error))
            return false;
    for (int i = 0; i < count; i++)
        objects[i] = engine->comparison->sides[i].object;
    return ((!text && count == COMPARED_RUNS)
            || error_set(error, "\"texts\" must be a list of two programs"))
           && uses_defines(options, objects, COMPARED_RUNS, error);
}

bool answer_compare(struct engine *engine, const struct json_value *request,
                    struct json *reply, c205_error *error)
{
    struct text_comparison *comparison = calloc(1, sizeof *comparison);
    struct asm_options options = { .defines = NULL };
    struct arena arena = { 0 };
    bool good;
    if (!comparison)
        return error_set(error, "out of memory");
    engine->comparison = comparison;
    comparison->limit = ENGINE_LIMIT;
    good = take_slice(engine, request, error)
           && take_limit(engine, request, &comparison->limit, error)
           && take_options(request, &arena, &options, error)
           && take_sides(engine, request, &options, error);
    arena_free(&arena);
    if (good)
        return slice(engine, reply, error);
    compare_drop(engine);
    return false;
}
