/* session.c - opens and closes the session of a command: ranks, model, output and
 * scene. */
#include "rt/command/session.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/interrupt.h"
#include "base/named_model.h"
#include "rt/picture/picture.h"
#include "rt/platform/processes.h"
#include "rt/platform/processors.h"

/* ---- Ranks --------------------------------------------------------------- */

/* Replaces this process by mpirun, which starts the requested number of copies of this
 * program. */
static int begin_ranks(const struct trace_session *session)
{
    char count[24];
    char *const words[] = {
        "mpirun", "--oversubscribe", "--bind-to", "none", "-n", count, NULL
    };

    snprintf(count, sizeof count, "%zu", session->jobs->ranks);
    /* mpirun refuses to run as root without these variables. */
    setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 1);
    setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 1);
    /* Selects communication within one host. Otherwise the library would search for
     * networks of all kinds, which takes 0.2 s. */
    setenv("OMPI_MCA_pml", "ob1", 0);
    process_become(words);
    return cmd_failed(session->shared->command,
                      errno == ENOENT ? "mpirun is not installed; install the "
                                        "package openmpi-bin"
                                      : "cannot start mpirun");
}

/* Discards the output of a rank other than 0. */
static void be_silent(struct trace_arguments *shared)
{
    shared->output = NULL;
    shared->results.path = NULL;
    shared->results.format = OUTPUT_TEXT;
    if (!freopen("/dev/null", "w", stdout) || !freopen("/dev/null", "w", stderr))
        abort();
}

static int join_ranks(struct trace_session *session)
{
    struct trace_arguments *shared = session->shared;
    c205_error error;
    if (shared->trace.jobs > 1)
        return cmd_usage(shared->command,
                         "--jobs cannot be combined with ranks: each rank runs one "
                         "unit at a time");
    if (!ranks_join(&session->ranks, &error))
        return cmd_failed(shared->command, "%s", error.message);
    session->jobs->job_set.ranks = &session->ranks;
    shared->trace.jobs = 1;
    if (session->ranks.rank > 0)
        be_silent(shared);
    return CMD_DONE;
}

static int open_jobs(struct trace_session *session)
{
    struct trace_arguments *shared = session->shared;
    struct job_set *job_set = &session->jobs->job_set;
    job_set->paths = session->jobs->resume.items;
    job_set->path_count = session->jobs->resume.count;
    shared->trace.job_set = job_set;
    if (job_set->parts > 0 && job_set->path_count == 0)
        return cmd_usage(shared->command, "--part requires --resume FILE");
    if (job_set->parts > 0 && (shared->output || shared->results.path))
        return cmd_usage(shared->command,
                         "--part cannot be combined with -o or --json");
    return ranks_are_many()           ? join_ranks(session)
           : session->jobs->ranks > 1 ? begin_ranks(session)
                                      : CMD_DONE;
}

static int close_jobs(struct trace_session *session, int code)
{
    struct job_set *job_set = &session->jobs->job_set;
    if (job_set->ranks) {
        ranks_leave(job_set->ranks, code == CMD_DONE ? NULL : "its run failed");
        code = session->ranks.rank > 0 ? CMD_DONE : code;
    }
    job_set_close(job_set, false);
    return code;
}

/* ---- Model and output ---------------------------------------------------- */

static int check_frame(const struct trace_arguments *shared)
{
    const struct trace_options *trace = &shared->trace;
    if (trace->height > 0 && trace->width > MAX_TRACE_PIXELS / trace->height)
        return cmd_usage(shared->command, "at most %zu pixels are allowed",
                         MAX_TRACE_PIXELS);
    if (trace->threshold > 0 && trace->samples < 2)
        return cmd_usage(shared->command, "--threshold requires --samples 2 or more");
    return CMD_DONE;
}

int session_open(struct trace_session *session, struct trace_arguments *shared,
                 struct job_arguments *jobs)
{
    int code;
    *session = (struct trace_session){ .shared = shared, .jobs = jobs };
    code = jobs ? open_jobs(session) : CMD_DONE;
    if (code == CMD_DONE)
        code = check_frame(shared);
    if (code != CMD_DONE)
        return code;
    session->model = model_open(shared->command, shared->model);
    if (!session->model)
        return CMD_FAILED;
    if (c205_model_is_projection(session->model))
        return cmd_failed(shared->command, "%s is a projection and cannot run programs",
                          c205_model_name(session->model));
    shared->trace.model = session->model;
    shared->trace.jobs = jobs_wanted(shared->trace.jobs, MAX_TRACE_JOBS);
    session->results = shared->results;
    if (!output_open(&session->results, shared->command, shared->output))
        return CMD_FAILED;
    session_watch(session);
    return CMD_DONE;
}

int session_close(struct trace_session *session, int code)
{
    code = output_close(&session->results, code);
    scene_free(session->scene);
    c205_model_free(session->model);
    return session->jobs ? close_jobs(session, code) : code;
}

/* ---- Scene --------------------------------------------------------------- */

static bool go_on(void *context)
{
    (void)context;
    return !interrupt_pending();
}

const struct scene *session_scene(struct trace_session *session,
                                  const struct scene_arguments *args)
{
    struct scene_options options = {
        .width = (int)session->shared->trace.width,
        .height = (int)session->shared->trace.height,
        .strict = args->strict,
        .search = args->search.items,
        .go_on = go_on,
        .read_raster = picture_read_raster,
    };
    struct diagnostics reports = { 0 };
    session->scene = scene_read(args->path, &options, &reports);
    diagnostics_print(&reports, stderr);
    diagnostics_free(&reports);
    if (!session->scene || session->scene->primitive_count > 0)
        return session->scene;
    /* A scene without objects is usually a mistake. */
    cmd_print_line(stderr,
                   "%s: %s: the scene has no objects: every pixel is background",
                   args->path, args->strict ? "error" : "warning");
    return args->strict ? NULL : session->scene;
}
