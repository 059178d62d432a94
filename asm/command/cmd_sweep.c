/* cmd_sweep.c - c205 sweep: measures one or two programs over a range of a constant. */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "asm/command/session.h"
#include "asm/object/object_file.h"
#include "asm/sweep/swept.h"
#include "base/accounts.h"
#include "base/atomic_file.h"
#include "base/file.h"
#include "base/interrupt.h"
#include "base/plural.h"
#include "base/progress.h"
#include "base/text_file.h"
#include "vm/error.h"

/* The constants of a sweep. One has a range, and the others have fixed values. */
struct swept_constants {
    struct cmd_defines fixed;
    const char *name;
    struct swept_range range;
    size_t ranges; /* number of ranges on the command line */
};

struct program_sweep_arguments {
    struct shared_arguments shared;
    struct command_texts files, folders;
    struct swept_constants swept;
    const char *output; /* file name, or NULL */
    size_t point_count;
    bool warm;
};

static double clocks_of(const struct swept_point *point, size_t which)
{
    return (double)accounts_clocks(&point->runs[which]);
}

/* ---- Sentences ------------------------------------------------------------- */

static void print_line(const struct program_sweep *sweep, int which,
                       const struct command_output *results)
{
    struct swept_line line = swept_line_of(sweep, which);
    if (!line.grows) {
        output_printf(results, "The clocks of the %s do not grow with %s.\n",
                      swept_names[which], sweep->constant);
    } else if (!line.good) {
        output_printf(results,
                      "The %s is not a straight line in %s: a line would be %.1f %% "
                      "off at %" PRIu64
                      ". At the end its clocks grow with the power %.2f.\n",
                      swept_names[which], sweep->constant, 100 * line.off, line.off_at,
                      swept_power(sweep, which));
    }
}

static void print_crossings(const struct program_sweep *sweep,
                            const struct command_output *results)
{
    const struct swept_point *begin = sweep->points;
    bool faster = clocks_of(begin, SWEPT_SECOND) < clocks_of(begin, SWEPT_FIRST);
    if (sweep->crossing_count == 0) {
        output_printf(results, "The second is %s, from %" PRIu64 " to %" PRIu64 ".\n",
                      faster ? "faster everywhere" : "nowhere faster",
                      sweep->range.from, sweep->range.to);
    }
    for (size_t i = 0; i < sweep->crossing_count; i++) {
        const struct swept_crossing *crossing = &sweep->crossings[i];
        output_printf(results,
                      "From %s = %" PRIu64 " on the second is %s: %.0f clock%s, "
                      "and the first %.0f.\n",
                      sweep->constant, crossing->at.value,
                      crossing->faster ? "faster" : "not faster any more",
                      clocks_of(&crossing->at, SWEPT_SECOND),
                      plural((uint64_t)clocks_of(&crossing->at, SWEPT_SECOND)),
                      clocks_of(&crossing->at, SWEPT_FIRST));
    }
}

/* ---- Results --------------------------------------------------------------- */

/* Writes the tables of CSV and JSON. Text format has sentences with the same facts
 * instead. */
static int show_rest(const struct program_sweep *sweep,
                     const struct command_output *results)
{
    struct command_output rest = *results;
    int code;
    if (results->format != OUTPUT_CSV)
        rest.file = NULL;
    code = output_show(&rest, swept_causes(sweep), "causes", "Causes");
    if (code == CMD_DONE && sweep->program_count == SWEPT_PROGRAMS)
        code = output_show(&rest, swept_crossings(sweep), "crossings", "Crossings");
    return code;
}

static void show_head(const struct program_sweep *sweep,
                      const struct command_output *results)
{
    if (results->json) {
        json_text(results->json, "constant", sweep->constant);
        json_array(results->json, "programs");
        for (size_t i = 0; i < sweep->program_count; i++)
            json_text(results->json, NULL, sweep->programs[i].path);
        json_end(results->json);
        provenance_json(sweep->model, results->json);
    }
    for (size_t i = 0; i < sweep->program_count; i++) {
        output_printf(results, "%s: %s on %s\n", swept_names[i],
                      sweep->programs[i].path, c205_model_name(sweep->model));
    }
}

