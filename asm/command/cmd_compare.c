/* cmd_compare.c - c205 compare: two programs, or two settings of one, side by side. */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "asm/command/c205_command.h"
#include "base/accounts.h"

enum { FIRST, SECOND, SIDES };

struct side {
    const char *path;
    c205_model *model;
    struct object *object;
    struct accounts accounts;
    c205_account all;
};

struct two_runs {
    const struct c205_arguments *arguments;
    struct side side[SIDES];
};

/* ---- Runs ------------------------------------------------------------------ */

static bool read_side(struct two_runs *runs, int which)
{
    const struct c205_arguments *arguments = runs->arguments;
    struct c205_arguments own = *arguments;
    struct side *side = &runs->side[which];
    struct sink report = stream_sink(stderr);
    bool other = which == SECOND && arguments->files.count == 1;
    side->path = arguments->files.items[other ? FIRST : which];
    if (which == SECOND && arguments->other_defines.count > 0) {
        own.defines = arguments->other_defines;
    }
    side->object = cmd_read_program(&own, side->path, &report);
    side->model = side->object
                      ? model_open(arguments->command,
                                   which == SECOND && arguments->other_model
                                       ? arguments->other_model
                                       : arguments->model)
                      : NULL;
    return side->model;
}

static bool run_to_end(struct side *side, c205 *machine, c205_error *error)
{
    c205_stop stop = c205_run(machine, CMD_LIMIT);
    if (stop.trap != C205_TRAP_NONE) {
        c205_describe_stop(machine, &stop, error);
        return false;
    }
    snprintf(error->message, sizeof error->message, "no memory");
    return accounts_add(&side->accounts, machine);
}

/* What it prints is not asked. */
static bool run_side(struct two_runs *runs, int which)
{
    struct side *side = &runs->side[which];
    c205_error error;
    c205 *machine = cmd_load(runs->arguments, side->object, side->model,
                             &error);
    bool good;
    side->accounts.model = side->model;
    good = machine && run_to_end(side, machine, &error);
    c205_free(machine);
    if (good) {
        side->all = accounts_together(&side->accounts);
    } else {
        cmd_failed(runs->arguments->command, "%s: %s", side->path,
                   error.message);
    }
    return good;
}

/* ---- Tables ---------------------------------------------------------------- */

static const struct table_column cause_columns[] = {
    { "cause", "clocks", TABLE_TEXT, 0 },
    { "first", "first", TABLE_COUNT, 0 },
    { "second", "second", TABLE_COUNT, 0 },
    { "difference", "second - first", TABLE_NUMBER, 0 },
    { "ratio", "first / second", TABLE_NUMBER, 3 },
};
static const struct table_column region_columns[] = {
    { "region", "region, clocks", TABLE_TEXT, 0 },
    { "first", "first", TABLE_COUNT, 0 },
    { "second", "second", TABLE_COUNT, 0 },
    { "difference", "second - first", TABLE_NUMBER, 0 },
    { "ratio", "first / second", TABLE_NUMBER, 3 },
};
static const struct table_column figure_columns[] = {
    { "figure", "figure", TABLE_TEXT, 0 },
    { "first", "first", TABLE_NUMBER, 3 },
    { "second", "second", TABLE_NUMBER, 3 },
    { "ratio", "first / second", TABLE_NUMBER, 3 },
};

static double quotient(double a, double b)
{
    return b > 0 ? a / b : NAN;
}

static void add_clocks(struct table *table, const char *name, uint64_t first,
                       uint64_t second)
{
    table_text(table, name);
    table_count(table, first);
    table_count(table, second);
    table_number(table, (double)second - (double)first);
    table_number(table, quotient((double)first, (double)second));
}

static struct table *cause_table(const struct two_runs *runs)
{
    const c205_account *first = &runs->side[FIRST].all;
    const c205_account *second = &runs->side[SECOND].all;
    struct table *table = table_new(TABLE_COLUMNS(cause_columns));
    for (int i = 0; table && i < C205_CAUSES; i++) {
        if (first->clocks[i] + second->clocks[i] > 0) {
            add_clocks(table, c205_cause_name((c205_cause)i),
                       first->clocks[i], second->clocks[i]);
        }
    }
    if (table) {
        add_clocks(table, "all", accounts_clocks(first),
                   accounts_clocks(second));
    }
    return table;
}

