/* cmd_speedup.c - rt205 speedup: compares the measured speedups of vector programs with
 * Table 1 of the tracer's 1984 paper. */
#include <stdio.h>
#include <stdlib.h>

#include "base/provenance.h"
#include "rt/command/session.h"
#include "rt/study/formulations.h"
#include "rt/study/speedup_report.h"

struct speedup_arguments {
    struct trace_arguments shared;
    struct speedup_view view;
    bool details, passes, formulations;
    struct command_texts rows; /* names of rows; none: all rows */
};

static void print_head(const struct speedup_arguments *args,
                       const struct command_output *results)
{
    const struct trace_options *trace = &args->shared.trace;
    output_printf(results,
                  "%zu x %zu rays, %g degrees across from a distance of %g, "
                  "in a queue of %zu\n",
                  trace->width, trace->height, args->view.angle, args->view.distance,
                  trace->queue);
    if (args->details)
        output_printf(results,
                      "The kernel and its calls alone.  Paper: Plunkett, "
                      "Cychosz and Bailey 1984.\n"
                      "CYBER 720: the instructions of the scalar form at the "
                      "times of the model %s.\n",
                      speedup_projection_model(trace->model, SPEEDUP_720));
}

static c205_model *find_projection(const struct speedup_arguments *args, int i,
                                   c205_error *error)
{
    return c205_model_find(speedup_projection_model(args->shared.trace.model,
                                                    (enum speedup_projection)i),
                           error);
}

/* Prints the models of the first `count` projections. Table 1 needs only the first
 * model. */
static bool print_projections(const struct speedup_arguments *args, int count,
                              const struct command_output *results, c205_error *error)
{
    for (int i = 0; i < count; i++) {
        c205_model *model = find_projection(args, i, error);
        if (!model)
            return false;
        if (results->provenance)
            output_printf(results, "\n");
        output_model(results, model);
        c205_model_free(model);
    }
    return true;
}

static bool write_projections(const struct speedup_arguments *args, int count,
                              struct json *json, c205_error *error)
{
    json_array(json, "projections");
    for (int i = 0; i < count; i++) {
        c205_model *model = find_projection(args, i, error);
        if (!model)
            return false;
        json_object(json, NULL);
        provenance_json(model, json);
        json_end(json);
        c205_model_free(model);
    }
    json_end(json);
    return true;
}

static bool print(const struct speedup_arguments *args,
                  const struct speedup_report *report,
                  const struct command_output *results, c205_error *error)
{
    enum table_format format = output_table_format(results);
    int projections = args->details ? SPEEDUP_PROJECTIONS : SPEEDUP_720 + 1;
    print_head(args, results);
    if (!speedup_report_table1(report, format, results->file))
        return false;
    putc('\n', results->file);
    if (args->details)
        output_printf(results, "In each row the scalar and the vector frame "
                               "are equal, bit for bit.\n");
    output_model(results, args->shared.trace.model);
    return print_projections(args, projections, results, error)
           && (!args->details || speedup_report_detail(report, format, results->file))
           && (!args->passes || speedup_report_passes(report, format, results->file));
}

/* Writes the model, the projections to other machines, and the view of the
 * primitives. */
static bool write_head(const struct speedup_arguments *args, int projections,
                       struct json *json, c205_error *error)
{
    provenance_json(args->shared.trace.model, json);
    if (!write_projections(args, projections, json, error))
        return false;
    json_count(json, "queue", args->shared.trace.queue);
    json_number(json, "distance", args->view.distance);
    json_number(json, "angle", args->view.angle);
    json_bool(json, "equal_frames", true);
    return true;
}

static bool write_json(const struct speedup_arguments *args,
                       const struct speedup_report *report, struct json *json,
                       c205_error *error)
{
    return write_head(args, SPEEDUP_PROJECTIONS, json, error)
           && speedup_report_json(report, json);
}

/* Lists the requested rows in the order of the table. Returns the number of rows. */
static size_t choose(const struct speedup_arguments *args,
                     struct speedup_subject *chosen)
{
    const struct command_texts *rows = &args->rows;
    size_t count = 0;
    for (size_t i = 0; i < speedup_subject_count; i++) {
        bool wanted = rows->count == 0;
        for (size_t j = 0; j < rows->count && !wanted; j++)
            wanted = speedup_is_named(&speedup_subjects[i], rows->items[j]);
        if (wanted)
            chosen[count++] = speedup_subjects[i];
    }
    return count;
}

static bool measure_all(const struct speedup_arguments *args,
                        struct speedup_report *report, c205_error *error)
{
    struct speedup_subject *chosen = calloc(speedup_subject_count, sizeof *chosen);
    struct speedup_measure(*measures)[TRACE_FORMS] = calloc(speedup_subject_count,
                                                            sizeof *measures);
    size_t count = chosen ? choose(args, chosen) : 0;
    bool good = chosen && measures
                && speedup_measure_all(chosen, count, &args->view, &args->shared.trace,
                                       measures, error);
    for (size_t i = 0; good && i < count; i++)
        speedup_report_add(report, &chosen[i], &args->view, measures[i]);
    free(measures);
    free(chosen);
    return good;
}

