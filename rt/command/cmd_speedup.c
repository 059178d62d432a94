/* cmd_speedup.c - rt205 speedup: compares the paper's Table 1 with this project's. */
#include <stdio.h>
#include <stdlib.h>

#include "base/provenance.h"
#include "rt/command/rt205_command.h"
#include "rt/study/formulations.h"
#include "rt/study/speedup_report.h"

static void print_head(const struct rt205_arguments *arguments,
                       const struct command_output *results)
{
    const struct trace_options *trace = &arguments->trace;

    output_printf(results,
                  "%zu x %zu rays, %g degrees across from a distance of %g, "
                  "in a queue of %zu\n",
                  trace->width, trace->height, arguments->view.angle,
                  arguments->view.distance, trace->queue);
    if (arguments->details)
        output_printf(results,
                      "The kernel and its calls alone.  Paper: Plunkett, "
                      "Cychosz and Bailey 1984.\n"
                      "CYBER 720: the instructions of the scalar form at the "
                      "times of the model %s.\n",
                      speedup_projection_model(trace->model, SPEEDUP_720));
}

/* Calls print_result for the models of the first count projections. Table 1 needs only
 * the first. */
static bool each_projection(const struct rt205_arguments *arguments, int count,
                            void (*print_result)(const c205_model *model,
                                                 void *context),
                            void *context, c205_error *error)
{
    for (int i = 0; i < count; i++) {
        const char *name = speedup_projection_model(arguments->trace.model,
                                                    (enum speedup_projection)i);
        c205_model *model = c205_model_find(name, error);

        if (!model)
            return false;
        print_result(model, context);
        c205_model_free(model);
    }
    return true;
}

static void write_projection(const c205_model *model, void *context)
{
    struct json *json = context;

    json_object(json, NULL);
    provenance_json(model, json);
    json_end(json);
}

static void print_projection(const c205_model *model, void *context)
{
    const struct command_output *results = context;

    if (results->provenance)
        output_printf(results, "\n");
    output_model(results, model);
}

static bool print(const struct rt205_arguments *arguments,
                  const struct speedup_report *report,
                  const struct command_output *results, c205_error *error)
{
    enum table_format format = output_table_format(results);
    struct command_output printed = *results;
    int projections = arguments->details ? SPEEDUP_PROJECTIONS : SPEEDUP_720 + 1;

    print_head(arguments, results);
    if (!speedup_report_table1(report, format, results->file))
        return false;
    putc('\n', results->file);
    if (arguments->details)
        output_printf(results, "In each row the scalar and the vector frame "
                               "are equal, bit for bit.\n");
    output_model(results, arguments->trace.model);
    return each_projection(arguments, projections, print_projection, &printed, error)
           && (!arguments->details
               || speedup_report_detail(report, format, results->file))
           && (!arguments->passes
               || speedup_report_passes(report, format, results->file));
}

/* Writes the model, the projections and the view of a measurement. */
static bool write_head(const struct rt205_arguments *arguments, int projections,
                       struct json *json, c205_error *error)
{
    bool good;

    provenance_json(arguments->trace.model, json);
    json_array(json, "projections");
    good = each_projection(arguments, projections, write_projection, json, error);
    json_end(json);
    json_count(json, "queue", arguments->trace.queue);
    json_number(json, "distance", arguments->view.distance);
    json_number(json, "angle", arguments->view.angle);
    json_bool(json, "equal_frames", true);
    return good;
}

static bool write_json(const struct rt205_arguments *arguments,
                       const struct speedup_report *report, struct json *json,
                       c205_error *error)
{
    return write_head(arguments, SPEEDUP_PROJECTIONS, json, error)
           && speedup_report_json(report, json);
}

/* Lists the requested rows in the order of the table. Returns their number. */
static size_t choose(const struct rt205_arguments *arguments,
                     struct speedup_subject *chosen)
{
    const struct command_texts *rows = &arguments->rows;
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

static bool measure_all(const struct rt205_arguments *arguments,
                        struct speedup_report *report, c205_error *error)
{
    struct speedup_subject *chosen = calloc(speedup_subject_count, sizeof *chosen);
    struct speedup_measure(*measures)[TRACE_FORMS] = calloc(speedup_subject_count,
                                                            sizeof *measures);
    size_t count = chosen ? choose(arguments, chosen) : 0;
    bool good = chosen && measures
                && speedup_measure_all(chosen, count, &arguments->view,
                                       &arguments->trace, measures, error);

