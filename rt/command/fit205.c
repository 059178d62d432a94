/* fit205.c - the command: the timing model fitted to what was published. */
#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/complain.h"
#include "base/whole.h"
#include "rt/study/fit/goal.h"
#include "rt/study/fit/report.h"
#include "rt/study/fit/written.h"

const char cmd_program[] = "fit205";

static const char usage[] =
    "fit205 - constants of the timing model, fitted to published times\n"
    "\n"
    "  --data DIR           constants.csv, observations, programs (rt/study/fit)\n"
    "  --hold-out NAME      leave that observation out, and compare it\n"
    "  --brief              the fit alone: nothing left out or doubled\n"
    "  -W, --width N        rays across a frame in scalar form (32)\n"
    "  -H, --height N       rays down (20)\n"
    "  --angle DEGREES      that a frame's rays span across (10: all hit)\n"
    "  --jobs N             threads (2)\n"
    "  --write FILE         the fitted model; its name says of which priors:\n"
    "                       cyber205-2pipe.model of cyber205-2pipe-prior\n"
    "  --json FILE          write the results to a file as well\n";

enum { HELD_MOST = 32, WRITTEN_MOST = 8, PATH_SIZE = 512 };

struct arguments {
    const char *data, *json;
    const char *held[HELD_MOST], *written[WRITTEN_MOST];
    size_t held_count, written_count, width, height, jobs;
    double angle;
    bool brief, help;
};

static const struct option options[] = {
    { "data", required_argument, NULL, 'd' },
    { "hold-out", required_argument, NULL, 'o' },
    { "brief", no_argument, NULL, 'b' },
    { "width", required_argument, NULL, 'W' },
    { "height", required_argument, NULL, 'H' },
    { "angle", required_argument, NULL, 'A' },
    { "jobs", required_argument, NULL, 'J' },
    { "write", required_argument, NULL, 'w' },
    { "json", required_argument, NULL, 'j' },
    { "help", no_argument, NULL, 'h' },
    { NULL, 0, NULL, 0 },
};

static bool take_count(const char *text, size_t most, size_t *count)
{
    char *end;
    unsigned long value = strtoul(text, &end, 10);

    *count = value;
    return *text >= '1' && *text <= '9' && *end == '\0' && value <= most;
}

static bool take_angle(const char *text, double *degrees)
{
    char *end;

    *degrees = strtod(text, &end);
    return end != text && *end == '\0' && *degrees > 0 && *degrees < 180;
}

static bool add_name(const char **names, size_t *count, size_t most)
{
    if (*count == most)
        return false;
    names[(*count)++] = optarg;
    return true;
}

static bool take(int letter, struct arguments *arguments)
{
    switch (letter) {
    case 'd': arguments->data = optarg; return true;
    case 'j': arguments->json = optarg; return true;
    case 'b': arguments->brief = true; return true;
    case 'h': arguments->help = true; return true;
    case 'W': return take_count(optarg, 1000, &arguments->width);
    case 'H': return take_count(optarg, 1000, &arguments->height);
    case 'A': return take_angle(optarg, &arguments->angle);
    case 'J': return take_count(optarg, 64, &arguments->jobs);
    case 'o':
        return add_name(arguments->held, &arguments->held_count, HELD_MOST);
    case 'w':
        return add_name(arguments->written, &arguments->written_count,
                        WRITTEN_MOST);
    default: return false;
    }
}

static bool wrong(const char *what, const char *word, const char *more)
{
    fprintf(stderr, "%s: %s%s%s\n%s --help tells how it is used\n",
            cmd_program, what, word, more, cmd_program);
    return false;
}

/* False: what is wrong has been told. */
static bool parse(int argc, char **argv, struct arguments *arguments)
{
    int letter;

    opterr = 0;
    while ((letter = getopt_long(argc, argv, ":W:H:", options, NULL)) != -1) {
        const char *word = argv[optind - 1];

        if (word == optarg)
            word = argv[optind - 2];
        if (letter == ':')
            return wrong(word, " needs an argument", "");
        if (letter == '?')
            return wrong("no such option: ", word, "");
        if (!take(letter, arguments))
            return wrong(word, ": wrong argument: ", optarg);
    }
    return optind == argc || arguments->help
           || wrong("too many arguments: ", argv[argc - 1], "");
}

/* ---- Reading ------------------------------------------------------------ */

struct sources {
    c205_model *model;
    struct observations observations;
    struct constants constants;
};

/* What was found in a file, printed. */
static bool is_read(bool good, const char *path,
                    struct diagnostics *diagnostics, c205_error *error)
{
    diagnostics_print(diagnostics, stderr);
    diagnostics_free(diagnostics);
    if (!good)
        snprintf(error->message, sizeof error->message,
                 "%.200s cannot be used", path);
    return good;
}

