/* cmd_render.c - rt205 render: traces a scene, writes a picture, and reports the
 * clocks. */
#include <stdio.h>

#include "base/accounts_show.h"
#include "base/error.h"
#include "base/interrupt.h"
#include "base/plural.h"
#include "base/provenance.h"
#include "rt/command/rt205_command.h"
#include "rt/view/frame_profile.h"

static bool write_rows(const struct trace_options *options, const struct trace *trace,
                       struct picture *picture, struct picture_error *why)
{
    struct frame part;
    size_t rows = options->height < PICTURE_PART ? options->height : PICTURE_PART;
    bool good = frame_allocate(&part, options->width, rows);

    snprintf(why->message, sizeof why->message, "out of memory for the picture");
    for (size_t row = 0; good && row < options->height; row += PICTURE_PART) {
        if (options->height - row < PICTURE_PART)
            part.height = options->height - row;
        trace_read(trace, row, &part);
        good = picture_rows(picture, &part, why);
    }
    frame_free(&part);
    return good;
}

static bool write_picture(const struct rt205_arguments *arguments,
                          const struct trace *trace, c205_error *error)
{
    const struct accounts *accounts = trace_accounts(trace);
    bool whole = trace_rows_done(trace) == arguments->trace.height;
    const struct trace_options *options = &arguments->trace;
    struct picture *picture;
    struct picture_error why;
    char clocks[32], rows[48];
    const struct picture_note notes[] = {
        { "Software", "rt205 " C205_VERSION },
        { "rt205:scene", arguments->scene },
        { "rt205:model", c205_model_name(accounts->model) },
        { "rt205:mode", trace_mode_name(arguments->trace.mode) },
        { "rt205:clocks", clocks },
        { whole ? NULL : "rt205:rows", rows },
        { NULL, NULL },
    };
    bool good;

    snprintf(clocks, sizeof clocks, "%llu", (unsigned long long)accounts->clocks);
    snprintf(rows, sizeof rows, "%zu of %zu", trace_rows_done(trace),
             arguments->trace.height);
    picture = picture_begin(arguments->output, options->width, options->height, notes,
                            arguments->half, NULL, &why);
    good = picture && write_rows(options, trace, picture, &why);
    good = picture && picture_end(picture, good, &why);
    if (!good)
        error_set(error, "%s", why.message);
    return good;
}

/* ---- Report of a frame --------------------------------------------------- */

/* The results of a run, which are printed as lines, a table or JSON. */
struct result {
    const struct rt205_arguments *arguments;
    const c205_model *model;
    uint64_t clocks;
    size_t samples;    /* rays of a pixel, across and down */
    size_t rays, hits; /* camera rays; pixels that show something */
    char checksum[17];
};

static struct result result_of(const struct rt205_arguments *arguments,
                               const struct trace *trace)
{
    const struct accounts *accounts = trace_accounts(trace);
    struct result result = { .arguments = arguments,
                             .model = accounts->model,
                             .clocks = accounts->clocks,
                             .samples = trace_samples(trace),
                             .rays = (size_t)trace_rays(trace, RAY_PRIMARY),
                             .hits = trace_hits(trace) };

    snprintf(result.checksum, sizeof result.checksum, "%016llX",
             (unsigned long long)trace_checksum(trace));
    return result;
}

/* Prints the number of rays that a threshold saves. */
static void print_rays(const struct result *result,
                       const struct command_output *results)
{
    const struct trace_options *trace = &result->arguments->trace;
    double all = (double)trace->width * (double)trace->height
                 * (double)(result->samples * result->samples);

    output_printf(results,
                  "threshold %g: %zu ray%s of the camera, %.1f %% of those of "
                  "all samples\n",
                  trace->threshold, result->rays, plural(result->rays),
                  100 * (double)result->rays / all);
}

static void print_result(const struct result *result,
                         const struct command_output *results)
{
    const struct rt205_arguments *arguments = result->arguments;
    const struct trace_options *trace = &arguments->trace;
    bool sampled = result->samples > 1;
    size_t tried = sampled ? trace->width * trace->height : result->rays;
    char queue[48] = "", samples[64] = "", time[ACCOUNTS_TIME];

    if (sampled)
        snprintf(samples, sizeof samples, " of %zu x %zu rays", result->samples,
                 result->samples);
    if (trace->mode != TRACE_SCALAR)
        snprintf(queue, sizeof queue, ", a queue of %zu", trace->queue);
    accounts_time(result->model, result->clocks, time);
    output_printf(results, "%s: %zu x %zu%s, %s%s; %zu of %zu %s%s hit\n",
                  arguments->scene, trace->width, trace->height, samples,
                  trace_mode_name(trace->mode), queue, result->hits, tried,
                  sampled ? "pixel" : "ray", plural(tried));
    output_printf(results,
                  "%llu clock%s, %s on the machine\n"
                  "frame checksum %s\n",
                  (unsigned long long)result->clocks, plural(result->clocks), time,
                  result->checksum);
    if (trace->threshold > 0)
        print_rays(result, results);
    if (arguments->output)
        output_printf(results, "picture %s\n", arguments->output);
}

