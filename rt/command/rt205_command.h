/* rt205_command.h - the interface between the commands of rt205.
 *
 * Each command is a file with its row, its options and its function (command.h).
 */
#ifndef RT_RT205_COMMAND_H
#define RT_RT205_COMMAND_H

#include <stddef.h>

#include "base/command_options.h"
#include "base/progress.h"
#include "base/command_output.h"
#include "base/visible_text.h"
#include "rt/jobs/job_set.h"
#include "rt/mass/units.h"
#include "rt/roots/roots.h"
#include "rt/scene/language/scene_read.h"
#include "rt/study/sweep/sweep_types.h"

extern const struct command render_command, profile_command, speedup_command,
    sweep_command, quartic_command, heat_command, mass_command, timeline_command;

/* Lengths of the queue, in increasing order. */
struct cmd_points {
    size_t count;
    size_t items[MAX_SWEEP_LENGTHS];
};

/* The options of rt205 mass. */
struct cmd_mass {
    size_t rays, repeats, limit, seed; /* rays and limit: of a view, in all shifts */
    double tolerance;                  /* 0: none */
    int points, by;
    bool overlaps, stages;
    struct command_texts parts;   /* names; none: all */
    struct command_texts density; /* NAME=VALUE */
    const char *densities;        /* a file of densities, or NULL */
    double about[3];
    struct mass_units units;
};

/* The options of rt205 heat. */
struct cmd_heat {
    size_t rays, repeats, seed, lines; /* lines 0: use rays */
    int points;                        /* 0: lattice, 1: random */
    int by, shown;
    bool exchange, smooth, hits, stages;
    double tolerance; /* 0: none */
    size_t limit;
    const char *from;                                /* the emitter, or NULL: all */
    struct command_texts emissivities, temperatures; /* NAME=VALUE */
};

/* The options of the units of work. */
struct cmd_units {
    struct command_texts resume; /* checkpoint files; none: no checkpoints */
    size_t ranks;                /* processes to start; 0: only this one */
    struct job_set job_set;
    struct ranks joined;
};

struct cmd_pixel {
    bool given;
    size_t x, y;
};

struct rt205_arguments {
    const char *command;
    const char *scene;  /* the input file, or NULL; for a sweep possibly a primitive */
    const char *output; /* NULL: not requested */
    const char *model;
    struct command_output results;
    struct trace_options trace; /* the model is set later */
    struct speedup_view view;   /* angle 0: not given */
    struct cmd_points points;
    int sweep; /* index of the kind */
    bool strict, half, no_picture;
    struct cmd_pixel pixel;       /* the pixel of interest */
    struct command_texts scripts; /* for the debugger */
    const char *region;           /* of the program, or NULL */
    uint64_t from, to;            /* clocks; C205_NO_LIMIT: not given */
    bool accounts;                /* print the accounts of a frame */
    bool profile, in_order;       /* of a frame, by line */
    bool all, first;              /* roots of polynomials */
    bool details;      /* of the speedup table, and of heat the invisible surfaces */
    bool passes;       /* of the speedup table: each pass of the root solver */
    bool formulations; /* of the cylinder, instead of that table */
    struct command_texts rows; /* of that table; none: all */
    struct cmd_heat heat;
    int falsi; /* the rule; FALSI_RULES: compare all */
    struct cmd_mass mass;
    struct cmd_units units;
    struct progress progress;
    struct command_texts search; /* folders for includes */
};

/* Runs rt205 heat --hits. */
bool cmd_heat_hits(const struct rt205_arguments *arguments, const struct scene *scene,
                   const struct command_output *results, c205_error *error);

/* Runs rt205 render --debug. */
int cmd_debug_pixel(const struct rt205_arguments *arguments,
                    const struct command_output *results);

/* ---- Options of several commands ---------------------------------------- */

#define CMD_PLACE(member) offsetof(struct rt205_arguments, member)