static int show(const struct program_sweep *sweep, const struct command_output *results)
{
    int code;
    show_head(sweep, results);
    output_gap(results);
    code = output_show(results, swept_points(sweep), "points", "Points");
    if (code == CMD_DONE) {
        output_gap(results);
        code = output_show(results, swept_lines(sweep), "lines", "Lines");
    }
    if (code == CMD_DONE)
        code = show_rest(sweep, results);
    output_gap(results);
    for (size_t i = 0; i < sweep->program_count; i++)
        print_line(sweep, (int)i, results);
    if (sweep->program_count == SWEPT_PROGRAMS)
        print_crossings(sweep, results);
    output_model(results, sweep->model);
    return code;
}

static bool draw(const struct program_sweep *sweep, const char *path, c205_error *error)
{
    struct atomic_file *whole = atomic_file_open(path, error);
    char title[SWEPT_TITLE];
    struct sink sink;
    if (!whole)
        return false;
    swept_title(sweep, title);
    sink = stream_sink(whole->file);
    if (!swept_svg(sweep, title, &sink, error)) {
        atomic_file_discard(whole);
        return false;
    }
    return atomic_file_commit(whole, error);
}

/* ---- The command ----------------------------------------------------------- */

/* Reads NAME=RANGE for the constant of the sweep, or NAME=VALUE for a fixed
 * constant. */
static bool take_swept(char *text, void *value)
{
    struct swept_constants *swept = value;
    char *equals = strchr(text, '=');
    if (!equals || !strchr(equals, ':'))
        return cmd_take_define(text, &swept->fixed);
    if (equals == text || !swept_take_range(equals + 1, &swept->range))
        return false;
    *equals = '\0';
    swept->name = text;
    swept->ranges++;
    return true;
}

static bool read_text(const struct program_sweep_arguments *args,
                      struct swept_program *program, const char *path)
{
    c205_error error;
    char *text = text_file_read(path, FILE_LARGEST, &program->length, &error);
    program->path = path;
    program->text = text;
    if (text && object_recognise(text, program->length)) {
        error_set(&error, "the constants of an object are fixed; use its program text");
        program->text = NULL;
        free(text);
    }
    if (!program->text)
        cmd_failed(args->shared.command, "%s: %s", path, error.message);
    return program->text;
}

static bool run_and_draw(const struct program_sweep_arguments *args,
                         struct program_sweep *sweep, c205_error *error)
{
    const char *output = args->output;
    struct progress progress;
    bool good;
    interrupt_catch();
    progress_begin(&progress);
    sweep->goes_on = progress_watch;
    sweep->context = &progress;
    good = (!output || atomic_file_check(output, error)) && swept_run(sweep, error)
           && (!output || draw(sweep, output, error));
    progress_hide(&progress);
    return good;
}

/* Runs the sweep and prints its results. The output files are opened only here, after
 * all programs were read, so an error in a program leaves them unchanged. */
static int run_and_show(struct session *session,
                        const struct program_sweep_arguments *args,
                        struct program_sweep *sweep)
{
    c205_error error;
    if (!session_output(session, &args->shared.results, args->output))
        return CMD_FAILED;
    return run_and_draw(args, sweep, &error)
               ? show(sweep, &session->results)
               : cmd_failed(session->command, "%s", error.message);
}

static int sweep_programs(struct session *session,
                          const struct program_sweep_arguments *args)
{
    const struct swept_constants *swept = &args->swept;
    struct asm_options options = { .defines = swept->fixed.items,
                                   .search = args->folders.items };
    struct program_sweep sweep = { .constant = swept->name,
                                   .range = swept->range,
                                   .asked = args->point_count,
                                   .program_count = args->files.count,
                                   .model = session->model,
                                   .options = &options,
                                   .warm = args->warm,
                                   .clocks_most = CMD_LIMIT,
                                   .report = visible_stream(stderr) };
    bool good = true;
    int code;
    for (size_t i = 0; good && i < sweep.program_count; i++)
        good = read_text(args, &sweep.programs[i], args->files.items[i]);
    code = good ? run_and_show(session, args, &sweep) : CMD_FAILED;
    for (size_t i = 0; i < sweep.program_count; i++)
        free((char *)sweep.programs[i].text);
    swept_free(&sweep);
    return code;
}

