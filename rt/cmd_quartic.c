/* cmd_quartic.c - rt205 quartic: the real roots of polynomials, found on the
 * machine, and what they cost. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "asm/accounts.h"
#include "asm/provenance.h"
#include "rt/cmd.h"
#include "rt/polynomials.h"
#include "rt/scene/report.h"

static const struct table_column stages[] = {
    { "stage", "stage", TABLE_TEXT, 0 },
    { "brackets", "brackets", TABLE_COUNT, 0 },
    { "steps_per_bracket", "steps/bracket", TABLE_NUMBER, 2 },
    { "halvings_per_bracket", "halvings", TABLE_NUMBER, 2 },
    { "passes", "passes", TABLE_COUNT, 0 },
    { "in_loop", "in loop", TABLE_NUMBER, 1 },
    { "active_percent", "% active", TABLE_NUMBER, 1 },
};
static const struct table_column passes[] = {
    { "stage", "stage", TABLE_TEXT, 0 },
    { "pass", "pass", TABLE_COUNT, 0 },
    { "in_loop", "in loop", TABLE_COUNT, 0 },
    { "active", "active", TABLE_COUNT, 0 },
    { "active_percent", "% of the loop", TABLE_NUMBER, 1 },
    { "all_percent", "% of all", TABLE_NUMBER, 1 },
};
static const struct table_column rules[] = {
    { "falsi", "falsi", TABLE_TEXT, 0 },
    { "form", "form", TABLE_TEXT, 0 },
    { "clocks", "clocks", TABLE_COUNT, 0 },
    { "clocks_per_polynomial", "clocks/polynomial", TABLE_NUMBER, 1 },
    { "speedup", "speedup", TABLE_NUMBER, 2 },
    { "slope_steps", "slope: steps", TABLE_NUMBER, 2 },
    { "value_steps", "value: steps", TABLE_NUMBER, 2 },
    { "slope_passes", "slope: passes", TABLE_COUNT, 0 },
    { "value_passes", "value: passes", TABLE_COUNT, 0 },
};
#define COLUMNS(list) (sizeof(list) / sizeof *(list))

/* ---- Results ------------------------------------------------------------ */

static double ratio(uint64_t a, uint64_t b)
{
    return b > 0 ? (double)a / (double)b : NAN;
}

static struct table *stage_table(const struct iterations *iterations)
{
    struct table *table = table_new(stages, COLUMNS(stages));

    for (int i = 0; table != NULL && i < STAGES; i++) {
        const struct stage_count *count = &iterations->stage[i];

        table_text(table, stage_name((enum stage)i));
        table_count(table, count->brackets);
        table_number(table, ratio(count->steps, count->brackets));
        table_number(table, ratio(count->halvings, count->brackets));
        table_count(table, count->passes);
        table_number(table, ratio(count->lanes, count->passes));
        table_number(table, 100 * ratio(count->steps, count->lanes));
    }
    return table;
}

static struct table *pass_table(const struct iterations *iterations)
{
    struct table *table = table_new(passes, COLUMNS(passes));

    for (int i = 0; table != NULL && i < STAGES; i++) {
        const struct stage_count *count = &iterations->stage[i];

        for (size_t pass = 0; pass < ITERATIONS_MOST; pass++) {
            if (count->in_loop[pass] == 0)
                continue;
            table_text(table, stage_name((enum stage)i));
            table_count(table, pass + 1);
            table_count(table, count->in_loop[pass]);
            table_count(table, count->active[pass]);
            table_number(table, 100
                                    * ratio(count->active[pass],
                                            count->in_loop[pass]));
            table_number(table,
                         100 * ratio(count->active[pass], count->brackets));
        }
    }
    return table;
}

/* Each line of the table behind a #. */
static bool print_remarks(const struct table *table, const char *heading)
{
    char *text = NULL;
    size_t length = 0;
    FILE *stream = open_memstream(&text, &length);
    bool good = stream != NULL && table_print(table, stream);
    bool begins = true;

    good = stream != NULL && fclose(stream) == 0 && good;
    printf("#\n# %s\n#\n", heading);
    for (size_t i = 0; good && i < length; i++) {
        if (begins)
            fputs(text[i] == '\n' ? "#" : "# ", stdout);
        putchar(text[i]);
        begins = text[i] == '\n';
    }
    free(text);
    return good;
}

/* All that is printed and written after the roots. */
struct costs {
    const struct cmd_arguments *arguments;
    const c205 *machine;
    const char *falsi;
    size_t polynomials, roots;
    struct table *stages, *passes, *regions, *causes, *detail;
};