static uint64_t clocks_of(const struct side *side, const char *region)
{
    const c205_account *account = accounts_find(&side->accounts, region);
    return account ? accounts_clocks(account) : 0;
}

/* Those of the first, then those that the second alone has. */
static struct table *region_table(const struct two_runs *runs)
{
    const struct side *side = runs->side;
    struct table *table = table_new(TABLE_COLUMNS(region_columns));
    for (int which = FIRST; table && which < SIDES; which++) {
        const struct accounts *accounts = &side[which].accounts;
        for (size_t i = 0; i < accounts->count; i++) {
            const char *name = accounts->items[i].name;
            uint64_t first = clocks_of(&side[FIRST], name);
            uint64_t second = clocks_of(&side[SECOND], name);
            bool told = which == SECOND
                        && accounts_find(&side[FIRST].accounts, name);
            if (!told && first + second > 0) {
                add_clocks(table, accounts_region(&accounts->items[i]), first,
                           second);
            }
        }
    }
    return table;
}

static void add_figure(struct table *table, const char *name, double first,
                       double second)
{
    table_text(table, name);
    table_number(table, first);
    table_number(table, second);
    table_number(table, quotient(first, second));
}

static double seconds_of(const struct side *side)
{
    return accounts_seconds(side->model, accounts_clocks(&side->all));
}

static double mean_length(const c205_account *account)
{
    return quotient((double)account->elements,
                    (double)account->vector_instructions);
}

static struct table *figure_table(const struct two_runs *runs)
{
    const struct side *one = &runs->side[FIRST];
    const struct side *other = &runs->side[SECOND];
    const c205_account *first = &one->all, *second = &other->all;
    struct table *table = table_new(TABLE_COLUMNS(figure_columns));
    if (!table) {
        return NULL;
    }
    add_figure(table, "milliseconds", 1e3 * seconds_of(one),
               1e3 * seconds_of(other));
    add_figure(table, "instructions", (double)first->instructions,
               (double)second->instructions);
    add_figure(table, "of them vector", (double)first->vector_instructions,
               (double)second->vector_instructions);
    add_figure(table, "elements", (double)first->elements,
               (double)second->elements);
    add_figure(table, "mean vector length", mean_length(first),
               mean_length(second));
    add_figure(table, "Mflop/s", accounts_rate(one->model, first),
               accounts_rate(other->model, second));
    return table;
}

/* ---- In words -------------------------------------------------------------- */

static double difference_of(const struct two_runs *runs, int cause)
{
    return (double)runs->side[SECOND].all.clocks[cause]
           - (double)runs->side[FIRST].all.clocks[cause];
}

/* The cause with the largest difference that goes the same way as all of it, besides one; below
 * 0: there is none. */
static int largest(const struct two_runs *runs, double whole, int besides)
{
    int found = -1;
    for (int i = 0; i < C205_CAUSES; i++) {
        double own = difference_of(runs, i);
        if (i != besides && own * whole > 0
            && (found < 0 || fabs(own) > fabs(difference_of(runs, found)))) {
            found = i;
        }
    }
    return found;
}

enum { CAUSE_TEXT = 80 };

static void say_cause(const struct two_runs *runs, int cause,
                      char text[CAUSE_TEXT])
{
    double own = difference_of(runs, cause);
    snprintf(text, CAUSE_TEXT, "%.0f %s of %s", fabs(own),
             own < 0 ? "fewer" : "more", c205_cause_name((c205_cause)cause));
}

/* The one or two causes that make the difference. */
static void tell_difference(const struct two_runs *runs,
                            const struct results *results)
{
    double first = (double)accounts_clocks(&runs->side[FIRST].all);
    double second = (double)accounts_clocks(&runs->side[SECOND].all);
    double whole = second - first;
    int most = largest(runs, whole, -1), next;
    char cause[CAUSE_TEXT], beside[CAUSE_TEXT] = "";
    if (most < 0) {
        results_say(results, "Both take %.0f clocks.\n", first);
        return;
    }
    say_cause(runs, most, cause);
    next = largest(runs, whole, most);
    if (next >= 0
        && fabs(difference_of(runs, next)) * 5
               >= fabs(difference_of(runs, most))) {
        say_cause(runs, next, beside);
    }
    results_say(results,
                "The second takes %.0f clocks %s than the first: %s%s%s.\n",
                fabs(whole), whole < 0 ? "less" : "more", cause,
                *beside ? ", and " : "", beside);
}