static bool read_sources(const struct arguments *arguments,
                         struct sources *sources, c205_error *error)
{
    static const char *const files[] = { "table1.csv", "machine.csv" };
    char path[PATH_SIZE], programs[PATH_SIZE];
    struct run_options how = { .folder = programs };
    struct diagnostics found = { 0 };

    how.model = sources->model = c205_model_find("cyber205-2pipe-prior",
                                                 error);
    /* The vector form is short of instructions, and the queue must be full:
     * so it has all 100,000 rays. */
    how.width[TRACE_VECTOR] = 400;
    how.height[TRACE_VECTOR] = 250;
    how.width[TRACE_SCALAR] = arguments->width;
    how.height[TRACE_SCALAR] = arguments->height;
    how.view.distance = SPEEDUP_DISTANCE;
    how.view.angle = arguments->angle;
    snprintf(programs, sizeof programs, "%.400s/programs", arguments->data);
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        snprintf(path, sizeof path, "%.400s/observations/%s", arguments->data,
                 files[i]);
        if (!how.model
            || !is_read(observations_read(&sources->observations, path, &how,
                                          &found),
                        path, &found, error))
            return false;
    }
    snprintf(path, sizeof path, "%.400s/constants.csv", arguments->data);
    return is_read(constants_read(&sources->constants, path, &found), path,
                   &found, error);
}

static bool hold_out(const struct arguments *arguments,
                     const struct observations *all, struct study *study,
                     c205_error *error)
{
    for (size_t i = 0; i < arguments->held_count; i++) {
        bool found = false;

        for (size_t k = 0; k < all->count; k++)
            if (strcmp(all->items[k].name, arguments->held[i]) == 0)
                study->held.held[k] = found = true;
        if (!found) {
            snprintf(error->message, sizeof error->message,
                     "there is no observation '%.100s'", arguments->held[i]);
            return false;
        }
    }
    return true;
}

/* ---- Writing ------------------------------------------------------------ */

/* Write the models, and see what they show as they are written. */
static bool write_models(const struct arguments *arguments,
                         const struct study *study, double *written,
                         c205_error *error)
{
    bool good = arguments->written_count == 0
                || written_predict(study, written, error);

    for (size_t i = 0; good && i < arguments->written_count; i++)
        good = written_model(study, written, arguments->written[i], error);
    return good;
}

/* Whether all files can be, asked before a minute of work. */
static bool check_files(const struct arguments *arguments,
                        const struct study *study, c205_error *error)
{
    for (size_t i = 0; i < arguments->written_count; i++)
        if (!written_check(study, arguments->written[i], error))
            return false;
    return !arguments->json || whole_check(arguments->json, error);
}

static bool print(const struct arguments *arguments,
                  const struct study *study, c205_error *error)
{
    double written[FIT_OBSERVATIONS_MOST];
    struct json *json = NULL;
    bool good;

    if (!write_models(arguments, study, written, error))
        return false;
    if (arguments->json) {
        json = json_open(arguments->json, error);
        if (!json)
            return false;
    }
    snprintf(error->message, sizeof error->message,
             "the report cannot be written");
    good = report_print(study, arguments->written_count > 0 ? written : NULL,
                        stdout, json);
    goal_print(study, stdout);
    if (json && good)
        return json_close(json, error);
    if (json)
        json_discard(json);
    return good;
}

static bool work(const struct arguments *arguments, struct sources *sources,
                 struct study *study, c205_error *error)
{
    study->brief = arguments->brief;
    study->fit.observations = &sources->observations;
    study->fit.constants = &sources->constants;
    study->fit.jobs = arguments->jobs;
    return read_sources(arguments, sources, error)
           && hold_out(arguments, &sources->observations, study, error)
           && check_files(arguments, study, error) && study_make(study, error)
           && print(arguments, study, error);
}

static bool is_printed(c205_error *error)
{
    if (fflush(stdout) == 0 && !ferror(stdout))
        return true;
    snprintf(error->message, sizeof error->message,
             "standard output: write error");
    return false;
}

int main(int argc, char **argv)
{
    static struct sources sources;
    static struct study study;
    struct arguments arguments = { .data = "rt/study/fit",
                                   .width = 32,
                                   .height = 20,
                                   .angle = SPEEDUP_ANGLE,
                                   .jobs = 2 };
    c205_error error = { "" };
    bool good = true;

    if (!parse(argc, argv, &arguments))
        return CMD_USAGE;
    if (arguments.help)
        fputs(usage, stdout);
    else
        good = work(&arguments, &sources, &study, &error);
    constants_free(&sources.constants);
    observations_free(&sources.observations);
    c205_model_free(sources.model);
    if (good && is_printed(&error))
        return CMD_DONE;
    fprintf(stderr, "%s: %s\n", cmd_program, error.message);
    return CMD_FAILED;
}