static bool print_costs(const struct costs *costs)
{
    const struct trace_options *trace = &costs->arguments->trace;
    uint64_t clocks = c205_clock(costs->machine);

    printf("# %zu polynomials, %zu roots; %s", costs->polynomials,
           costs->roots, trace_mode_name(trace->mode));
    if (trace->mode == TRACE_VECTOR)
        printf(", a queue of %zu", trace->queue);
    printf(", %s, falsi %s\n",
           costs->arguments->first ? "first roots" : "all roots",
           costs->falsi);
    printf("# %llu clocks, %.8f s on the machine\n# ",
           (unsigned long long)clocks,
           accounts_seconds(trace->model, clocks));
    provenance_print(trace->model);
    return print_remarks(costs->regions, "Clocks by region:")
           && print_remarks(costs->detail, "By cause:")
           && print_remarks(costs->stages, "Refinement: knots (slope) and "
                                           "roots (value), steps of falsi:")
           && print_remarks(costs->passes, "Brackets still active, by pass:");
}

static void write_costs(const struct costs *costs, struct json *json)
{
    const struct trace_options *trace = &costs->arguments->trace;
    uint64_t clocks = c205_clock(costs->machine);

    json_text(json, "file", costs->arguments->scene);
    json_text(json, "mode", trace_mode_name(trace->mode));
    json_count(json, "queue", trace->queue);
    json_truth(json, "first", costs->arguments->first);
    json_text(json, "falsi", costs->falsi);
    json_count(json, "clocks", clocks);
    json_number(json, "seconds", accounts_seconds(trace->model, clocks));
    provenance_json(trace->model, json);
    table_json(costs->regions, json, "regions");
    table_json(costs->detail, json, "causes");
    table_json(costs->stages, json, "stages");
    table_json(costs->passes, json, "passes");
}

static bool tell_costs(struct costs *costs,
                       const struct iterations *iterations, struct json *json)
{
    bool good;

    costs->stages = stage_table(iterations);
    costs->passes = pass_table(iterations);
    costs->regions = accounts_by_region(costs->machine);
    costs->detail = accounts_by_cause(costs->machine);
    good = costs->stages != NULL && costs->passes != NULL
           && costs->regions != NULL && costs->detail != NULL
           && print_costs(costs);
    if (good && json != NULL)
        write_costs(costs, json);
    table_free(costs->stages);
    table_free(costs->passes);
    table_free(costs->regions);
    table_free(costs->detail);
    return good;
}

/* ---- Roots -------------------------------------------------------------- */

static void print_roots(size_t index, const struct polynomial_roots *roots)
{
    char text[C205_TEXT_SIZE];

    printf("%zu:", index);
    for (int i = 0; i < roots->count; i++) {
        c205_to_text(roots->root[i], text);
        printf(" %s", text);
    }
    putchar('\n');
}

/* A root beyond the doubles is null among the numbers, but has its text. */
static void write_roots(size_t index, const struct polynomial_roots *roots,
                        struct json *json)
{
    char text[C205_TEXT_SIZE];

    json_object(json, NULL);
    json_count(json, "index", index);
    json_array(json, "roots");
    for (int i = 0; i < roots->count; i++)
        json_number(json, NULL, c205_to_double(roots->root[i]));
    json_end(json);
    json_array(json, "texts");
    for (int i = 0; i < roots->count; i++) {
        c205_to_text(roots->root[i], text);
        json_text(json, NULL, text);
    }
    json_end(json);
    json_end(json);
}

/* Returns how many polynomials were refused; those are named on stderr. */
static size_t tell_roots(const struct cmd_arguments *arguments,
                         const struct polynomials *polynomials,
                         const struct polynomial_roots *roots,
                         struct json *json)
{
    size_t refused = 0;

    if (json != NULL)
        json_array(json, "polynomials");
    for (size_t i = 0; i < polynomials->count; i++) {
        if (roots[i].count == ROOTS_REFUSED) {
            fprintf(stderr,
                    "%s:%zu:1: error: polynomial %zu: the sizes of "
                    "the coefficients are too far apart for the machine's "
                    "exponents\n",
                    arguments->scene, polynomials->lines[i], i);
            refused++;
            continue;
        }
        print_roots(i, &roots[i]);
        if (json != NULL)
            write_roots(i, &roots[i], json);
    }
    if (json != NULL)
        json_end(json);
    return refused;
}

static size_t count_roots(const struct polynomial_roots *roots, size_t count)
{
    size_t sum = 0;

    for (size_t i = 0; i < count; i++)
        if (roots[i].count > 0)
            sum += (size_t)roots[i].count;
    return sum;
}

/* ---- The search --------------------------------------------------------- */

static struct roots_options
search_options(const struct cmd_arguments *arguments, enum trace_mode mode,
               enum falsi falsi)
{
    struct roots_options options = {
        .mode = mode,
        .queue = arguments->trace.queue,
        .first = arguments->first,
        .falsi = falsi,
        .model = arguments->trace.model,
        .progress = arguments->trace.progress,
        .context = arguments->trace.context,
    };
    return options;
}

static struct root_search *search(const struct polynomials *polynomials,
                                  const struct roots_options *options,
                                  struct iterations *iterations,
                                  c205_error *error)
{
    struct root_search *found = roots_new(polynomials->items,
                                          polynomials->count, options, error);

    if (found == NULL)
        return NULL;
    if (!roots_watch(found, iterations))
        snprintf(error->message, sizeof error->message,
                 "the program lacks labels to count its steps by");
    else if (roots_run(found, error))
        return found;
    roots_free(found);
    return NULL;
}