command_choice cmd_mode_choice, cmd_form_choice, cmd_visible_choice, cmd_order_choice;

/* clang-format off */
#define CMD_MODEL COMMAND_OPTION_MODEL(CMD_PLACE(model))
#define CMD_RESULTS \
    OUTPUT_OPTIONS(struct rt205_arguments, results), \
    OUTPUT_OPTION_PROVENANCE(struct rt205_arguments, results)
#define CMD_FLAG(flag, place, text) \
    { .name = flag, .kind = COMMAND_FLAG, .offset = CMD_PLACE(place), \
      .help = text }
#define CMD_COUNT(option, place, first, last, usual, text) \
    .name = option, .value = "N", .kind = COMMAND_COUNT, \
    .offset = CMD_PLACE(place), .least = first, .most = (double)(last), \
    .preset = usual, .help = text

#define CMD_SIZE(across, down) \
    { CMD_COUNT("width", trace.width, 1, MAX_TRACE_PIXELS, across, \
                "pixels across"), .letter = 'W' }, \
    { CMD_COUNT("height", trace.height, 1, MAX_TRACE_PIXELS, down, \
                "pixels down"), .letter = 'H' }
#define CMD_QUEUE(what) \
    { CMD_COUNT("queue", trace.queue, 1, MAX_TRACE_QUEUE, TRACE_QUEUE, \
                what) }
#define CMD_JOBS(what) \
    { CMD_COUNT("jobs", trace.jobs, 1, MAX_TRACE_JOBS, 0, what), \
      .preset_text = "one for each processor" }
#define CMD_RESUME(what) \
    { .name = "resume", .value = "FILE", .kind = COMMAND_FILE, \
      .many = true, .offset = CMD_PLACE(units.resume), \
      .help = "store finished " what " in FILE and continue from those it has; " \
              "read those of further files, too" }
#define CMD_PART(what) \
    { .name = "part", .value = "K/N", .kind = COMMAND_CUSTOM, \
      .offset = CMD_PLACE(units.job_set), .take = cmd_take_part, \
      .wants = "K/N, with K between 1 and N, such as 1/4", \
      .help = "only the K-th of N shares of the " what ", stored by --resume" }
#define CMD_RANKS \
    { CMD_COUNT("ranks", units.ranks, 1, MAX_RANKS, 0, "MPI processes"), \
      .preset_text = "this process" }
#define CMD_VIEW(usual, usual_text) \
    { .name = "distance", .value = "D", .kind = COMMAND_NUMBER, \
      .offset = CMD_PLACE(view.distance), .most = 1e6, \
      .preset = SPEEDUP_DISTANCE, \
      .help = "distance from the eye to the centre of the shape" }, \
    { .name = "angle", .value = "DEGREES", .kind = COMMAND_NUMBER, \
      .offset = CMD_PLACE(view.angle), .most = 180, .preset = usual, \
      .preset_text = usual_text, .help = "horizontal angle of view" }
#define CMD_MODE(choices, what) \
    { .name = "mode", .value = "MODE", .kind = COMMAND_CHOICE, \
      .offset = CMD_PLACE(trace.mode), .choice = choices, \
      .preset = TRACE_VECTOR, .help = what }
#define CMD_BOUNDS \
    CMD_FLAG("historical", trace.historical, \
             "use the methods of 1984 for cylinders and Steiner patches"), \
    CMD_FLAG("no-bounds", trace.no_bounds, \
             "test every ray against every primitive"), \
    CMD_FLAG("flat", trace.flat, \
             "use no hierarchy: regions in the order of the scene, CSG trees " \
             "as written"), \
    { .name = "visible", .value = "WAY", .kind = COMMAND_CHOICE, \
      .offset = CMD_PLACE(trace.visible), .choice = cmd_visible_choice, \
      .help = "method for CSG solids in vector form" }
