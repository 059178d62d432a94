/* cmd_speedup.c - rt205 speedup: the paper's Table 1 beside our own. */
#include <math.h>
#include <stdio.h>

#include "asm/accounts.h"
#include "asm/provenance.h"
#include "rt/cmd.h"
#include "rt/speedup.h"

static const struct table_column times[] = {
    { "primitive", "primitive", TABLE_TEXT, 0 },
    { "form", "form", TABLE_TEXT, 0 },
    { "clocks", "clocks", TABLE_COUNT, 0 },
    { "clocks_per_ray", "clocks/ray", TABLE_NUMBER, 2 },
    { "seconds", "seconds", TABLE_NUMBER, 4 },
    { "paper_seconds", "paper: seconds", TABLE_NUMBER, 4 },
    { "ratio", "ours/paper", TABLE_NUMBER, 2 },
    { "speedup", "speedup", TABLE_NUMBER, 2 },
    { "paper_speedup", "paper: speedup", TABLE_NUMBER, 2 },
};
enum { TIMES = sizeof times / sizeof *times };

static const struct table_column causes[] = {
    { "primitive", "primitive", TABLE_TEXT, 0 },
    { "form", "form", TABLE_TEXT, 0 },
    { "cause", "cause", TABLE_TEXT, 0 },
    { "clocks", "clocks", TABLE_COUNT, 0 },
    { "percent", "%", TABLE_NUMBER, 1 },
};
enum { CAUSE_COLUMNS = sizeof causes / sizeof *causes };

/* All figures of the command, and the two tables they go to. */
struct show {
    const struct cmd_arguments *arguments;
    struct table *times, *causes;
};

static void add_times(struct show *show,
                      const struct speedup_subject *subject, int mode,
                      const struct speedup_measure measures[TRACE_MODES])
{
    const struct speedup_measure *measure = &measures[mode];
    double seconds = accounts_seconds(show->arguments->trace.model,
                                      measure->total);
    double paper = subject->paper[mode] * (double)measure->rays / 1e5;
    bool vector = mode == TRACE_VECTOR;

    table_text(show->times, subject->primitive);
    table_text(show->times, trace_mode_name((enum trace_mode)mode));
    table_count(show->times, measure->total);
    table_number(show->times,
                 (double)measure->total / (double)measure->rays);
    table_number(show->times, seconds);
    table_number(show->times, paper);
    table_number(show->times, seconds / paper);
    table_number(show->times, vector ? (double)measures[TRACE_SCALAR].total
                                           / (double)measure->total
                                     : NAN);
    table_number(show->times, vector ? subject->paper_speedup : NAN);
}

static void add_causes(struct show *show,
                       const struct speedup_subject *subject, int mode,
                       const struct speedup_measure *measure)
{
    for (int cause = 0; cause < C205_CAUSES; cause++) {
        if (measure->clocks[cause] == 0)
            continue;
        table_text(show->causes, subject->primitive);
        table_text(show->causes, trace_mode_name((enum trace_mode)mode));
        table_text(show->causes, c205_cause_name((c205_cause)cause));
        table_count(show->causes, measure->clocks[cause]);
        table_number(show->causes, 100.0 * (double)measure->clocks[cause]
                                       / (double)measure->total);
    }
}

static bool measure_subject(struct show *show,
                            const struct speedup_subject *subject,
                            struct json *json, c205_error *error)
{
    struct trace_options options = show->arguments->trace;
    struct speedup_measure measures[TRACE_MODES];

    for (int mode = 0; mode < TRACE_MODES; mode++) {
        options.mode = (enum trace_mode)mode;
        if (!speedup_measure(subject, &options, &measures[mode], error))
            return false;
        add_causes(show, subject, mode, &measures[mode]);
    }
    if (measures[TRACE_SCALAR].checksum != measures[TRACE_VECTOR].checksum) {
        snprintf(error->message, sizeof error->message,
                 "%s: the scalar and the vector form do not agree",
                 subject->primitive);
        return false;
    }
    for (int mode = 0; mode < TRACE_MODES; mode++)
        add_times(show, subject, mode, measures);
    printf("%s: %zu rays, %.1f %% hit; scalar and vector frames are equal\n",
           subject->primitive, measures[TRACE_VECTOR].rays,
           100.0 * (double)measures[TRACE_VECTOR].hits
               / (double)measures[TRACE_VECTOR].rays);
    if (json != NULL) {
        json_object(json, subject->primitive);
        json_count(json, "rays", measures[TRACE_VECTOR].rays);
        json_count(json, "hits", measures[TRACE_VECTOR].hits);
        json_end(json);
    }
    return true;
}

static bool print_tables(const struct show *show, struct json *json)
{
    putchar('\n');
    if (!table_print(show->times, stdout))
        return false;
    puts("\nWhere the clocks went:\n");
    if (!table_print(show->causes, stdout))
        return false;
    if (json != NULL) {
        provenance_json(show->arguments->trace.model, json);
        json_count(json, "queue", show->arguments->trace.queue);
        table_json(show->times, json, "times");
        table_json(show->causes, json, "causes");
    }
    return true;
}

static int speedup(const struct cmd_arguments *arguments, struct json *json)
{
    struct show show = { arguments, table_new(times, TIMES),
                         table_new(causes, CAUSE_COLUMNS) };
    c205_error error = { "no memory" };
    bool good = show.times != NULL && show.causes != NULL;

    printf("%zu x %zu rays, a queue of %zu; the kernel and its calls alone.\n"
           "Unfitted figures: the model's constants are priors, not yet "
           "fitted to the paper.\n"
           "Paper: Plunkett, Cychosz and Bailey 1984, Table 1, CYBER 205, "
           "100,000 rays; scaled to the rays here.\n",
           arguments->trace.width, arguments->trace.height,
           arguments->trace.queue);
    provenance_print(arguments->trace.model);
    putchar('\n');
    for (size_t i = 0; good && i < speedup_subject_count; i++)
        good = measure_subject(&show, &speedup_subjects[i], json, &error);
    good = good && print_tables(&show, json);
    table_free(show.times);
    table_free(show.causes);
    return good ? CMD_DONE
                : cmd_failed(arguments->command, "%s", error.message);
}

int cmd_speedup(struct cmd_arguments *arguments)
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
    code = speedup(arguments, json);
    if (json != NULL && code != CMD_DONE)
        json_discard(json);
    else if (json != NULL && !json_close(json, &error))
        code = cmd_failed(arguments->command, "%s", error.message);
    c205_model_free(model);
    return code;
}