static int speedup(const struct speedup_arguments *args,
                   const struct command_output *results)
{
    struct speedup_report *report = speedup_report_new(args->shared.trace.model);
    c205_error error = { "out of memory" };
    bool good;
    good = report && measure_all(args, report, &error)
           && (!results->file || print(args, report, results, &error))
           && (!results->json || write_json(args, report, results->json, &error));
    speedup_report_free(report);
    return good ? CMD_DONE : cmd_failed(args->shared.command, "%s", error.message);
}

/* ---- Formulations of the cylinder ---------------------------------------- */

static bool print_formulations(const struct speedup_arguments *args,
                               const struct table *table,
                               const struct command_output *results, c205_error *error)
{
    if (results->file) {
        enum table_format format = output_table_format(results);
        print_head(args, results);
        table_heading("Table 1's cylinder in other formulations, CPU seconds "
                      "for 100,000 rays",
                      format, results->file);
        if (!table_write(table, format, results->file))
            return false;
        putc('\n', results->file);
        output_model(results, args->shared.trace.model);
        if (!print_projections(args, SPEEDUP_720 + 1, results, error))
            return false;
    }
    return !results->json
           || (write_head(args, SPEEDUP_720 + 1, results->json, error)
               && table_json(table, results->json, "formulations"));
}

static int formulations(const struct speedup_arguments *args,
                        const struct command_output *results)
{
    struct speedup_measure(*measures)[TRACE_FORMS] = calloc(speedup_formulation_count,
                                                            sizeof *measures);
    struct table *table = NULL;
    c205_error error = { "out of memory" };
    bool good;
    if (measures
        && speedup_measure_all(speedup_formulations, speedup_formulation_count,
                               &args->view, &args->shared.trace, measures, &error))
        table = formulations_table(args->shared.trace.model,
                                   (const struct speedup_measure(*)[TRACE_FORMS])
                                       measures);
    good = table && print_formulations(args, table, results, &error);
    table_free(table);
    free(measures);
    return good ? CMD_DONE : cmd_failed(args->shared.command, "%s", error.message);
}

/* ---- The command --------------------------------------------------------- */

static int cmd_speedup(void *given)
{
    struct speedup_arguments *args = given;
    const struct command_texts *rows = &args->rows;
    struct trace_session session;
    int code;
    for (size_t i = 0; i < rows->count; i++)
        if (!speedup_subject_named(rows->items[i]))
            return cmd_usage(args->shared.command,
                             "unknown row '%s' of Table 1: expected sphere, "
                             "cylinder, Steiner or torus",
                             rows->items[i]);
    if (rows->count > 0 && args->formulations)
        return cmd_usage(args->shared.command,
                         "--formulations cannot be combined with names of rows: it "
                         "compares forms of the cylinder");
    code = session_open(&session, &args->shared, NULL);
    if (code == CMD_DONE)
        code = args->formulations ? formulations(args, &session.results)
                                  : speedup(args, &session.results);
    return session_close(&session, code);
}

#define PLACE(member) offsetof(struct speedup_arguments, member)

static const struct command_option options[] = {
    CMD_SIZE(400, 250),
    CMD_VIEW(PLACE(view), SPEEDUP_ANGLE, NULL),
    CMD_QUEUE("rays in the vector queue"),
    OPTION_FLAG(
        "details", PLACE(details),
        "also clocks by cause, the steps of the root solver, and a machine that "
        "Table 1 lacks"),
    OPTION_FLAG("passes", PLACE(passes),
                "also the vectors of the root solver, pass by pass"),
    OPTION_FLAG("formulations", PLACE(formulations),
                "compare formulations of the cylinder instead of Table 1"),
    CMD_MODEL,
    CMD_JOBS("frames traced at a time"),
    CMD_RESULTS,
    COMMAND_END
};

static const char *row_choice(size_t number)
{
    return number < speedup_subject_count ? speedup_subjects[number].name : NULL;
}

static const struct command_option operands[] = {
    { OPERAND_ROW("ROW", COMMAND_TEXT, PLACE(rows),
                  "a primitive of the table, with or without the text after its comma; "
                  "default: all"),
      .many = true, .optional = true, .choice = row_choice },
    COMMAND_END
};

const struct command speedup_command = {
    COMMAND_ROW("speedup", cmd_speedup, struct speedup_arguments,
                "scalar against vector, kernel by kernel"),
    .details =
        "Compares the paper's Table 1 with the emulator: 100,000 rays against a "
        "sphere, a cylinder, a Steiner patch, and more. Checks that the scalar and "
        "the vector frame of each are equal, bit for bit. The CYBER 720 is projected "
        "with cyber720, or with cyber720-prior if the machine model has no fitted "
        "constant.",
};
