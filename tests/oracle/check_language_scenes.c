/* check_language_scenes.c - compares the pictures of random scene texts with POV-Ray's.
 *
 *     check_language_scenes [SCENES [OF SHARE]] [--first]        (many_scenes.h)
 *
 * Neither rt205 nor POV-Ray may report an error or a warning for a text of
 * language_scene.h. The three modes, by rows and by tiles, with random queue lengths, in
 * one job and in two, must give the same frame bit for bit, which must equal POV-Ray's
 * picture. As in check_sample, a pixel differs if a channel differs by more than .02 of
 * white. One pixel in a thousand may differ.
 *
 * Rounding can decide which side of an edge a pixel shows. A different pixel is
 * therefore excused if POV-Ray's picture changes there when the camera moves by a
 * hundredth of a pixel in one of four directions. POV-Ray draws the pictures before and
 * after the move with the camera that rt205 has read, so that a camera that was read
 * wrongly excuses nothing. At most one pixel in fifty is excused.
 *
 * A failing scene is reduced, line by line and block by block, while it fails in the
 * same way. It is printed with its seed and written to language_N.pov. Only the first
 * three failing scenes are reduced, because this takes minutes. Exit status 2: POV-Ray
 * is missing.
 */
#include "rt/picture/picture.h"
#include "rt/scene/language/scene_read.h"
#include "rt/trace/trace.h"
#include "tests/oracle/chance.h"
#include "tests/oracle/compare_pictures.h"
#include "tests/oracle/language_scene.h"
#include "tests/oracle/many_scenes.h"
#include "tests/oracle/run_povray.h"
#include "tests/oracle/solid_text.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum {
    WIDTH = LANGUAGE_WIDTH,
    HEIGHT = LANGUAGE_HEIGHT,
    PIXELS = WIDTH * HEIGHT,
    MAX_OTHERS = PIXELS / 1000,
    MAX_FORGIVEN = PIXELS / 50,
    AHEAD = 8,        /* number of POV-Ray runs that are started in advance */
    MAX_TRIALS = 400, /* number of trials to reduce a scene */
    MAX_SMALLER = 3,  /* number of scenes that are reduced */
    REASON = MANY_REASON,
    PATH = 80
};
#define TOLERANCE .02
#define MOVED .01 /* in pixels */

/* The kind of failure. It must not change while a scene is reduced. */
enum fault { NO_FAULT, NOT_READ, NOT_BY_POVRAY, OTHER_FRAME, OTHER_PICTURE };

struct judgement {
    size_t number; /* number of the scene */
    enum fault fault;
    char message[REASON]; /* the error message without its position */
    char reason[REASON];
    size_t pixel; /* the pixel with the greatest difference */
};

static bool blame(struct judgement *judgement, enum fault fault, const char *message)
{
    judgement->fault = fault;
    snprintf(judgement->message, REASON, "%.500s", message);
    snprintf(judgement->reason, REASON, "%.500s", message);
    return false;
}

/* ---- Reading ------------------------------------------------------------- */

static struct scene *read_text(const char *text, struct judgement *judgement)
{
    const struct scene_options options = { .width = WIDTH,
                                           .height = HEIGHT,
                                           .strict = true };
    SCOPED_VALUE(diagnostics) reports = { 0 };
    struct scene *scene = scene_read_text("scene", text, &options, &reports);
    if (!scene) {
        const struct diagnostic *first = reports.items;
        blame(judgement, NOT_READ,
              reports.count > 0 ? first->message : "it cannot be read");
        if (reports.count > 0)
            snprintf(judgement->reason, REASON, "line %zu: %.300s", first->line,
                     first->message);
    }
    return scene;
}

/* ---- Forms --------------------------------------------------------------- */

/* The forms. Each form is compared with the first. Queue lengths are random. */
static const struct trace_options forms[] = {
    { .mode = TRACE_SCALAR, .queue = 1 },
    { .mode = TRACE_VECTOR, .order = ORDER_TILES, .jobs = 2 },
    { .mode = TRACE_VECTOR, .order = ORDER_ROWS, .jobs = 1 },
    { .mode = TRACE_KERNELS, .order = ORDER_TILES, .jobs = 1 },
    { .mode = TRACE_KERNELS, .order = ORDER_ROWS, .jobs = 2 },
};
enum { FORMS = sizeof forms / sizeof *forms };

static struct trace_options random_form(size_t i, uint64_t *state)
{
    struct trace_options form = sized(forms[i], WIDTH, HEIGHT);
    if (form.mode != TRACE_SCALAR)
        form.queue = one_in(state, 4) ? TRACE_QUEUE
                                      : (size_t)of_any_size(state, 4, 2 * PIXELS);
    if (form.jobs > 1)
        form.band = PIXELS / 5 + below(state, PIXELS / 2);
    return form;
}

