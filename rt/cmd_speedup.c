/* cmd_speedup.c - rt205 speedup: the paper's Table 1 beside our own. */
#include <stdio.h>

#include "asm/provenance.h"
#include "rt/cmd.h"
#include "rt/speedup_report.h"

static bool measure_subject(const struct cmd_arguments *arguments,
                            const struct speedup_subject *subject,
                            struct speedup_report *report,
                            c205_error *error)
{
    struct trace_options options = arguments->trace;
    struct speedup_measure measures[TRACE_FORMS];

    for (int mode = 0; mode < TRACE_FORMS; mode++) {
        options.mode = (enum trace_mode)mode;
        if (!speedup_measure(subject, &arguments->view, &options,
                             &measures[mode], error))
            return false;
    }
    if (measures[TRACE_SCALAR].checksum != measures[TRACE_VECTOR].checksum) {
        snprintf(error->message, sizeof error->message,
                 "%s: the scalar and the vector form do not agree",
                 subject->name);
        return false;
    }
    speedup_report_add(report, subject, &arguments->view, measures);
    return true;
}

static void print_head(const struct cmd_arguments *arguments)
{
    const struct trace_options *trace = &arguments->trace;

    printf("%zu x %zu rays, %g degrees across from a distance of %g, in a "
           "queue of %zu; the kernel and its calls alone.\n"
           "%s\n"
           "Paper: Plunkett, Cychosz and Bailey 1984, Table 1, CYBER 205, "
           "100,000 rays; scaled to the rays here.\n",
           trace->width, trace->height, arguments->view.angle,
           arguments->view.distance, trace->queue,
           provenance_note(trace->model));
    provenance_print(trace->model);
}

static void write_head(const struct cmd_arguments *arguments,
                       struct json *json)
{
    provenance_json(arguments->trace.model, json);
    json_count(json, "queue", arguments->trace.queue);
    json_number(json, "distance", arguments->view.distance);
    json_number(json, "angle", arguments->view.angle);
}

static int speedup(const struct cmd_arguments *arguments, struct json *json)
{
    struct speedup_report *report =
        speedup_report_new(arguments->trace.model);
    c205_error error = { "no memory" };
    bool good = report != NULL;

    print_head(arguments);
    for (size_t i = 0; good && i < speedup_subject_count; i++)
        good = measure_subject(arguments, &speedup_subjects[i], report,
                               &error);
    if (good)
        puts("In each row the scalar and the vector frame are equal, bit "
             "for bit.");
    good = good
           && speedup_report_print(report, arguments->passes, stdout);
    if (good && json != NULL) {
        write_head(arguments, json);
        speedup_report_json(report, json);
    }
    speedup_report_free(report);
    return good ? CMD_DONE
                : cmd_failed(arguments->command, "%s", error.message);
}

int cmd_speedup(struct cmd_arguments *arguments)
{
    return cmd_with_machine(arguments, speedup);
}
