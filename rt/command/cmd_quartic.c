/* cmd_quartic.c - rt205 quartic: finds the real roots of polynomials on the machine,
 * and reports the cost. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/diagnostic.h"
#include "vm/error.h"
#include "base/plural.h"
#include "base/provenance.h"
#include "rt/command/session.h"
#include "rt/roots/polynomials.h"
#include "rt/study/quartic_costs.h"
#include "rt/platform/thread_pool.h"

struct quartic_arguments {
    struct trace_arguments shared;
    const char *file;
    bool all, first; /* print all roots of a polynomial, or only the first */
    int falsi;       /* rule of falsi; FALSI_RULES: compare all rules */
};

static const struct table_column root_columns[] = {
    { "polynomial", "polynomial", TABLE_COUNT, 0 },
    { "root", "root", TABLE_TEXT, 0 },
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

static double ratio(uint64_t a, uint64_t b)
{
    return b > 0 ? (double)a / (double)b : NAN;
}

/* ---- Roots -------------------------------------------------------------- */

static void print_roots(const struct command_output *results, size_t index,
                        const struct polynomial_roots *roots)
{
    char text[C205_TEXT_SIZE];
    fprintf(results->file, "%zu:", index);
    for (int i = 0; i < roots->count; i++) {
        c205_to_text(roots->root[i], text);
        fprintf(results->file, " %s", text);
    }
    putc('\n', results->file);
}

/* Adds a row for each root, for output formats other than text. */
static void add_roots(struct table *table, size_t index,
                      const struct polynomial_roots *roots)
{
    char text[C205_TEXT_SIZE];
    for (int i = 0; i < roots->count; i++) {
        c205_to_text(roots->root[i], text);
        table_count(table, index);
        table_text(table, text);
    }
}

/* Writes the roots as numbers and as texts. A root outside the range of doubles is null
 * as a number. */
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

/* Prints the roots. Returns the number of rejected polynomials, which it reports on
 * stderr. */
static size_t print_all_roots(const struct quartic_arguments *args,
                              const struct polynomials *polynomials,
                              const struct polynomial_roots *roots, struct table *table,
                              const struct command_output *results)
{
    struct json *json = results->json;
    size_t refused = 0;
    if (json)
        json_array(json, "polynomials");
    for (size_t i = 0; i < polynomials->count; i++) {
        if (roots[i].count == ROOTS_REFUSED) {
            cmd_print_line(stderr,
                           "%s:%zu:1: error: polynomial %zu: the sizes of the "
                           "coefficients are too far apart for the machine's exponents",
                           args->file, polynomials->lines[i], i);
            refused++;
            continue;
        }
        if (results->format == OUTPUT_TEXT)
            print_roots(results, i, &roots[i]);
        else
            add_roots(table, i, &roots[i]);
        if (json)
            write_roots(i, &roots[i], json);
    }
    if (json)
        json_end(json);
    return refused;
}

/* Prints the table of roots in all formats except text, which prints the roots as
 * lines. */
static bool print_table(const struct table *table, const struct command_output *results)
{
    struct command_output printed = *results;
    printed.json = NULL;
    return results->format == OUTPUT_TEXT
           || output_table(&printed, table, NULL, "Roots");
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

static struct roots_options search_options(const struct quartic_arguments *args,
                                           enum trace_mode mode, enum falsi falsi)
{
    struct roots_options options = {
        .mode = mode,
        .queue = args->shared.trace.queue,
        .first = args->first,
        .falsi = falsi,
        .model = args->shared.trace.model,
        .progress = args->shared.trace.progress,
        .context = args->shared.trace.context,
    };
    return options;
}

static struct root_search *search(const struct polynomials *polynomials,
                                  const struct roots_options *options,
                                  struct iterations *iterations, c205_error *error)
{
    struct root_search *found = roots_new(polynomials->items, polynomials->count,
                                          options, error);
    if (!found)
        return NULL;
    if (!roots_watch(found, iterations))
        error_set(error, "the program has no labels for counting its steps");
    else if (roots_run(found, error))
        return found;
    roots_free(found);
    return NULL;
}

static int solve(const struct quartic_arguments *args,
                 const struct polynomials *polynomials,
                 const struct command_output *results)
{
    c205_error error = { "out of memory" };
    struct iterations iterations;
    struct roots_options options = search_options(args, args->shared.trace.mode,
                                                  (enum falsi)args->falsi);
    struct root_search *found = search(polynomials, &options, &iterations, &error);
    struct polynomial_roots *roots = calloc(polynomials->count + 1, sizeof *roots);
    bool good = found && roots && roots_read(found, roots, &error);
    struct table *table = table_new(TABLE_COLUMNS(root_columns));
    size_t refused = 0;
    good = good && table;
    if (good) {
        const struct quartic_costs costs = {
            .file = args->file,
            .options = &options,
            .search = found,
            .iterations = &iterations,
            .polynomials = polynomials->count,
            .roots = count_roots(roots, polynomials->count),
        };
        refused = print_all_roots(args, polynomials, roots, table, results);
        good = print_table(table, results) && quartic_costs_print(&costs, results);
    }
    table_free(table);
    roots_free(found);
    free(roots);
    if (!good)
        return cmd_failed(args->shared.command, "%s", error.message);
    return refused > 0 ? CMD_FAILED : CMD_DONE;
}

/* ---- Comparison of the rules of falsi ----------------------------------- */

/* The cost of a regula falsi rule in one form of the root solver. */
struct rule_run {
    uint64_t clocks;
    struct iterations iterations;
};

struct comparison {
    const struct quartic_arguments *args;
    const struct polynomials *polynomials;
    struct rule_run runs[FALSI_RULES][TRACE_FORMS];
};

static bool run_rule(void *context, const struct task *task, c205_error *error)
{
    struct comparison *comparison = context;
    size_t rule = task->number / TRACE_FORMS;
    size_t mode = task->number % TRACE_FORMS;
    struct rule_run *run = &comparison->runs[rule][mode];
    struct roots_options options = search_options(comparison->args,
                                                  (enum trace_mode)mode,
                                                  (enum falsi)rule);
    struct root_search *found;
    options.progress = task->progress;
    options.context = task->context;
    found = search(comparison->polynomials, &options, &run->iterations, error);
    if (found)
        run->clocks = c205_clock(roots_machine(found));
    roots_free(found);
    return found != NULL;
}

/* Returns the estimated time of the host for a task. Scalar programs take several times
 * as long as vector programs. */
static double rule_weight(const void *context, size_t number)
{
    (void)context;
    return number % TRACE_FORMS == TRACE_SCALAR ? 9 : 1;
}

static void add_rule(struct table *table, const struct comparison *comparison,
                     size_t rule)
{
    size_t polynomials = comparison->polynomials->count;
    uint64_t scalar = comparison->runs[rule][TRACE_SCALAR].clocks;
    for (int mode = 0; mode < TRACE_FORMS; mode++) {
        const struct rule_run *run = &comparison->runs[rule][mode];
        const struct stage_count *count = run->iterations.stage;
        table_text(table, falsi_name((enum falsi)rule));
        table_text(table, trace_mode_name((enum trace_mode)mode));
        table_count(table, run->clocks);
        table_number(table, ratio(run->clocks, polynomials));
        table_number(table, mode == TRACE_VECTOR ? ratio(scalar, run->clocks) : NAN);
        for (int i = 0; i < STAGES; i++)
            table_number(table, ratio(count[i].steps, count[i].brackets));
        for (int i = 0; i < STAGES; i++)
            table_count(table, count[i].passes);
    }
}

static bool run_rules(struct comparison *comparison, c205_error *error)
{
    const struct trace_options *trace = &comparison->args->shared.trace;
    const struct thread_pool pool = { .count = FALSI_RULES * TRACE_FORMS,
                                      .jobs = trace->jobs,
                                      .run = run_rule,
                                      .weight = rule_weight,
                                      .context = comparison,
                                      .progress = trace->progress,
                                      .progress_context = trace->context };
    return thread_pool_run(&pool, error);
}

static int compare_rules(const struct quartic_arguments *args,
                         const struct polynomials *polynomials,
                         const struct command_output *results)
{
    c205_error error = { "out of memory" };
    struct comparison comparison = { args, polynomials, { { { 0 } } } };
    struct table *table = table_new(TABLE_COLUMNS(rules));
    bool good = table != NULL && run_rules(&comparison, &error);
    for (size_t rule = 0; good && rule < FALSI_RULES; rule++)
        add_rule(table, &comparison, rule);
    if (good) {
        output_printf(results, "%s%zu polynomial%s, a queue of %zu, %s\n",
                      results->format == OUTPUT_TEXT ? "# " : "", polynomials->count,
                      plural(polynomials->count), args->shared.trace.queue,
                      args->first ? "first roots" : "all roots");
        quartic_costs_model(results, args->shared.trace.model);
        if (results->json)
            provenance_json(args->shared.trace.model, results->json);
        good = quartic_costs_part(results, table, "rules", "The rules of falsi");
    }
    table_free(table);
    return good ? CMD_DONE : cmd_failed(args->shared.command, "%s", error.message);
}

/* ---- The command -------------------------------------------------------- */

static int read_and_solve(const struct quartic_arguments *args,
                          const struct command_output *results)
{
    struct polynomials polynomials = { 0, NULL, NULL };
    struct diagnostics reports = { 0 };
    int code = CMD_FAILED;
    if (polynomials_read(&polynomials, args->file, &reports))
        code = args->falsi == FALSI_RULES ? compare_rules(args, &polynomials, results)
                                          : solve(args, &polynomials, results);
    diagnostics_print(&reports, stderr);
    diagnostics_free(&reports);
    polynomials_free(&polynomials);
    return code;
}

static int cmd_quartic(void *given)
{
    struct quartic_arguments *args = given;
    struct trace_session session;
    int code;
    if (args->all && args->first)
        return cmd_usage(args->shared.command, "--all cannot be combined with --first");
    code = session_open(&session, &args->shared, NULL);
    if (code == CMD_DONE)
        code = read_and_solve(args, &session.results);
    return session_close(&session, code);
}

static const char *falsi_choice(size_t number)
{
    if (number == FALSI_RULES)
        return "all";
    return number < FALSI_RULES ? falsi_name((enum falsi)number) : NULL;
}

#define PLACE(member) offsetof(struct quartic_arguments, member)

static const struct command_option options[] = {
    OPTION_FLAG("all", PLACE(all), "all roots (the default)"),
    OPTION_FLAG("first", PLACE(first), "only the first root of each polynomial"),
    CMD_MODE(cmd_form_choice, "form of the program"),
    CMD_QUEUE("polynomials in the vector queue"),
    { OPTION_ROW("falsi", "RULE", COMMAND_CHOICE, PLACE(falsi),
                 "rule of the root solver; all: compare the clocks of all rules"),
      .choice = falsi_choice, .preset = FALSI_DEFAULT },
    CMD_MODEL,
    CMD_JOBS("rules compared at a time"),
    CMD_RESULTS,
    COMMAND_END
};
static const struct command_option operands[] = {
    { OPERAND_ROW(
        "FILE", COMMAND_INPUT, PLACE(file),
        "a file of polynomials: lines c4,c3,c2,c1,c0 with an optional bound (0)") },
    COMMAND_END
};

const struct command quartic_command = {
    COMMAND_ROW("quartic", cmd_quartic, struct quartic_arguments,
                "real roots of polynomials, and their clocks"),
    .details = "Prints index: root root .., the real roots above the bound, "
               "nearest first; then the clocks.",
};