static int check_values(const struct program_sweep_arguments *args)
{
    const struct swept_constants *swept = &args->swept;
    uint64_t values[MAX_SWEPT_POINTS];
    size_t count;
    if (swept->ranges != 1) {
        return cmd_usage(args->shared.command,
                         swept->ranges == 0
                             ? "a range is missing: --define NAME=FROM:TO"
                             : "expected one constant with a range, found %zu",
                         swept->ranges);
    }
    if (cmd_is_defined(&swept->fixed, swept->name)) {
        return cmd_usage(args->shared.command, "%s has both a range and a value",
                         swept->name);
    }
    if (args->point_count > 0 && (swept->range.step > 0 || swept->range.factor > 0)) {
        return cmd_usage(args->shared.command,
                         "--points cannot be combined with a STEP or xFACTOR");
    }
    count = swept_values(&swept->range, args->point_count, values);
    if (count == 0) {
        return cmd_usage(args->shared.command, "the range has more than %d values",
                         MAX_SWEPT_POINTS);
    }
    return count > 1 ? CMD_DONE
                     : cmd_usage(args->shared.command, "the range has only one value");
}

static int cmd_sweep(void *given)
{
    const struct program_sweep_arguments *args = given;
    struct session session = { .command = args->shared.command };
    const char *output = args->output;
    int code;
    if (args->files.count == 0 || args->files.count > SWEPT_PROGRAMS)
        return cmd_usage(args->shared.command, "expected one or two programs");
    code = check_values(args);
    if (code != CMD_DONE)
        return code;
    if (output && !file_is_stream(output) && !file_ends_with(output, ".svg")) {
        return cmd_usage(args->shared.command,
                         "%s: the name of a picture must end in .svg", output);
    }
    bool good = session_model(&session, args->shared.model);
    return session_close(&session, good ? sweep_programs(&session, args) : CMD_FAILED);
}

#define PLACE(member) offsetof(struct program_sweep_arguments, member)

static const struct command_option options[] = {
    { OPTION_ROW(
          "define", "NAME=RANGE|VALUE", COMMAND_CUSTOM, PLACE(swept),
          "the constant and its range, FROM:TO[:STEP|:xFACTOR]; or a fixed integer"),
      .take = take_swept,
      .wants = "NAME=FROM:TO, FROM:TO:STEP, FROM:TO:xFACTOR, from 1 on and "
               "rising; or NAME=VALUE, an integer" },
    { OPTION_ROW("points", "NUMBER", COMMAND_COUNT, PLACE(point_count),
                 "number of values in FROM:TO, at a constant ratio"),
      .least = 2, .most = MAX_SWEPT_POINTS, .preset_text = "8 per octave, at most 25" },
    OPTION_OUTPUT(PLACE(output), "draw a picture, .svg"),
    CMD_MODEL,
    OPTION_FLAG("warm", PLACE(warm), "all pages are in memory when the programs begin"),
    OPTION_INCLUDE(PLACE(folders)),
    CMD_FIGURES,
    COMMAND_END
};
static const struct command_option operands[] = {
    { OPERAND_ROW("FILE", COMMAND_INPUT, PLACE(files), "one or two program texts"),
      .many = true },
    COMMAND_END
};
static const struct command_example examples[] = {
    { "c205 sweep FILE --define n=8:65535 -o x.svg",
      "start-up, r-infinity and n-half" },
    { "c205 sweep --warm FILE FILE --define n=1:1000",
      "find the length from which the second is faster" },
    { NULL, NULL }
};

const struct command sweep_command = {
    COMMAND_ROW("sweep", cmd_sweep, struct program_sweep_arguments,
                "measure one or two programs over a range of a constant"),
    .examples = examples,
    .details =
        "A program can give NAME a value of its own between .ifndef NAME and .endif. "
        "With STEP or xFACTOR only the values of the range are run. Otherwise any "
        "integer in it may be run to find where the faster program changes.",
};