static bool same_in_all_forms(const struct scene *scene, const struct trace *expected,
                              uint64_t state, struct judgement *judgement)
{
    char reason[REASON] = "";
    for (size_t i = 1; i < FORMS; i++)
        if (!same_in_form(scene, expected, random_form(i, &state), reason))
            return blame(judgement, OTHER_FRAME, reason);
    return true;
}

/* ---- POV-Ray ------------------------------------------------------------- */

/* Starts a run. Its input file is in the current folder. */
static struct povray *begin_run(const char *text, size_t number, const char *what)
{
    char path[PATH];
    snprintf(path, PATH, "language_%zu%s.pov", number, what);
    return povray_begin(path, text, WIDTH, HEIGHT);
}

/* Returns the text with rt205's camera moved by `right` and `up` pixels. */
static char *text_seen_from(const char *text, const struct camera *camera, double right,
                            double up)
{
    struct camera moved = *camera;
    double *place = camera->orthographic ? moved.location : moved.direction;
    char *words;
    FILE *file = test_text(&words);
    for (int i = 0; i < 3; i++)
        place[i] += right / WIDTH * camera->right[i] + up / HEIGHT * camera->up[i];
    fprintf(file, "%s\ncamera { %s\n", text,
            camera->orthographic ? "orthographic" : "");
#define VECTOR(name) \
    fprintf(file, #name " <%.17g, %.17g, %.17g>\n", moved.name[0], moved.name[1], \
            moved.name[2])
    VECTOR(location);
    VECTOR(direction);
    VECTOR(right);
    VECTOR(up);
#undef VECTOR
    fprintf(file, "}\n");
    fclose(file);
    return words;
}

/* ---- Pictures ------------------------------------------------------------ */

static double shown(double sample)
{
    return fmin(1, fmax(0, sample));
}

/* Marks the pixels that differ. Returns their number. */
static size_t others(const struct frame *a, const struct frame *b, bool other[PIXELS],
                     double *greatest)
{
    size_t count = 0;
    *greatest = 0;
    for (size_t k = 0; k < PIXELS; k++) {
        double most = 0;
        for (int i = CHANNEL_RED; i <= CHANNEL_BLUE; i++)
            most = fmax(most, fabs(shown(a->channel[i][k]) - shown(b->channel[i][k])));
        other[k] = !(most <= TOLERANCE);
        count += other[k];
        *greatest = fmax(*greatest, most);
    }
    return count;
}

enum { SIDES = 5 };
static const double sides[SIDES][2] = {
    { 0, 0 }, { MOVED, 0 }, { -MOVED, 0 }, { 0, MOVED }, { 0, -MOVED }
};

/* Marks the pixels at which POV-Ray's picture changes when the camera is moved. */
static bool find_edges(const char *text, const struct camera *camera, size_t number,
                       bool edge[PIXELS])
{
    struct povray *runs[SIDES];
    struct frame picture[SIDES];
    c205_error error;
    bool other[PIXELS], good[SIDES], all = true;
    for (int i = 0; i < SIDES; i++) {
        char what[16], *moved = text_seen_from(text, camera, sides[i][0], sides[i][1]);
        snprintf(what, sizeof what, "_side_%d", i);
        runs[i] = begin_run(moved, number, what);
        free(moved);
    }
    memset(edge, false, PIXELS * sizeof *edge);
    for (int i = 0; i < SIDES; i++) {
        double greatest;
        good[i] = povray_end(runs[i], &picture[i], &error);
        all &= good[i];
        if (i > 0 && good[0] && good[i])
            others(&picture[0], &picture[i], other, &greatest);
        for (size_t k = 0; i > 0 && good[0] && good[i] && k < PIXELS; k++)
            edge[k] |= other[k];
    }
    for (int i = 0; i < SIDES; i++)
        if (good[i])
            frame_free(&picture[i]);
    return all;
}

static bool same_picture(const char *text, const struct camera *camera,
                         const struct frame *ours, const struct frame *theirs,
                         struct judgement *judgement)
{
    bool other[PIXELS], edge[PIXELS];
    double greatest;
    size_t count = others(ours, theirs, other, &greatest), forgiven = 0;
    size_t left = 0, worst = 0;
    if (count <= MAX_OTHERS)
        return true;
    if (!find_edges(text, camera, judgement->number, edge))
        return blame(judgement, NOT_BY_POVRAY, "not from a side");
    for (size_t k = 0; k < PIXELS; k++) {
        forgiven += other[k] && edge[k];
        left += other[k] && !edge[k];
        if (other[k] && !edge[k])
            worst = k;
    }
    if (left <= MAX_OTHERS && forgiven <= MAX_FORGIVEN)
        return true;
    blame(judgement, OTHER_PICTURE, "");
    judgement->pixel = worst;
    snprintf(judgement->reason, REASON,
             "POV-Ray shows %zu of %d pixels otherwise, by %.3f, and %zu on "
             "edges; at %zu, %zu: %.4f %.4f %.4f, here %.4f %.4f %.4f",
             left, PIXELS, greatest, forgiven, worst % WIDTH, worst / WIDTH,
             theirs->channel[0][worst], theirs->channel[1][worst],
             theirs->channel[2][worst], ours->channel[0][worst],
             ours->channel[1][worst], ours->channel[2][worst]);
    return false;
}

