/* fit205.c - the command fit205: fits the timing model to published times. */
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/command_options.h"
#include "vm/error.h"
#include "rt/study/fit/objective.h"
#include "rt/study/fit/fit_report.h"
#include "rt/study/fit/model_writer.h"
#include "rt/platform/processors.h"

enum { PATH_SIZE = 512 };

struct fit_arguments {
    const char *command;
    const char *data;
    struct command_output results;
    struct command_texts held, written;
    size_t width, height, jobs;
    double angle;
    bool brief;
};

/* ---- Reading ------------------------------------------------------------ */

struct sources {
    c205_model *model;
    struct observations observations;
    struct constants constants;
};

/* Prints the diagnostics of a file. Sets the error if the file cannot be used. */
static bool is_read(bool good, const char *path, struct diagnostics *diagnostics,
                    c205_error *error)
{
    diagnostics_print(diagnostics, stderr);
    diagnostics_free(diagnostics);
    if (!good)
        error_set(error, "cannot use %.200s", path);
    return good;
}

static bool read_sources(const struct fit_arguments *args, struct sources *sources,
                         c205_error *error)
{
    static const char *const files[] = { "table1.csv", "machine.csv", "livermore.csv" };
    char path[PATH_SIZE], programs[PATH_SIZE];
    struct run_options how = { .folder = programs };
    struct diagnostics found = { 0 };
    how.model = sources->model = c205_model_find("cyber205-2pipe-prior", error);
    /* The vector form uses all 100,000 rays: its queue must be full, and it has few
     * instructions to emulate. */
    how.width[TRACE_VECTOR] = 400;
    how.height[TRACE_VECTOR] = 250;
    how.width[TRACE_SCALAR] = args->width;
    how.height[TRACE_SCALAR] = args->height;
    how.view.distance = SPEEDUP_DISTANCE;
    how.view.angle = args->angle;
    snprintf(programs, sizeof programs, "%.400s/programs", args->data);
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        snprintf(path, sizeof path, "%.400s/observations/%s", args->data, files[i]);
        if (!how.model
            || !is_read(observations_read(&sources->observations, path, &how, &found),
                        path, &found, error))
            return false;
    }
    snprintf(path, sizeof path, "%.400s/constants.csv", args->data);
    return is_read(constants_read(&sources->constants, path, &found), path, &found,
                   error);
}

static bool hold_out(const struct fit_arguments *args, const struct observations *all,
                     struct study *study, c205_error *error)
{
    for (size_t i = 0; i < args->held.count; i++) {
        bool found = false;
        for (size_t k = 0; k < all->count; k++)
            if (strcmp(all->items[k].name, args->held.items[i]) == 0)
                study->held.held[k] = found = true;
        if (!found)
            return error_set(error, "unknown observation '%.100s'",
                             args->held.items[i]);
    }
    return true;
}

/* ---- Writing ------------------------------------------------------------ */

/* Sets `written` to predictions of the observations, computed with constants rounded as
 * in a model file. Then writes the requested model files. */
static bool write_models(const struct fit_arguments *args, const struct study *study,
                         double *written, c205_error *error)
{
    bool good = written_predict(study, written, error);
    for (size_t i = 0; good && i < args->written.count; i++)
        good = written_model(study, written, args->written.items[i], error);
    return good;
}

/* Checks that all files can be written, because the fit takes about a minute. */
static bool check_files(const struct fit_arguments *args, const struct study *study,
                        c205_error *error)
{
    for (size_t i = 0; i < args->written.count; i++)
        if (!written_check(study, args->written.items[i], error))
            return false;
    return true;
}

static bool report_progress(const struct fit_arguments *args, const struct study *study,
                            const struct command_output *results, c205_error *error)
{
    double written[MAX_FIT_OBSERVATIONS];
    if (!write_models(args, study, written, error))
        return false;
    error_set(error, "out of memory");
    if (!report_print(study, written, results))
        return false;
    objective_print(study, written, results);
    return true;
}

static bool fit(const struct fit_arguments *args, struct sources *sources,
                struct study *study, const struct command_output *results,
                c205_error *error)
{
    study->brief = args->brief;
    study->fit.observations = &sources->observations;
    study->fit.constants = &sources->constants;
    study->fit.jobs = jobs_wanted(args->jobs, MAX_FIT_JOBS);
    return read_sources(args, sources, error)
           && hold_out(args, &sources->observations, study, error)
           && check_files(args, study, error) && study_make(study, error)
           && report_progress(args, study, results, error);
}

/* ---- The command --------------------------------------------------------- */

static int cmd_fit(void *given)
{
    const struct fit_arguments *args = given;
    struct command_output results = args->results;
    struct sources *sources = calloc(1, sizeof *sources);
    struct study *study = calloc(1, sizeof *study);
    c205_error error = { "out of memory" };
    int code = CMD_DONE;
    if (!output_open(&results, args->command, NULL))
        code = CMD_FAILED;
    else if (!sources || !study || !fit(args, sources, study, &results, &error))
        code = cmd_failed(args->command, "%s", error.message);
    if (sources) {
        constants_free(&sources->constants);
        observations_free(&sources->observations);
        c205_model_free(sources->model);
    }
    free(sources);
    free(study);
    return output_close(&results, code);
}

#define PLACE(member) offsetof(struct fit_arguments, member)

static const struct command_option options[] = {
    { OPTION_ROW("data", "DIR", COMMAND_FOLDER, PLACE(data),
                 "folder of constants.csv, observations and programs"),
      .preset_text = "rt/study/fit" },
    { OPTION_ROW("hold-out", "NAME", COMMAND_TEXT, PLACE(held),
                 "exclude this observation from the fit, and compare it"),
      .many = true },
    OPTION_FLAG("brief", PLACE(brief),
                "only the fit, without runs that leave out rows or double priors"),
    { OPTION_COUNT("width", PLACE(width), 1, 1000, 32,
                   "width of a frame in scalar form, in rays"),
      .letter = 'W' },
    { OPTION_COUNT("height", PLACE(height), 1, 1000, 20,
                   "height of a frame in scalar form, in rays"),
      .letter = 'H' },
    { OPTION_ROW("angle", "DEGREES", COMMAND_NUMBER, PLACE(angle),
                 "horizontal angle of view of a frame; at the default all rays hit"),
      .most = 180, .preset = SPEEDUP_ANGLE },
    { OPTION_COUNT("jobs", PLACE(jobs), 1, MAX_FIT_JOBS, 0, "threads"),
      .preset_text = "one for each processor" },
    { OPTION_ROW("write", "FILE", COMMAND_FILE, PLACE(written),
                 "write the fitted model; its name selects the priors: "
                 "cyber205-2pipe.model for cyber205-2pipe-prior"),
      .many = true },
    OUTPUT_OPTIONS(struct fit_arguments, results),
    COMMAND_END
};

int main(int argc, char **argv)
{
    static const struct command command = {
        .summary = "constants of the timing model, fitted to published times",
        .function = cmd_fit,
        .arguments_size = sizeof(struct fit_arguments),
        .options = options,
    };
    static const struct command *const commands[] = { &command, NULL };
    static const struct command_program program = {
        .name = "fit205",
        .summary = "constants of the timing model, fitted to published times",
        .version = C205_VERSION,
        .commands = commands,
    };
    return command_main(&program, argc, argv);
}
