/* run.c - runs each program once and records it. Computes its clocks with other timing
 * constants from the recording. */
#include "rt/study/fit/run.h"
#include "vm/error.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "vm/text.h"

enum { MAX_DEFINES = 8, MAX_WORDS = 256 };

static bool run_fail(c205_error *error, const char *what, const char *name)
{
    return error_set(error, what, name);
}

static char *copied(const char *text)
{
    char *copy = malloc(strlen(text) + 1);
    return !copy ? NULL : strcpy(copy, text);
}

/* ---- Frames ------------------------------------------------------------- */

/* Splits a name such as "Steiner scalar" into subject and form. */
static bool find_subject(struct fit_run *run, enum trace_mode *mode)
{
    for (size_t i = 0; i < speedup_subject_count; i++) {
        const char *name = speedup_subjects[i].name;
        size_t length = strlen(name);
        if (strncmp(run->program, name, length) == 0 && run->program[length] == ' '
            && trace_mode_named(run->program + length + 1, mode)
            && *mode < TRACE_FORMS) {
            run->subject = &speedup_subjects[i];
            return true;
        }
    }
    return false;
}

static c205 *frame_machine(struct fit_run *run, enum trace_mode mode,
                           const struct run_options *options, c205_error *error)
{
    const struct trace_options how = { .mode = mode,
                                       .width = options->width[mode],
                                       .height = options->height[mode],
                                       .queue = TRACE_QUEUE,
                                       .model = options->model };
    run->rays = how.width * how.height;
    run->trace = speedup_trace(run->subject, &options->view, &how, &run->scene, error);
    return !run->trace ? NULL : trace_machine(run->trace, 0, error);
}

/* ---- Source files ------------------------------------------------------- */

/* Splits "FILE.s NAME=VALUE ..." into the file name and the defines. The defines end
 * with a NULL name. */
static bool cut_words(char *words, struct asm_define *defines, c205_error *error)
{
    size_t count = 0;
    strtok(words, " ");
    for (char *word; (word = strtok(NULL, " ")) != NULL;) {
        char *value = strchr(word, '=');
        if (!value || count + 1 == MAX_DEFINES)
            return run_fail(error, "'%.60s' does not define a constant", word);
        *value++ = '\0';
        defines[count++] = (struct asm_define){ word, atoll(value) };
    }
    defines[count].name = NULL;
    return true;
}

static bool assemble_observed(struct fit_run *run, const struct run_options *options,
                              c205_error *error)
{
    const struct text *const texts[] = { kernel_texts, NULL };
    struct asm_define defines[MAX_DEFINES];
    struct asm_options how = { .defines = defines, .texts = texts };
    struct diagnostics errors = { 0 };
    char words[MAX_WORDS], path[2 * MAX_WORDS];
    snprintf(words, sizeof words, "%s", run->program);
    if (!cut_words(words, defines, error))
        return false;
    snprintf(path, sizeof path, "%.200s/%s", options->folder, words);
    run->object = assemble_file(path, &how, &errors);
    if (!run->object)
        run_fail(error, "%.200s",
                 errors.count > 0 ? errors.items[0].message : "out of memory");
    diagnostics_free(&errors);
    return run->object != NULL;
}

static c205 *text_machine(struct fit_run *run, const struct run_options *options,
                          c205_error *error)
{
    c205 *machine = assemble_observed(run, options, error)
                        ? c205_new(options->model, error)
                        : NULL;
    if (machine && !c205_load(machine, &run->object->program, error)) {
        c205_free(machine);
        machine = NULL;
    }
    return machine;
}

/* ---- Runs --------------------------------------------------------------- */

static bool name_regions(struct fit_run *run, const c205 *machine, c205_error *error)
{
    run->region_count = c205_account_count(machine);
    if (run->region_count > MAX_RUN_REGIONS)
        return run_fail(error, "%s: more than " LIMIT_TEXT(MAX_RUN_REGIONS) " regions",
                        run->program);
    for (size_t i = 0; i < run->region_count; i++) {
        run->regions[i] = copied(c205_account_at(machine, i)->name);
        if (!run->regions[i])
            return run_fail(error, "%s: out of memory", run->program);
    }
    return true;
}

static bool record(struct fit_run *run, c205 *machine, c205_error *error)
{
    c205_stop stop;
    run->recording = c205_recording_new(error);
    if (!run->recording || !name_regions(run, machine, error)
        || !c205_listen(machine, c205_record, run->recording))
        return false;
    stop = c205_run(machine, C205_NO_LIMIT);
    if (stop.trap == C205_TRAP_NONE && stop.status == 0)
        return true;
    c205_describe_stop(machine, &stop, error);
    return false;
}

struct fit_run *run_new(const char *program, const struct run_options *options,
                        c205_error *error)
{
    struct fit_run *run = calloc(1, sizeof *run);
    enum trace_mode mode;
    c205 *machine = NULL;
    bool good;
    run_fail(error, "%s", "out of memory");
    if (run && (run->program = copied(program)) != NULL)
        machine = find_subject(run, &mode) ? frame_machine(run, mode, options, error)
                                           : text_machine(run, options, error);
    good = machine && record(run, machine, error);
    c205_free(machine);
    if (good)
        return run;
    run_free(run);
    return NULL;
}

void run_free(struct fit_run *run)
{
    if (!run)
        return;
    for (size_t i = 0; i < run->region_count; i++)
        free(run->regions[i]);
    c205_recording_free(run->recording);
    trace_free(run->trace);
    scene_free(run->scene);
    object_free(run->object);
    free(run->program);
    free(run);
}

bool run_symbol(const struct fit_run *run, const char *name, double *value)
{
    const struct asm_symbol *symbol = !run->object ? NULL
                                                   : object_symbol(run->object, name);
    if (!symbol || symbol->is_word)
        return false;
    *value = (double)symbol->value;
    return true;
}

static bool is_timed(const struct fit_run *run, const char *region)
{
    if (!run->subject)
        return *region != '\0';
    for (size_t i = 0; i < MAX_SPEEDUP_REGIONS; i++)
        if (run->subject->regions[i] && strcmp(run->subject->regions[i], region) == 0)
            return true;
    return false;
}

bool run_select(const struct fit_run *run, const char *name,
                bool chosen[MAX_RUN_REGIONS], c205_error *error)
{
    bool found = false;
    for (size_t i = 0; i < run->region_count; i++) {
        chosen[i] = *name != '\0' ? strcmp(run->regions[i], name) == 0
                                  : is_timed(run, run->regions[i]);
        found = found || chosen[i];
    }
    return found || run_fail(error, "unknown region '%.60s'", name);
}

bool run_time(const struct fit_run *run, const c205_model *model,
              const c205_setting *settings, size_t count, unsigned ticks,
              double clocks[MAX_RUN_REGIONS], c205_error *error)
{
    return c205_retime(run->recording, model, settings, count, ticks, clocks,
                       run->region_count, error);
}