#define CMD_SAMPLES \
    { CMD_COUNT("samples", trace.samples, 1, MAX_TRACE_SAMPLES, 1, \
                "N x N rays per pixel, averaged") }
#define CMD_THRESHOLD \
    { .name = "threshold", .value = "T", .kind = COMMAND_NUMBER, \
      .offset = CMD_PLACE(trace.threshold), .most = 1000, \
      .help = "take the samples only in pixels whose colour differs by T or more " \
              "from a neighbour's; all others have one ray" }
#define CMD_ORDER(usual) \
    { .name = "order", .value = "ORDER", .kind = COMMAND_CHOICE, \
      .offset = CMD_PLACE(trace.order), .choice = cmd_order_choice, \
      .preset = usual, .help = "order of the pixels; by default tiles in vector form" }
#define CMD_READ \
    CMD_FLAG("strict", strict, \
             "report replaced or ignored features as errors"), \
    COMMAND_OPTION_INCLUDE(CMD_PLACE(search))
#define CMD_PIXEL(option, what) \
    { .name = option, .value = "X,Y", .kind = COMMAND_CUSTOM, \
      .offset = CMD_PLACE(pixel), .take = cmd_take_pixel, \
      .wants = "column and row of a pixel, counted from 0, such as 12,7", .help = what }
#define CMD_SCENE \
    { .value = "SCENE", .kind = COMMAND_INPUT, .offset = CMD_PLACE(scene), \
      .help = "a scene file" }
/* clang-format on */

/* ---- Running a command -------------------------------------------------- */

/* The work of a command. Its model is set and its results are open. Returns the
 * exit code, or CMD_UNDRAWN if all results exist except the picture. */
typedef int cmd_work(const struct rt205_arguments *arguments,
                     const struct command_output *results);
enum { CMD_UNDRAWN = CMD_USAGE + 1 };
/* Runs the work unless the frame is too large. JSON is kept if the work returns
 * CMD_DONE or CMD_UNDRAWN, else discarded. Returns the exit code, which is
 * CMD_FAILED for CMD_UNDRAWN. */
int cmd_with_machine(struct rt205_arguments *arguments, cmd_work *work);

/* Does the same for a command with units of work, which other ranks may run. Other
 * ranks print and write nothing. */
int cmd_with_jobs(struct rt205_arguments *arguments, cmd_work *work);
/* Reports the state of a share of this many units. Returns CMD_DONE. */
int cmd_print_share(const struct rt205_arguments *arguments, size_t units);
enum { MAX_RANKS = 4096 };
bool cmd_take_part(char *text, void *job_set);
/* Parses a share such as "1/4". Returns false if the text is none. */
bool cmd_is_part(const char *text, struct job_set *job_set);

/* Parses X,Y. */
bool cmd_take_pixel(char *text, void *pixel);
/* Checks that the frame has the pixel. Returns CMD_DONE, or the exit code after an
 * error message. */
int cmd_check_pixel(const struct rt205_arguments *arguments);

/* Checks that the picture, if requested, can be written. Returns CMD_DONE, or the
 * exit code after reporting the reason. */
int cmd_check_picture(const struct rt205_arguments *arguments);

/* Reads the scene of the arguments. Its diagnostics go to stderr. Returns NULL
 * after reporting its errors. */
struct scene *cmd_read_scene(const struct rt205_arguments *arguments);
/* Reads the scene, calls the function with it, and prints its error if it fails. Returns the
 * exit status. */
typedef bool cmd_scene_function(const struct rt205_arguments *arguments,
                                const struct scene *scene,
                                const struct command_output *results,
                                c205_error *error);
int cmd_with_scene(const struct rt205_arguments *arguments,
                   const struct command_output *results, cmd_scene_function *function);

/* Makes Ctrl-C stop a trace, and a second Ctrl-C end the process, and shows
 * progress on stderr if that is a terminal. Both use the progress of the trace
 * options. */
void cmd_watch(struct rt205_arguments *arguments);

#endif