/* Returns the results as a table. */
static struct table *table_of(const struct result *result)
{
    static const struct table_column columns[] = {
        { "scene", "scene", TABLE_TEXT, 0 },
        { "width", "width", TABLE_COUNT, 0 },
        { "height", "height", TABLE_COUNT, 0 },
        { "mode", "mode", TABLE_TEXT, 0 },
        { "queue", "queue", TABLE_COUNT, 0 },
        { "rays", "rays", TABLE_COUNT, 0 },
        { "hits", "hits", TABLE_COUNT, 0 },
        { "clocks", "clocks", TABLE_COUNT, 0 },
        { "seconds", "s", TABLE_NUMBER, 4 },
        { "checksum", "checksum", TABLE_TEXT, 0 },
        { "picture", "picture", TABLE_TEXT, 0 },
    };
    const struct rt205_arguments *arguments = result->arguments;
    const struct trace_options *trace = &arguments->trace;
    struct table *table = table_new(TABLE_COLUMNS(columns));

    if (!table)
        return NULL;
    table_text(table, arguments->scene);
    table_count(table, trace->width);
    table_count(table, trace->height);
    table_text(table, trace_mode_name(trace->mode));
    table_count(table, trace->queue);
    table_count(table, result->rays);
    table_count(table, result->hits);
    table_count(table, result->clocks);
    table_number(table, accounts_seconds(result->model, result->clocks));
    table_text(table, result->checksum);
    table_text(table, arguments->output ? arguments->output : "");
    return table;
}

static void write_result(const struct result *result, struct json *json)
{
    const struct trace_options *trace = &result->arguments->trace;

    json_text(json, "scene", result->arguments->scene);
    json_text(json, "mode", trace_mode_name(trace->mode));
    json_count(json, "width", trace->width);
    json_count(json, "height", trace->height);
    json_count(json, "samples", result->samples);
    if (trace->threshold > 0)
        json_number(json, "threshold", trace->threshold);
    json_count(json, "queue", trace->queue);
    json_text(json, "order", order_name(trace_order(trace)));
    json_count(json, "rays", result->rays);
    json_count(json, "hits", result->hits);
    json_count(json, "clocks", result->clocks);
    json_number(json, "seconds", accounts_seconds(result->model, result->clocks));
    json_text(json, "checksum", result->checksum);
    if (result->arguments->output)
        json_text(json, "picture", result->arguments->output);
    provenance_json(result->model, json);
}

static int print_and_check(const struct result *result,
                           const struct command_output *results)
{
    struct command_output printed = *results;
    int code = CMD_DONE;

    printed.json = NULL;
    if (results->format == OUTPUT_TEXT)
        print_result(result, results);
    else
        code = output_show(&printed, table_of(result), NULL, "Frame");
    output_model(results, result->model);
    if (results->json)
        write_result(result, results->json);
    return code;
}

/* Prints the accounts if requested. JSON always has them. */
static int print_accounts(const struct rt205_arguments *arguments,
                          const struct trace *trace,
                          const struct command_output *results)
{
    struct command_output accounts = *results;

    if (!arguments->accounts)
        accounts.file = NULL;
    else if (results->file)
        output_gap(results);
    return accounts_show(trace_accounts(trace), &accounts);
}

/* Prints all results. The profile may be NULL. */
static int print_trace(const struct rt205_arguments *arguments,
                       const struct trace *trace, const struct line_profile *profile,
                       const struct command_output *results)
{
    struct profile_view view = { arguments->in_order ? PROFILE_AS_WRITTEN
                                                     : PROFILE_HOTTEST,
                                 true };
    struct result result = result_of(arguments, trace);
    int code = print_and_check(&result, results);

    if (code == CMD_DONE)
        code = print_accounts(arguments, trace, results);
    return code == CMD_DONE && profile ? line_profile_show(profile, view, results)
                                       : code;
}

/* ---- A run --------------------------------------------------------------- */

/* Reports the bands that the files of --resume have already. */
static void print_kept(const struct rt205_arguments *arguments,
                       const struct trace *trace)
{
    const char *path = arguments->units.resume.items[0];

    if (arguments->units.job_set.kept > 0)
        cmd_print_line(stderr, "%s: the frame continues from %s: %zu of %zu band%s",
                       arguments->command, path, arguments->units.job_set.kept,
                       trace_bands(trace), plural(trace_bands(trace)));
    else
        cmd_print_line(stderr, "%s: the frame starts: %s has no band yet",
                       arguments->command, path);
}

