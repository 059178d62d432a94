/* many_scenes.c - the main loop of checks with random scenes. */
#include "tests/oracle/many_scenes.h"

#include "rt/scene/language/scene_read.h"
#include "tests/oracle/read_options.h"
#include "tests/oracle/solid_text.h"
#include "tests/random.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

c205_model *usual_model(void)
{
    return NEEDED(c205_model_find("cyber205-2pipe", &last_error));
}

static struct scene *read_scene(const char *text, struct diagnostics *reports)
{
    const struct scene_options options = { .strict = false };
    return scene_read_text("scene", text, &options, reports);
}

struct scene *scene_of(const char *text)
{
    SCOPED_VALUE(diagnostics) reports = { 0 };
    struct scene *scene = read_scene(text, &reports);
    if (!scene) {
        fputs(text, stderr);
        diagnostics_print(&reports, stderr);
        give_up("this is no scene");
    }
    return scene;
}

struct trace_options sized(struct trace_options form, size_t width, size_t height)
{
    form.width = width;
    form.height = height;
    return form;
}

struct trace *traced_in(const struct scene *scene, struct trace_options options)
{
    options.model = check_model;
    struct trace *trace = trace_new(scene, &options, &last_error);
    need(trace && trace_run(trace, &last_error));
    return trace;
}

static bool same_frames(const struct trace *expected, const struct trace *found,
                        size_t width, size_t height, char *reason)
{
    for (int i = 0; i < FRAME_CHANNELS; i++) {
        const c205_word *a = trace_channel(expected, (enum frame_channel)i);
        const c205_word *b = trace_channel(found, (enum frame_channel)i);
        for (size_t k = 0; k < width * height; k++)
            if (a[k] != b[k]) {
                snprintf(reason, MANY_REASON,
                         "channel %d at %zu, %zu is %016llX, not %016llX", i, k % width,
                         k / width, (unsigned long long)b[k], (unsigned long long)a[k]);
                return false;
            }
    }
    return true;
}

static bool same_rays(const struct trace *expected, const struct trace *found,
                      char *reason)
{
    for (int kind = 0; kind < RAY_KINDS; kind++) {
        uint64_t a = trace_rays(expected, (enum ray_kind)kind);
        uint64_t b = trace_rays(found, (enum ray_kind)kind);
        if (a != b) {
            snprintf(reason, MANY_REASON, "%llu %s rays, not %llu",
                     (unsigned long long)b, ray_kind_name((enum ray_kind)kind),
                     (unsigned long long)a);
            return false;
        }
    }
    return true;
}

/* Appends the options of rt205 render for a form. */
static void print_form(const struct trace_options *form, char *words, size_t size)
{
    int used = snprintf(words, size, " with --mode %s", trace_mode_name(form->mode));
#define OPTION(condition, ...) \
    if (condition) \
    used += snprintf(words + used, size - (size_t)used, " " __VA_ARGS__)
    OPTION(form->mode != TRACE_SCALAR, "--queue %zu", form->queue);
    OPTION(form->no_bounds, "--no-bounds");
    OPTION(form->flat, "--flat");
    OPTION(form->order, "--order %s", order_name(form->order));
    OPTION(form->visible, "--visible every");
    OPTION(form->jobs > 1, "--jobs %zu", form->jobs);
    OPTION(form->band, "(bands of %zu pixels)", form->band);
#undef OPTION
}

bool same_in_form(const struct scene *scene, const struct trace *expected,
                  struct trace_options form, char *reason)
{
    SCOPED(trace) *found = traced_in(scene, form);
    bool good = same_frames(expected, found, form.width, form.height, reason)
                && same_rays(expected, found, reason);
    size_t used = strlen(reason);
    if (!good)
        print_form(&form, reason + used, MANY_REASON - used);
    return good;
}

void keep_scene(const char *path, const char *text)
{
    FILE *file = fopen(path, "w");
    if (file) {
        fputs(text, file);
        fclose(file);
    }
}

c205_model *check_model;

int check_many(int count, char **words, bool (*check)(size_t number, bool first),
               void (*begin)(size_t number), size_t ahead)
{
    uint64_t scenes = 300, of = 1, share = 0;
    bool first = false;
    const struct check_option options[] = {
        { .name = "first", .flag = &first },
        { .number = &scenes },
        { .number = &of },
        { .number = &share },
    };
    READ_OPTIONS(count, words, "CHECK [SCENES [OF SHARE]] [--first]", options);
    if (of == 0)
        give_up("OF is 0");
    size_t passed = 0, failed = 0, next = share;
    check_model = usual_model();
    for (size_t i = share; i < scenes && !(first && failed); i += of) {
        for (; begin && next < scenes && next <= i + ahead * of; next += of)
            begin(next);
        check(i, first) ? passed++ : failed++;
    }
    c205_model_free(check_model);
    printf("%zu passed, %zu failed\n", passed, failed);
    return failed > 0;
}

/* ---- Random scenes ------------------------------------------------------- */

static const struct random_check *the_check;

static bool is_scene(const char *text)
{
    SCOPED_VALUE(diagnostics) reports = { 0 };
    SCOPED(scene) *scene = read_scene(text, &reports);
    return scene;
}

static bool fails(const char *text, void *context)
{
    struct random_scene smaller = *(const struct random_scene *)context;
    char reason[MANY_REASON] = "";
    smaller.text = (char *)text;
    smaller.other = NULL;
    return is_scene(text) && !the_check->passes(&smaller, reason);
}

static void report(struct random_scene *scene, char *reason)
{
    char path[40], size[60] = "";
    if (the_check->shrinks && fails(scene->text, scene)) {
        scene->text = text_shrunk(scene->text, SIZE_MAX, fails, scene);
        free(scene->other);
        scene->other = NULL;
        the_check->passes(scene, reason);
    }
    scene->text = text_indented(scene->text);
    snprintf(path, sizeof path, "%s_%zu.pov", the_check->kind, scene->number);
    if (scene->width)
        snprintf(size, sizeof size, " -W %zu -H %zu", scene->width, scene->height);
    printf("FAIL %s%s: %s\n%s", path, size, reason, scene->text);
    fflush(stdout);
    keep_scene(path, scene->text);
}

static bool check_scene(size_t number, bool first)
{
    uint64_t state = RANDOM_SEED ^ (number + 1) * the_check->seed;
    struct random_scene scene = the_check->draw(&state, number);
    char reason[MANY_REASON] = "";
    scene.number = number;
    scene.state = state;
    bool good = the_check->passes(&scene, reason);
    if (!good && first)
        printf("scene %zu: %s\n", number, reason);
    else if (!good)
        report(&scene, reason);
    free(scene.text);
    free(scene.other);
    return good;
}

int check_random(int count, char **words, const struct random_check *check)
{
    the_check = check;
    return check_many(count, words, check_scene, check->begin, check->ahead);
}