static int solve(const struct cmd_arguments *arguments,
                 const struct polynomials *polynomials, struct json *json)
{
    c205_error error = { "no memory" };
    struct iterations iterations;
    const struct roots_options options = search_options(arguments,
                                                        arguments->trace.mode,
                                                        arguments->falsi);
    struct root_search *found = search(polynomials, &options, &iterations,
                                       &error);
    struct polynomial_roots *roots = calloc(polynomials->count + 1,
                                            sizeof *roots);
    bool good = found != NULL && roots != NULL
                && roots_read(found, roots, &error);
    size_t refused = 0;

    if (good) {
        struct costs costs = { .arguments = arguments,
                               .machine = roots_machine(found),
                               .falsi = falsi_name(roots_falsi(found)),
                               .polynomials = polynomials->count,
                               .roots = count_roots(roots,
                                                    polynomials->count) };

        refused = tell_roots(arguments, polynomials, roots, json);
        good = tell_costs(&costs, &iterations, json);
    }
    roots_free(found);
    free(roots);
    if (!good)
        return cmd_failed(arguments->command, "%s", error.message);
    return refused > 0 ? CMD_FAILED : CMD_DONE;
}

/* ---- The rules of falsi beside each other ------------------------------- */

static bool add_rule(struct table *table,
                     const struct cmd_arguments *arguments,
                     const struct polynomials *polynomials, enum falsi rule,
                     c205_error *error)
{
    uint64_t scalar = 0;

    for (int mode = 0; mode < TRACE_MODES; mode++) {
        const struct roots_options options =
            search_options(arguments, (enum trace_mode)mode, rule);
        struct iterations iterations;
        struct root_search *found = search(polynomials, &options, &iterations,
                                           error);
        const struct stage_count *count = iterations.stage;
        uint64_t clocks;

        if (found == NULL)
            return false;
        clocks = c205_clock(roots_machine(found));
        roots_free(found);
        table_text(table, falsi_name(rule));
        table_text(table, trace_mode_name((enum trace_mode)mode));
        table_count(table, clocks);
        table_number(table, ratio(clocks, polynomials->count));
        table_number(table,
                     mode == TRACE_VECTOR ? ratio(scalar, clocks) : NAN);
        for (int i = 0; i < STAGES; i++)
            table_number(table, ratio(count[i].steps, count[i].brackets));
        for (int i = 0; i < STAGES; i++)
            table_count(table, count[i].passes);
        scalar = clocks;
    }
    return true;
}

static int compare_rules(const struct cmd_arguments *arguments,
                         const struct polynomials *polynomials,
                         struct json *json)
{
    c205_error error = { "no memory" };
    struct table *table = table_new(rules, COLUMNS(rules));
    bool good = table != NULL;

    for (int rule = 0; good && rule < FALSI_RULES; rule++)
        good = add_rule(table, arguments, polynomials, (enum falsi)rule,
                        &error);
    if (good) {
        printf("# %zu polynomials, a queue of %zu, %s\n# ",
               polynomials->count, arguments->trace.queue,
               arguments->first ? "first roots" : "all roots");
        provenance_print(arguments->trace.model);
        good = print_remarks(table, "The rules of falsi:");
    }
    if (good && json != NULL) {
        provenance_json(arguments->trace.model, json);
        table_json(table, json, "rules");
    }
    table_free(table);
    return good ? CMD_DONE
                : cmd_failed(arguments->command, "%s", error.message);
}

/* ---- The command -------------------------------------------------------- */

static int run(const struct cmd_arguments *arguments, struct json *json)
{
    struct polynomials polynomials = { 0, 0, NULL, NULL };
    struct reports reports = { 0, 0, NULL };
    int code = CMD_FAILED;

    if (polynomials_read(&polynomials, arguments->scene, &reports))
        code = arguments->compare
                   ? compare_rules(arguments, &polynomials, json)
                   : solve(arguments, &polynomials, json);
    reports_print(stderr, &reports);
    reports_free(&reports);
    polynomials_free(&polynomials);
    return code;
}

int cmd_quartic(struct cmd_arguments *arguments)
{
    c205_error error;
    struct json *json = NULL;
    c205_model *model = c205_model_find(arguments->model, &error);
    int code;

    if (model == NULL)
        return cmd_failed(arguments->command, "%s", error.message);
    if (arguments->json != NULL
        && (json = json_open(arguments->json, &error)) == NULL) {
        c205_model_free(model);
        return cmd_failed(arguments->command, "%s", error.message);
    }
    arguments->trace.model = model;
    cmd_watch(&arguments->trace);
    code = run(arguments, json);
    if (json != NULL && code != CMD_DONE)
        json_discard(json);
    else if (json != NULL && !json_close(json, &error))
        code = cmd_failed(arguments->command, "%s", error.message);
    c205_model_free(model);
    return code;
}