static bool keep(const struct rt205_arguments *arguments, struct trace *trace,
                 c205_error *error)
{
    if (!trace_keep(trace, error))
        return false;
    if (arguments->units.resume.count > 0)
        print_kept(arguments, trace);
    return true;
}

/* After Ctrl-C, writes a picture of the finished rows, and formats a message about
 * it. */
static void save_rows(const struct rt205_arguments *arguments,
                      const struct trace *trace, char *reported, size_t size)
{
    size_t rows = trace_rows_done(trace);
    c205_error why;

    if (rows == 0)
        snprintf(reported, size, "; no row is done, so no picture is written");
    else if (!write_picture(arguments, trace, &why))
        snprintf(reported, size, "; %s", why.message);
    else
        snprintf(reported, size, "; %.100s has %zu of %zu row%s, the others are black",
                 arguments->output, rows, arguments->trace.height,
                 plural(arguments->trace.height));
}

/* Formats a message about the bands that a later run with --resume can use. */
static void print_resume(const struct rt205_arguments *arguments,
                         const struct trace *trace, char *reported, size_t size)
{
    size_t kept = trace_bands_done(trace);

    if (arguments->units.resume.count > 0 && kept > 0)
        snprintf(reported, size, "; --resume continues from %.100s: %zu of %zu band%s",
                 arguments->units.resume.items[0], kept, trace_bands(trace),
                 plural(trace_bands(trace)));
    else if (arguments->units.resume.count > 0)
        snprintf(reported, size, "; no band is done: --resume starts again");
}

static int end_early(const struct rt205_arguments *arguments, const struct trace *trace,
                     const c205_error *why)
{
    char rows[300] = "", bands[200] = "";

    if (interrupt_pending() && arguments->output)
        save_rows(arguments, trace, rows, sizeof rows);
    print_resume(arguments, trace, bands, sizeof bands);
    return cmd_failed(arguments->command, "%s%s%s", why->message, rows, bands);
}

/* *profile is set only when a band has been observed. */
static int trace_and_write(const struct rt205_arguments *arguments, struct trace *trace,
                           struct line_profile *const *profile,
                           const struct command_output *results)
{
    c205_error error = { "out of memory" };

    if (!trace_run(trace, &error))
        return end_early(arguments, trace, &error);
    if (!job_set_collects(&arguments->units.job_set))
        return cmd_print_share(arguments, trace_bands(trace));
    if (!arguments->output || write_picture(arguments, trace, &error)) {
        trace_forget(trace);
        return print_trace(arguments, trace, *profile, results);
    }
    return cmd_failed(arguments->command, "%s", error.message);
}

/* Traces and writes. The library that writes pictures is loaded in the background
 * while the machine runs. */
static int run(const struct rt205_arguments *arguments, struct trace *trace,
               struct line_profile *const *profile,
               const struct command_output *results)
{
    struct picture_error why;
    struct picture_loader *loader;
    int code;

    if (!arguments->output)
        return trace_and_write(arguments, trace, profile, results);
    loader = picture_load(&why);
    if (!loader)
        return cmd_failed(arguments->command, "%s", why.message);
    code = trace_and_write(arguments, trace, profile, results);
    picture_loaded(loader);
    return code;
}

static int render(const struct rt205_arguments *arguments, const struct scene *scene,
                  const struct command_output *results)
{
    struct line_profile *profile = NULL;
    struct observer observer = frame_profile_observer(&profile);
    const struct observer *const observers[] = { &observer, NULL };
    struct trace_options options = arguments->trace;
    c205_error error = { "out of memory" };
    struct trace *trace;
    int code;

    if (arguments->profile)
        options.observers = observers;
    trace = trace_new(scene, &options, &error);
    code = trace && keep(arguments, trace, &error)
               ? run(arguments, trace, &profile, results)
               : cmd_failed(arguments->command, "%s", error.message);
    line_profile_free(profile);
    trace_free(trace);
    return code;
}

static int render_scene(const struct rt205_arguments *arguments,
                        const struct command_output *results)
{
    struct scene *scene = cmd_read_scene(arguments);
    int code = !scene ? CMD_FAILED : render(arguments, scene, results);

    scene_free(scene);
    return code;
}

/* Checks the requested files. Returns the exit code, or CMD_DONE if they are
 * valid. */
static int check_files(const struct rt205_arguments *arguments)
{
    int code;

    if (arguments->output && arguments->no_picture)
        return cmd_usage(arguments->command, "-o cannot be combined with --no-picture");
    if (arguments->half && arguments->no_picture)
        return cmd_usage(arguments->command, "--half cannot be combined with "
                                             "--no-picture");
    if (arguments->no_picture)
        return CMD_DONE;
    if (!arguments->output && arguments->units.job_set.parts > 0)
        return CMD_DONE;
    if (!arguments->output)
        return cmd_usage(arguments->command, "expected -o FILE or --no-picture");
    code = cmd_check_picture(arguments);
    if (code != CMD_DONE)
        return code;
    if (arguments->half && !picture_holds_half(arguments->output))
        return cmd_usage(arguments->command, "--half requires a picture in .exr");
    return CMD_DONE;
}