    for (size_t i = 0; good && i < count; i++)
        speedup_report_add(report, &chosen[i], &arguments->view, measures[i]);
    free(measures);
    free(chosen);
    return good;
}

static int speedup(const struct rt205_arguments *arguments,
                   const struct command_output *results)
{
    struct speedup_report *report = speedup_report_new(arguments->trace.model);
    c205_error error = { "out of memory" };
    bool good;

    good = report && measure_all(arguments, report, &error)
           && (!results->file || print(arguments, report, results, &error))
           && (!results->json || write_json(arguments, report, results->json, &error));
    speedup_report_free(report);
    return good ? CMD_DONE : cmd_failed(arguments->command, "%s", error.message);
}

/* ---- Formulations of the cylinder ---------------------------------------- */

static bool print_formulations(const struct rt205_arguments *arguments,
                               const struct table *table,
                               const struct command_output *results, c205_error *error)
{
    struct command_output printed = *results;

    if (results->file) {
        enum table_format format = output_table_format(results);

        print_head(arguments, results);
        table_heading("Table 1's cylinder in other formulations, CPU seconds "
                      "for 100,000 rays",
                      format, results->file);
        if (!table_write(table, format, results->file))
            return false;
        putc('\n', results->file);
        output_model(results, arguments->trace.model);
        if (!each_projection(arguments, SPEEDUP_720 + 1, print_projection, &printed,
                             error))
            return false;
    }
    return !results->json
           || (write_head(arguments, SPEEDUP_720 + 1, results->json, error)
               && table_json(table, results->json, "formulations"));
}

static int formulations(const struct rt205_arguments *arguments,
                        const struct command_output *results)
{
    struct speedup_measure(*measures)[TRACE_FORMS] = calloc(speedup_formulation_count,
                                                            sizeof *measures);
    struct table *table = NULL;
    c205_error error = { "out of memory" };
    bool good;

    if (measures
        && speedup_measure_all(speedup_formulations, speedup_formulation_count,
                               &arguments->view, &arguments->trace, measures, &error))
        table = formulations_table(arguments->trace.model,
                                   (const struct speedup_measure(*)[TRACE_FORMS])
                                       measures);
    good = table && print_formulations(arguments, table, results, &error);
    table_free(table);
    free(measures);
    return good ? CMD_DONE : cmd_failed(arguments->command, "%s", error.message);
}

/* ---- The command --------------------------------------------------------- */

static bool is_row(const char *name)
{
    for (size_t i = 0; i < speedup_subject_count; i++)
        if (speedup_is_named(&speedup_subjects[i], name))
            return true;
    return false;
}

static int run_command_line(void *given)
{
    struct rt205_arguments *arguments = given;
    const struct command_texts *rows = &arguments->rows;

    for (size_t i = 0; i < rows->count; i++)
        if (!is_row(rows->items[i]))
            return cmd_usage(arguments->command,
                             "unknown row '%s' of Table 1: expected sphere, "
                             "cylinder, Steiner or torus",
                             rows->items[i]);
    if (rows->count > 0 && arguments->formulations)
        return cmd_usage(arguments->command,
                         "--formulations cannot be combined with names of rows: it "
                         "compares forms of the cylinder");
    return cmd_with_machine(arguments,
                            arguments->formulations ? formulations : speedup);
}

static const struct command_option options[] = {
    CMD_SIZE(400, 250),
    CMD_VIEW(SPEEDUP_ANGLE, NULL),
    CMD_QUEUE("rays in the vector queue"),
    CMD_FLAG("details", details,
             "also clocks by cause, the steps of the root solver, and a machine that "
             "Table 1 lacks"),
    CMD_FLAG("passes", passes, "also the vectors of the root solver, pass by pass"),
    CMD_FLAG("formulations", formulations,
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
    { .value = "ROW",
      .kind = COMMAND_TEXT,
      .many = true,
      .optional = true,
      .offset = CMD_PLACE(rows),
      .choice = row_choice,
      .help = "a primitive of the table, with or without the text after its comma; "
              "default: all" },
    COMMAND_END
};

const struct command speedup_command = {
    .name = "speedup",
    .summary = "scalar against vector, kernel by kernel",
    .function = run_command_line,
    .arguments_size = sizeof(struct rt205_arguments),
    .options = options,
    .operands = operands,
    .details =
        "Compares the paper's Table 1 with the emulator: 100,000 rays against a "
        "sphere, a cylinder, a Steiner patch, and more. Checks that the scalar and "
        "the vector frame of each are equal, bit for bit. The CYBER 720 is projected "
        "with cyber720, or with cyber720-prior if the machine model has no fitted "
        "constant.",
};