/* --- scenes --------------------------------------------------------------- */

static uint64_t seed_of(size_t number)
{
    return RANDOM_SEED ^ (number + 1) * UINT64_C(0x9E3779B97F4A7C15);
}

static void judge_scene(const char *text, const struct scene *scene, struct povray *run,
                        struct judgement *judgement)
{
    SCOPED(trace) *expected = traced_in(scene, random_form(0, NULL));
    c205_error error;
    struct frame ours, theirs;
    bool good = same_in_all_forms(scene, expected, seed_of(judgement->number),
                                  judgement);
    bool read = povray_end(run, &theirs, &error);
    need(frame_allocate(&ours, WIDTH, HEIGHT));
    trace_read(expected, 0, &ours);
    if (good && !read)
        blame(judgement, NOT_BY_POVRAY, error.message);
    else if (good)
        same_picture(text, &scene->camera, &ours, &theirs, judgement);
    if (read)
        frame_free(&theirs);
    frame_free(&ours);
}

/* Compares the scene with the picture of the run, which has been started. */
static struct judgement judge(const char *text, size_t number, struct povray *run)
{
    struct judgement judgement = { .number = number };
    c205_error error;
    struct frame theirs;
    SCOPED(scene) *scene = read_text(text, &judgement);
    if (scene)
        judge_scene(text, scene, run, &judgement);
    else if (povray_end(run, &theirs, &error))
        frame_free(&theirs);
    else
        strcat(judgement.message, " (nor does POV-Ray)");
    return judgement;
}

static struct judgement judge_again(const char *text, size_t number)
{
    return judge(text, number, begin_run(text, number, "_less"));
}

/* ---- Failures ------------------------------------------------------------ */

/* Returns true if a reduced text fails in the same way as the original. Messages of
 * POV-Ray are not compared, because they end with a position. */
static bool fails_as(const char *text, void *context)
{
    const struct judgement *first = context;
    struct judgement other = judge_again(text, first->number);
    return other.fault == first->fault && other.pixel == first->pixel
           && (other.fault != NOT_READ || strcmp(other.message, first->message) == 0);
}

static void show(const char *text, size_t number)
{
    struct judgement judgement = judge_again(text, number);
    char path[PATH];
    snprintf(path, sizeof path, "language_%zu.pov", number);
    printf("FAIL %s (seed %016llX, -W %d -H %d): %s\n%s", path,
           (unsigned long long)seed_of(number), WIDTH, HEIGHT, judgement.reason, text);
    fflush(stdout);
    keep_scene(path, text);
}

/* ---- The command --------------------------------------------------------- */

/* A queue of running POV-Ray processes in a ring buffer. */
static struct povray *runs[AHEAD + 1];
static size_t begun, ended;

static void begin_scene(size_t number)
{
    FREED char *text = language_scene_text(seed_of(number));
    runs[begun++ % (AHEAD + 1)] = begin_run(text, number, "");
}

static bool check_scene(size_t number, bool first)
{
    static size_t failed;
    FREED char *text = language_scene_text(seed_of(number));
    struct judgement judgement = judge(text, number, runs[ended++ % (AHEAD + 1)]);
    if (judgement.fault)
        printf("scene %zu: %s\n", number, judgement.reason);
    if (judgement.fault && !first && failed++ < MAX_SMALLER) {
        fflush(stdout);
        text = text_shrunk(text, MAX_TRIALS, fails_as, &judgement);
        show(text, number);
    }
    return judgement.fault == NO_FAULT;
}

/* Writes the image atomically, because several processes may run in this folder. */
static void keep_image(void)
{
    char path[PATH];
    snprintf(path, sizeof path, "%s.%ld", LANGUAGE_IMAGE, (long)getpid());
    keep_scene(path, language_image);
    if (rename(path, LANGUAGE_IMAGE) != 0)
        give_up("the image for the scenes cannot be kept");
}

int main(int count, char **words)
{
    if (system("command -v povray >/dev/null") != 0)
        give_up("povray is not installed");
    keep_image();
    return check_many(count, words, check_scene, begin_scene, AHEAD);
}
