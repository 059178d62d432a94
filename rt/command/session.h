/* session.h - what all commands of rt205 share: structures of arguments, their options,
 * and a session, which opens the model, the output and the scene of a command.
 *
 *   struct trace_session session;
 *   int code = session_open(&session, &args->shared, NULL);
 *
 *   if (code == CMD_DONE)
 *       code = render(&session, args);
 *   return session_close(&session, code);
 *
 * The file of a command defines a structure of the command's arguments. It begins with
 * struct trace_arguments, and contains other structures of this file.
 */
#ifndef RT_SESSION_H
#define RT_SESSION_H

#include <stddef.h>

#include "base/command_options.h"
#include "base/command_output.h"
#include "base/progress.h"
#include "rt/command/commands.h"
#include "rt/jobs/job_set.h"
#include "rt/scene/language/scene_read.h"
#include "rt/trace/trace.h"

/* ---- Groups of arguments ------------------------------------------------- */

struct trace_arguments {
    const char *command, *model;
    const char *output; /* file of option -o; NULL: not requested */
    struct command_output results;
    struct trace_options trace; /* the session sets model, jobs and progress */
};

struct scene_arguments {
    const char *path;
    bool strict;
    struct command_texts search; /* folders for #include */
};

/* The arguments of a command whose units of work can run in several processes. */
struct job_arguments {
    struct command_texts resume; /* paths of checkpoint files; none: no checkpoints */
    size_t ranks;                /* number of processes to start; 0: only this
                                  * process */
    struct job_set job_set;
};

struct pixel_arguments {
    bool given;
    size_t x, y;
};

/* cmd_check_picture reports a picture that cannot be written. cmd_check_pixel reports a
 * pixel outside of the frame. Both return CMD_DONE, or the exit code. */
int cmd_check_picture(const struct trace_arguments *shared);
int cmd_check_pixel(const struct trace_arguments *shared,
                    const struct pixel_arguments *pixel);
/* Parses a share of the units of a run, such as "1/4", into job_set->part and
 * job_set->parts. Returns false if the text is not a share. */
bool cmd_is_part(const char *text, struct job_set *job_set);
/* Reports that this process has finished its share of a run, and how many of the
 * `units` of the run its file contains. Returns CMD_DONE. */
int cmd_print_share(const char *command, const struct job_set *job_set, size_t units);

/* ---- Rows of options ----------------------------------------------------- */

enum { MAX_RANKS = 4096 };
command_take cmd_take_part, cmd_take_pixel;
command_choice cmd_mode_choice, cmd_form_choice, cmd_visible_choice, cmd_order_choice;

/* clang-format off */
#define CMD_SHARED(member) offsetof(struct trace_arguments, member)
#define CMD_MODEL OPTION_MODEL(CMD_SHARED(model))
#define CMD_RESULTS \
    OUTPUT_OPTIONS(struct trace_arguments, results), \
    OUTPUT_OPTION_PROVENANCE(struct trace_arguments, results)
#define CMD_OUTPUT(what) OPTION_OUTPUT(CMD_SHARED(output), what)

#define CMD_SIZE(across, down) \
    { OPTION_COUNT("width", CMD_SHARED(trace.width), 1, MAX_TRACE_PIXELS, across, \
                   "pixels across"), .letter = 'W' }, \
    { OPTION_COUNT("height", CMD_SHARED(trace.height), 1, MAX_TRACE_PIXELS, down, \
                   "pixels down"), .letter = 'H' }
#define CMD_QUEUE(what) \
    { OPTION_COUNT("queue", CMD_SHARED(trace.queue), 1, MAX_TRACE_QUEUE, TRACE_QUEUE, \
                   what) }
#define CMD_JOBS(what) \
    { OPTION_COUNT("jobs", CMD_SHARED(trace.jobs), 1, MAX_TRACE_JOBS, 0, what), \
      .preset_text = "one for each processor" }
#define CMD_MODE(choices, what) \
    { .name = "mode", .value = "MODE", .kind = COMMAND_CHOICE, \
      .offset = CMD_SHARED(trace.mode), .choice = choices, \
      .preset = TRACE_VECTOR, .help = what }
#define CMD_BOUNDS \
    OPTION_FLAG("historical", CMD_SHARED(trace.historical), \
                "use the methods of 1984 for cylinders and Steiner patches"), \
    OPTION_FLAG("no-bounds", CMD_SHARED(trace.no_bounds), \
                "test every ray against every primitive"), \
    OPTION_FLAG("flat", CMD_SHARED(trace.flat), \
                "use no hierarchy: regions in the order of the scene, CSG trees " \
                "as written"), \
    { .name = "visible", .value = "WAY", .kind = COMMAND_CHOICE, \
      .offset = CMD_SHARED(trace.visible), .choice = cmd_visible_choice, \
      .help = "method for CSG solids in vector form" }
