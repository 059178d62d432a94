/* cmd_render.c - rt205 render: traces a scene, writes a picture and reports the clocks.
 * With --debug it debugs the program of a frame. */
#include <stdio.h>

#include "asm/command/repl.h"
#include "base/accounts_show.h"
#include "vm/error.h"
#include "base/interrupt.h"
#include "base/plural.h"
#include "base/provenance.h"
#include "base/visible_text.h"
#include "rt/command/session.h"
#include "rt/picture/picture.h"
#include "rt/trace/form.h"
#include "rt/view/frame_profile.h"
#include "rt/view/pixel_verbs.h"

struct render_arguments {
    struct trace_arguments shared;
    struct scene_arguments scene;
    struct job_arguments jobs;
    bool no_picture, half;
    bool accounts, profile, in_order;
    struct pixel_arguments pixel; /* if specified, the command starts the debugger */
    struct command_texts scripts; /* commands for the debugger */
};

static bool write_rows(const struct trace_options *options, const struct trace *trace,
                       struct picture *picture, c205_error *error)
{
    struct frame part;
    size_t rows = options->height < PICTURE_PART ? options->height : PICTURE_PART;
    bool good = frame_allocate(&part, options->width, rows);
    error_set(error, "out of memory for the picture");
    for (size_t row = 0; good && row < options->height; row += PICTURE_PART) {
        if (options->height - row < PICTURE_PART)
            part.height = options->height - row;
        trace_read(trace, row, &part);
        good = picture_rows(picture, &part, error);
    }
    frame_free(&part);
    return good;
}

static bool write_picture(const struct render_arguments *args,
                          const struct trace *trace, c205_error *error)
{
    const struct accounts *accounts = trace_accounts(trace);
    bool whole = trace_rows_done(trace) == args->shared.trace.height;
    const struct trace_options *options = &args->shared.trace;
    struct picture *picture;
    char clocks[32], rows[48];
    const struct picture_note notes[] = {
        { "Software", "rt205 " C205_VERSION },
        { "rt205:scene", args->scene.path },
        { "rt205:model", c205_model_name(accounts->model) },
        { "rt205:mode", trace_mode_name(args->shared.trace.mode) },
        { "rt205:clocks", clocks },
        { whole ? NULL : "rt205:rows", rows },
        { NULL, NULL },
    };
    bool good;
    snprintf(clocks, sizeof clocks, "%llu", (unsigned long long)accounts->clocks);
    snprintf(rows, sizeof rows, "%zu of %zu", trace_rows_done(trace),
             args->shared.trace.height);
    picture = picture_begin(args->shared.output, options->width, options->height, notes,
                            args->half, NULL, error);
    good = picture && write_rows(options, trace, picture, error);
    return picture && picture_end(picture, good, error);
}

/* ---- Report of a frame --------------------------------------------------- */

/* The results of a run. They are printed as lines, as a table or as JSON. */
struct result {
    const struct render_arguments *args;
    const c205_model *model;
    uint64_t clocks;
    size_t samples;    /* samples x samples rays for each pixel */
    size_t rays, hits; /* numbers of camera rays and of their hits */
    char checksum[17];
};

static struct result result_of(const struct render_arguments *args,
                               const struct trace *trace)
{
    const struct accounts *accounts = trace_accounts(trace);
    struct result result = { .args = args,
                             .model = accounts->model,
                             .clocks = accounts->clocks,
                             .samples = trace_samples(trace),
                             .rays = (size_t)trace_rays(trace, RAY_PRIMARY),
                             .hits = trace_hits(trace) };
    snprintf(result.checksum, sizeof result.checksum, "%016llX",
             (unsigned long long)trace_checksum(trace));
    return result;
}

/* Prints the number of camera rays that were traced with --threshold, and their
 * percentage of the rays without it. */
static void print_rays(const struct result *result,
                       const struct command_output *results)
{
    const struct trace_options *trace = &result->args->shared.trace;
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
    const struct render_arguments *args = result->args;
    const struct trace_options *trace = &args->shared.trace;
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
                  args->scene.path, trace->width, trace->height, samples,
                  trace_mode_name(trace->mode), queue, result->hits, tried,
                  sampled ? "pixel" : "ray", plural(tried));
    output_printf(results,
                  "%llu clock%s, %s on the machine\n"
                  "frame checksum %s\n",
                  (unsigned long long)result->clocks, plural(result->clocks), time,
                  result->checksum);
    if (trace->threshold > 0)
        print_rays(result, results);
    if (args->shared.output)
        output_printf(results, "picture %s\n", args->shared.output);
}