/* ---- The command ----------------------------------------------------------- */

static int show_next(const struct results *results, struct table *table,
                     const char *key, const char *heading, int code)
{
    if (code != CMD_DONE) {
        table_free(table);
        return code;
    }
    results_gap(results);
    return results_show(results, table, key, heading);
}

static int show(const struct two_runs *runs, const struct results *results)
{
    int code;
    for (int i = 0; i < SIDES; i++) {
        const struct side *side = &runs->side[i];
        results_say(results, "%s: %s on %s\n", i ? "second" : "first",
                    side->path, c205_model_name(side->model));
    }
    code = show_next(results, cause_table(runs), "causes", "Causes",
                     CMD_DONE);
    code = show_next(results, region_table(runs), "regions", "Regions", code);
    code = show_next(results, figure_table(runs), "figures", "Figures", code);
    results_gap(results);
    tell_difference(runs, results);
    for (int i = 0; i < SIDES; i++) {
        if (i == FIRST
            || strcmp(c205_model_name(runs->side[i].model),
                      c205_model_name(runs->side[FIRST].model))
                   != 0) {
            results_model(results, runs->side[i].model);
        }
    }
    return code;
}

static int compare(struct two_runs *runs)
{
    struct results results = runs->arguments->results;
    int code;
    for (int i = 0; i < SIDES; i++) {
        if (!read_side(runs, i) || !run_side(runs, i)) {
            return CMD_FAILED;
        }
    }
    if (!results_open(&results, runs->arguments->command, NULL)) {
        return CMD_FAILED;
    }
    code = show(runs, &results);
    return results_close(&results, code);
}

static int run(void *given)
{
    const struct c205_arguments *arguments = given;
    struct two_runs runs = { .arguments = arguments };
    int code;
    if (arguments->files.count == 0 || arguments->files.count > SIDES) {
        return cmd_usage(arguments->command, "name one program or two");
    }
    if (arguments->files.count == 1 && !arguments->other_model
        && arguments->other_defines.count == 0) {
        return cmd_usage(arguments->command,
                         "with what? name a second program, --other-model or "
                         "--other-define");
    }
    code = compare(&runs);
    for (int i = 0; i < SIDES; i++) {
        accounts_free(&runs.side[i].accounts);
        object_free(runs.side[i].object);
        c205_model_free(runs.side[i].model);
    }
    return code;
}

static const struct command_option options[] = {
    CMD_MODEL,
    { .name = "other-model",
      .value = "NAME|FILE",
      .kind = COMMAND_INPUT,
      .offset = CMD_PLACE(other_model),
      .choice = command_model_choice,
      .help = "machine model of the second" },
    CMD_DEFINE,
    { .name = "other-define",
      .value = "NAME=VALUE",
      .kind = COMMAND_OWN,
      .offset = CMD_PLACE(other_defines),
      .take = cmd_take_define,
      .wants = "NAME=VALUE, a name and an integer",
      .help = "an integer for the second program, which has those alone" },
    CMD_FLAG(warm, "all pages are in memory when the programs begin"),
    CMD_INCLUDE,
    CMD_FIGURES,
    COMMAND_END
};
static const struct command_option operands[] = {
    { .value = "FILE",
      .kind = COMMAND_INPUT,
      .many = true,
      .offset = CMD_PLACE(files),
      .help = "two programs, or one with another setting" },
    COMMAND_END
};
static const struct command_example examples[] = {
    { "c205 compare --warm FILE FILE", "what makes one faster" },
    { "c205 compare FILE --other-model cyber205-4pipe",
      "the same program on another machine" },
    { NULL, NULL }
};

const struct command compare_command = {
    .name = "compare",
    .summary = "two programs side by side, and what makes the difference",
    .function = run,
    .options = options,
    .operands = operands,
    .examples = examples,
};