#define CMD_SAMPLES \
    { OPTION_COUNT("samples", CMD_SHARED(trace.samples), 1, MAX_TRACE_SAMPLES, 1, \
                   "N x N rays per pixel, averaged") }
#define CMD_THRESHOLD \
    { .name = "threshold", .value = "T", .kind = COMMAND_NUMBER, \
      .offset = CMD_SHARED(trace.threshold), .most = 1000, \
      .help = "take the samples only in pixels whose colour differs by T or more " \
              "from a neighbour's; all others have one ray" }
#define CMD_ORDER(usual) \
    { .name = "order", .value = "ORDER", .kind = COMMAND_CHOICE, \
      .offset = CMD_SHARED(trace.order), .choice = cmd_order_choice, \
      .preset = usual, .help = "order of the pixels; by default tiles in vector form" }

/* The parameter of each macro below is the offset of a group of arguments, such as
 * struct scene_arguments, in the arguments of the command. */
#define CMD_SCENE(scene) \
    { .value = "SCENE", .kind = COMMAND_INPUT, \
      .offset = (scene) + offsetof(struct scene_arguments, path), \
      .help = "a scene file" }
#define CMD_READ(scene) \
    OPTION_FLAG("strict", (scene) + offsetof(struct scene_arguments, strict), \
                "report replaced or ignored features as errors"), \
    OPTION_INCLUDE((scene) + offsetof(struct scene_arguments, search))
#define CMD_RESUME(jobs, what) \
    { .name = "resume", .value = "FILE", .kind = COMMAND_FILE, \
      .many = true, .offset = (jobs) + offsetof(struct job_arguments, resume), \
      .help = "store finished " what " in FILE and continue from those it has; " \
              "read those of further files, too" }
#define CMD_PART(jobs, what) \
    { .name = "part", .value = "K/N", .kind = COMMAND_CUSTOM, \
      .offset = (jobs) + offsetof(struct job_arguments, job_set), \
      .take = cmd_take_part, \
      .wants = "K/N, with K between 1 and N, such as 1/4", \
      .help = "only the K-th of N shares of the " what ", stored by --resume" }
#define CMD_RANKS(jobs) \
    { OPTION_COUNT("ranks", (jobs) + offsetof(struct job_arguments, ranks), \
                   1, MAX_RANKS, 0, "MPI processes"), \
      .preset_text = "this process" }
#define CMD_PIXEL(option, pixel, what) \
    { .name = option, .value = "X,Y", .kind = COMMAND_CUSTOM, \
      .offset = pixel, .take = cmd_take_pixel, \
      .wants = "column and row of a pixel, counted from 0, such as 12,7", .help = what }
#define CMD_VIEW(view, usual, usual_text) \
    { .name = "distance", .value = "D", .kind = COMMAND_NUMBER, \
      .offset = (view) + offsetof(struct speedup_view, distance), .most = 1e6, \
      .preset = SPEEDUP_DISTANCE, \
      .help = "distance from the eye to the centre of the shape" }, \
    { .name = "angle", .value = "DEGREES", .kind = COMMAND_NUMBER, \
      .offset = (view) + offsetof(struct speedup_view, angle), .most = 180, \
      .preset = usual, .preset_text = usual_text, .help = "horizontal angle of view" }
/* clang-format on */

/* ---- Session ------------------------------------------------------------- */

struct trace_session {
    struct trace_arguments *shared;
    struct job_arguments *jobs; /* NULL: the command has no such arguments */
    struct ranks ranks;
    c205_model *model;
    struct command_output results; /* output of all results */
    struct scene *scene;           /* result of session_scene, or NULL */
    struct progress progress;
};

/* Checks the arguments, and starts or joins the ranks. Then opens the model and the
 * output, and completes the trace options. Ranks other than 0 print and write nothing.
 * Returns CMD_DONE, or the exit code after an error message. Call session_close in
 * either case. */
int session_open(struct trace_session *session, struct trace_arguments *shared,
                 struct job_arguments *jobs);
/* Closes everything that the session has open. JSON is written if the code is CMD_DONE,
 * else discarded. Returns the exit code. */
int session_close(struct trace_session *session, int code);

/* Reads the scene, which the session frees. Prints its diagnostics on stderr. Returns
 * NULL if there are errors. */
const struct scene *session_scene(struct trace_session *session,
                                  const struct scene_arguments *args);

/* Makes Ctrl-C stop a trace. A second Ctrl-C ends the process. Also shows progress on
 * stderr if it is a terminal. Sets the progress function of the trace options. */
void session_watch(struct trace_session *session);

#endif