/* Checks the options of --debug, which only starts a debugger. */
static int check_debug(const struct rt205_arguments *arguments)
{
    const struct cmd_units *units = &arguments->units;

    if (arguments->output || arguments->accounts || arguments->profile
        || arguments->results.path || units->resume.count > 0 || units->ranks > 1)
        return cmd_usage(arguments->command,
                         "--debug cannot be combined with -o, --accounts, --profile, "
                         "--json, --resume or --ranks");
    return cmd_check_pixel(arguments);
}

/* Checks the options of --profile. Bands of other processes and of earlier runs
 * are not observed. */
static int check_profile(const struct rt205_arguments *arguments)
{
    const struct cmd_units *units = &arguments->units;

    if (arguments->in_order && !arguments->profile)
        return cmd_usage(arguments->command, "--in-order requires --profile");
    if (arguments->profile
        && (units->resume.count > 0 || units->ranks > 1 || ranks_are_many()))
        return cmd_usage(arguments->command,
                         "--profile cannot be combined with --resume or --ranks: it "
                         "needs all bands in one process");
    return CMD_DONE;
}

static int run_command_line(void *given)
{
    struct rt205_arguments *arguments = given;
    int code;

    if (arguments->pixel.given) {
        code = check_debug(arguments);
        return code == CMD_DONE ? cmd_with_machine(arguments, cmd_debug_pixel) : code;
    }
    if (arguments->scripts.count > 0)
        return cmd_usage(arguments->command, "-x requires --debug");
    code = check_files(arguments);
    if (code == CMD_DONE)
        code = check_profile(arguments);
    return code == CMD_DONE ? cmd_with_jobs(arguments, render_scene) : code;
}

static const struct command_option options[] = {
    { .name = "output",
      .letter = 'o',
      .value = "FILE",
      .kind = COMMAND_OUTPUT,
      .offset = CMD_PLACE(output),
      .help = "the picture: .png .jpg (8-bit sRGB), .exr .tif (linear, with "
              "depth, normal and id); on stdout a .png" },
    CMD_FLAG("no-picture", no_picture, "write no picture, only report the clocks"),
    CMD_SIZE(640, 480),
    CMD_MODE(cmd_mode_choice, "form of the programs; kernels is that of 1984"),
    CMD_QUEUE("rays in the vector queue"),
    CMD_SAMPLES,
    CMD_THRESHOLD,
    CMD_ORDER(ORDER_DEFAULT),
    CMD_MODEL,
    CMD_BOUNDS,
    CMD_JOBS("bands of the frame traced at a time"),
    CMD_RESUME("bands"),
    CMD_PART("bands"),
    CMD_RANKS,
    CMD_FLAG("accounts", accounts, "also the clocks by cause and by region"),
    CMD_FLAG("profile", profile,
             "also the clocks by line of the kernels, hottest region first; a macro "
             "counts where it is called"),
    CMD_FLAG("in-order", in_order, "lines of --profile in the order of memory"),
    CMD_FLAG("half", half, "16-bit colours in an .exr"),
    CMD_PIXEL("debug", "start a debugger for the band of this pixel; write no picture"),
    { .name = "script",
      .letter = 'x',
      .value = "FILE",
      .kind = COMMAND_INPUT,
      .many = true,
      .offset = CMD_PLACE(scripts),
      .help = "commands for the debugger; the exit status is 1 if one fails, such as "
              "an assert" },
    CMD_READ,
    CMD_RESULTS,
    COMMAND_END
};
static const struct command_option operands[] = { CMD_SCENE, COMMAND_END };
static const struct command_example examples[] = {
    { "rt205 render SCENE -o PICTURE", "the picture, and its clocks" },
    { "rt205 render SCENE --no-picture --accounts", "the clocks by cause and region" },
    { "rt205 render SCENE --no-picture --profile",
      "the clocks by line of the kernels" },
    { "rt205 render SCENE --debug 320,240",
      "a debugger that follows the ray of this pixel" },
    { NULL, NULL }
};

const struct command render_command = {
    .name = "render",
    .summary = "trace a scene, write a picture",
    .function = run_command_line,
    .arguments_size = sizeof(struct rt205_arguments),
    .options = options,
    .operands = operands,
    .examples = examples,
    .details = "The debugger is that of c205 debug, with the additional commands "
               "seek and lane for the pixel. Its command help lists all commands.",
};