/* Returns the results of a render as a table with one row. */
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
    const struct render_arguments *args = result->args;
    const struct trace_options *trace = &args->shared.trace;
    struct table *table = table_new(TABLE_COLUMNS(columns));
    if (!table)
        return NULL;
    table_text(table, args->scene.path);
    table_count(table, trace->width);
    table_count(table, trace->height);
    table_text(table, trace_mode_name(trace->mode));
    table_count(table, trace->queue);
    table_count(table, result->rays);
    table_count(table, result->hits);
    table_count(table, result->clocks);
    table_number(table, accounts_seconds(result->model, result->clocks));
    table_text(table, result->checksum);
    table_text(table, args->shared.output ? args->shared.output : "");
    return table;
}

static void write_result(const struct result *result, struct json *json)
{
    const struct trace_options *trace = &result->args->shared.trace;
    json_text(json, "scene", result->args->scene.path);
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
    if (result->args->shared.output)
        json_text(json, "picture", result->args->shared.output);
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

/* Prints the accounts if requested. JSON always contains them. */
static int print_accounts(const struct render_arguments *args,
                          const struct trace *trace,
                          const struct command_output *results)
{
    struct command_output accounts = *results;
    if (!args->accounts)
        accounts.file = NULL;
    else if (results->file)
        output_gap(results);
    return accounts_show(trace_accounts(trace), &accounts);
}

/* Prints all results. The profile may be NULL. */
static int print_trace(const struct render_arguments *args, const struct trace *trace,
                       const struct line_profile *profile,
                       const struct command_output *results)
{
    struct profile_view view = { args->in_order ? PROFILE_AS_WRITTEN : PROFILE_HOTTEST,
                                 true };
    struct result result = result_of(args, trace);
    int code = print_and_check(&result, results);
    if (code == CMD_DONE)
        code = print_accounts(args, trace, results);
    return code == CMD_DONE && profile ? line_profile_show(profile, view, results)
                                       : code;
}

/* ---- A run --------------------------------------------------------------- */

/* Reports the number of bands that were in the files of --resume. */
static void print_kept(const struct render_arguments *args, const struct trace *trace)
{
    const char *path = args->jobs.resume.items[0];
    if (args->jobs.job_set.kept > 0)
        cmd_print_line(stderr, "%s: the frame continues from %s: %zu of %zu band%s",
                       args->shared.command, path, args->jobs.job_set.kept,
                       trace_bands(trace), plural(trace_bands(trace)));
    else
        cmd_print_line(stderr, "%s: the frame starts: %s has no band yet",
                       args->shared.command, path);
}

/* After Ctrl-C, writes a picture of the finished rows. Formats a message about this
 * picture. */
static void save_rows(const struct render_arguments *args, const struct trace *trace,
                      char *reported, size_t size)
{
    size_t rows = trace_rows_done(trace);
    c205_error why;
    if (rows == 0)
        snprintf(reported, size, "; no row is done, so no picture is written");
    else if (!write_picture(args, trace, &why))
        snprintf(reported, size, "; %s", why.message);
    else
        snprintf(reported, size, "; %.100s has %zu of %zu row%s, the others are black",
                 args->shared.output, rows, args->shared.trace.height,
                 plural(args->shared.trace.height));
}

/* Formats a message about the bands that a later run with --resume can use. */
static void print_resume(const struct render_arguments *args, const struct trace *trace,
                         char *reported, size_t size)
{
    size_t kept = trace_bands_done(trace);
    if (args->jobs.resume.count > 0 && kept > 0)
        snprintf(reported, size, "; --resume continues from %.100s: %zu of %zu band%s",
                 args->jobs.resume.items[0], kept, trace_bands(trace),
                 plural(trace_bands(trace)));
    else if (args->jobs.resume.count > 0)
        snprintf(reported, size, "; no band is done: --resume starts again");
}

static int end_early(const struct render_arguments *args, const struct trace *trace,
                     const c205_error *why)
{
    char rows[300] = "", bands[200] = "";
    if (interrupt_pending() && args->shared.output)
        save_rows(args, trace, rows, sizeof rows);
    print_resume(args, trace, bands, sizeof bands);
    return cmd_failed(args->shared.command, "%s%s%s", why->message, rows, bands);
}

/* Opens the checkpoint files. Also starts to load the library that writes pictures; it
 * is loaded while the machine runs. */
static bool prepare(const struct render_arguments *args, struct trace *trace,
                    struct picture_loader **loader, c205_error *error)
{
    if (!trace_keep(trace, error))
        return false;
    if (args->jobs.resume.count > 0)
        print_kept(args, trace);
    if (!args->shared.output)
        return true;
    *loader = picture_load(error);
    return *loader;
}

/* Writes the picture and prints the results of a frame. */
static int finish(const struct render_arguments *args, struct trace *trace,
                  const struct line_profile *profile,
                  const struct command_output *results)
{
    c205_error error;
    if (!job_set_collects(&args->jobs.job_set))
        return cmd_print_share(args->shared.command, &args->jobs.job_set,
                               trace_bands(trace));
    if (args->shared.output && !write_picture(args, trace, &error))
        return cmd_failed(args->shared.command, "%s", error.message);
    trace_forget(trace);
    return print_trace(args, trace, profile, results);
}

static int render(struct trace_session *session, const struct render_arguments *args)
{
    struct line_profile *profile = NULL; /* NULL until a band has been observed */
    struct observer observer = frame_profile_observer(&profile);
    const struct observer *const observers[] = { &observer, NULL };
    struct trace_options options = args->shared.trace;
    const struct scene *scene = session_scene(session, &args->scene);
    struct picture_loader *loader = NULL;
    c205_error error = { "out of memory" };
    struct trace *trace;
    int code;
    if (!scene)
        return CMD_FAILED;
    if (args->profile)
        options.observers = observers;
    trace = trace_new(scene, &options, &error);
    if (!trace || !prepare(args, trace, &loader, &error))
        code = cmd_failed(args->shared.command, "%s", error.message);
    else if (!trace_run(trace, &error))
        code = end_early(args, trace, &error);
    else
        code = finish(args, trace, profile, &session->results);
    picture_loaded(loader);
    line_profile_free(profile);
    trace_free(trace);
    return code;
}

/* ---- The debugger -------------------------------------------------------- */

static int run_debugger(const struct render_arguments *args, struct frame_pixel *pixel)
{
    const struct trace_options *options = &args->shared.trace;
    const struct debugger_setup setup = { .object = trace_program(pixel->trace),
                                          .name = form_program(options->mode),
                                          .model = options->model,
                                          .out = visible_stream(stdout),
                                          .printed = stream_sink(stdout),
                                          .clocks_most = C205_NO_LIMIT,
                                          .interrupted = repl_interrupted,
                                          .machine = pixel_machine,
                                          .verbs = pixel_verbs,
                                          .context = pixel };
    const struct repl_setup repl = { .command = args->shared.command,
                                     .prompt = "(rt205) ",
                                     .verb = pixel_verb,
                                     .scripts = &args->scripts };
    return repl_run(&repl, &setup);
}

/* Runs the debugger on the program of the band that contains the pixel. */
static int debug(struct trace_session *session, const struct render_arguments *args)
{
    const struct scene *scene = session_scene(session, &args->scene);
    c205_error error = { "out of memory" };
    struct frame_pixel pixel;
    struct trace *trace;
    int code;
    if (!scene)
        return CMD_FAILED;
    trace = trace_new(scene, &args->shared.trace, &error);
    if (trace && frame_pixel_find(&pixel, trace, args->pixel.x, args->pixel.y, &error))
        code = run_debugger(args, &pixel);
    else
        code = cmd_failed(args->shared.command, "%s", error.message);
    trace_free(trace);
    return code;
}

/* ---- The command --------------------------------------------------------- */

/* Checks the options of --debug. Options for the results of a frame are rejected. */
static int check_debug(const struct render_arguments *args)
{
    const struct job_arguments *jobs = &args->jobs;
    if (args->shared.output || args->accounts || args->profile
        || args->shared.results.path || jobs->resume.count > 0
        || jobs->job_set.parts > 0 || jobs->ranks > 1)
        return cmd_usage(args->shared.command,
                         "--debug cannot be combined with -o, --accounts, --profile, "
                         "--json, --resume, --part or --ranks");
    return cmd_check_pixel(&args->shared, &args->pixel);
}

static int check_picture(const struct render_arguments *args)
{
    const struct trace_arguments *shared = &args->shared;
    int code;
    if (shared->output && args->no_picture)
        return cmd_usage(shared->command, "-o cannot be combined with --no-picture");
    if (args->half && args->no_picture)
        return cmd_usage(shared->command,
                         "--half cannot be combined with --no-picture");
    if (args->no_picture || (!shared->output && args->jobs.job_set.parts > 0))
        return CMD_DONE;
    if (!shared->output)
        return cmd_usage(shared->command, "expected -o FILE or --no-picture");
    code = cmd_check_picture(shared);
    if (code == CMD_DONE && args->half && !picture_holds_half(shared->output))
        code = cmd_usage(shared->command, "--half requires a picture in .exr");
    return code;
}

/* Checks the options of a frame. Bands from other processes or from earlier runs cannot
 * be profiled. */
static int check_frame(const struct render_arguments *args)
{
    const struct job_arguments *jobs = &args->jobs;
    int code;
    if (args->scripts.count > 0)
        return cmd_usage(args->shared.command, "-x requires --debug");
    code = check_picture(args);
    if (code != CMD_DONE)
        return code;
    if (args->in_order && !args->profile)
        return cmd_usage(args->shared.command, "--in-order requires --profile");
    if (args->profile
        && (jobs->resume.count > 0 || jobs->ranks > 1 || ranks_are_many()))
        return cmd_usage(args->shared.command,
                         "--profile cannot be combined with --resume or --ranks: it "
                         "needs all bands in one process");
    return CMD_DONE;
}

static int cmd_render(void *given)
{
    struct render_arguments *args = given;
    struct trace_session session;
    bool debugs = args->pixel.given;
    int code = debugs ? check_debug(args) : check_frame(args);
    if (code != CMD_DONE)
        return code;
    code = session_open(&session, &args->shared, debugs ? NULL : &args->jobs);
    if (code == CMD_DONE)
        code = debugs ? debug(&session, args) : render(&session, args);
    return session_close(&session, code);
}

#define PLACE(member) offsetof(struct render_arguments, member)

static const struct command_option options[] = {
    CMD_OUTPUT("the picture: .png .jpg (8-bit sRGB), .exr .tif (linear, with "
               "depth, normal and id); on stdout a .png"),
    OPTION_FLAG("no-picture", PLACE(no_picture),
                "write no picture, only report the clocks"),
    CMD_SIZE(640, 480),
    CMD_MODE(cmd_mode_choice, "form of the programs; kernels is that of 1984"),
    CMD_QUEUE("rays in the vector queue"),
    CMD_SAMPLES,
    CMD_THRESHOLD,
    CMD_ORDER(ORDER_DEFAULT),
    CMD_MODEL,
    CMD_BOUNDS,
    CMD_JOBS("bands of the frame traced at a time"),
    CMD_RESUME(PLACE(jobs), "bands"),
    CMD_PART(PLACE(jobs), "bands"),
    CMD_RANKS(PLACE(jobs)),
    OPTION_FLAG("accounts", PLACE(accounts), "also the clocks by cause and by region"),
    OPTION_FLAG(
        "profile", PLACE(profile),
        "also the clocks by line of the kernels, hottest region first; "
        "operations of forms.s count at the line of the formula, in their form"),
    OPTION_FLAG("in-order", PLACE(in_order),
                "lines of --profile in the order of memory"),
    OPTION_FLAG("half", PLACE(half), "16-bit colours in an .exr"),
    CMD_PIXEL("debug", PLACE(pixel),
              "start a debugger for the band of this pixel; write no picture"),
    { OPTION_ROW(
          "script", "FILE", COMMAND_INPUT, PLACE(scripts),
          "commands for the debugger; the exit status is 1 if one fails, such as "
          "an assert"),
      .letter = 'x', .many = true },
    CMD_READ(PLACE(scene)),
    CMD_RESULTS,
    COMMAND_END
};
static const struct command_option operands[] = { CMD_SCENE(PLACE(scene)),
                                                  COMMAND_END };
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
    COMMAND_ROW("render", cmd_render, struct render_arguments,
                "trace a scene, write a picture"),
    .examples = examples,
    .details = "The debugger is that of c205 debug, with the additional commands "
               "seek and lane for the pixel. Its command help lists all commands.",
};
