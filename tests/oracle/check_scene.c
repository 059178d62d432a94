/* check_scene.c - compares the frames of scene files in all modes, and with other
 * tracers.
 *
 *     check_scene all|some SCENE.pov ..
 *
 * The frame of a scene must be equal bit for bit in all three modes, with queues of any
 * length, by tiles and by rows, with and without bounds and a hierarchy. It must also
 * equal the plain tracer's frame, and the plain tracer's frame must equal POV-Ray's
 * picture of the same file, within the tolerances of compare_pictures.h. The forms of
 * the method of 1984 for patches and cylinders must be equal to each other and to the
 * plain tracer's frame.
 *
 * "all" tests each scene in all configurations. "some" tests it in a third of them,
 * which the name of the scene selects. Each third contains all three modes. Frames are
 * small.
 *
 * Prints a line for each comparison with a tracer and for each failure, then the
 * counts. Exit status 1: a comparison failed; 2: wrong usage.
 */
#include "rt/picture/picture.h"
#include "rt/scene/language/scene_read.h"
#include "rt/shapes/shape_words.h"
#include "rt/trace/trace.h"
#include "tests/oracle/compare_pictures.h"
#include "tests/oracle/many_scenes.h"
#include "tests/oracle/plain_tracer.h"
#include "tests/oracle/run_povray.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Half a step of POV-Ray's 16-bit samples is 7.6e-6. POV-Ray also computes colours with
 * 24 bits, so a whole step is allowed. */
#define POVRAY_TOLERANCE (1. / 65535)

static const struct comparison with_povray = {
    "colour", CHANNEL_RED, 3, 1, false, POVRAY_TOLERANCE, DECIDED_BY_ROUNDING
};
/* POV-Ray traces hundreds of random rays for a pixel with a lens, this tracer few. */
static const struct comparison roughly = {
    "colour", CHANNEL_RED, 3, 1, false, .05, .002
};

/* ---- Exceptions ---------------------------------------------------------- */

enum {
    NO_POVRAY = 1,
    ROUGH_POVRAY = 2,
    NO_HISTORICAL = 4, /* the frame of the historical method is not compared with the
                        * plain tracer's */
    FEWER_PIXELS = 8,  /* the scene has thousands of triangles, or many rays per
                        * pixel */
    ALL_PIXELS = 16,   /* POV-Ray may differ at a few pixels in frames of any size */
};
static const struct exception {
    const char *scene;
    unsigned what;
} exceptions[] = {
    /* POV-Ray shows meshes instead of Steiner patches. */
    { "scenes/car.pov", NO_POVRAY },
    { "scenes/steiner.pov", NO_POVRAY },
    /* POV-Ray's picture has only one colour if an orthographic camera has a lens. */
    { "tests/scenes/lens_orthographic.pov", NO_POVRAY },
    { "tests/scenes/lens.pov", ROUGH_POVRAY },
    /* POV-Ray loses one of two coincident faces if a body is transparent. */
    { "tests/scenes/coincident.pov", NO_POVRAY },
    { "tests/scenes/csg_coincident.pov", NO_POVRAY },
    { "tests/scenes/standing.pov", NO_POVRAY },
    { "tests/scenes/touching.pov", NO_POVRAY },
    /* POV-Ray stores characters in 32 bits. At the edges of a mesh rounding decides its
     * hits. It interpolates the normals of a height_field over the cells. */
    { "tests/scenes/text.pov", NO_POVRAY },
    { "tests/scenes/mesh_closed.pov", NO_POVRAY },
    { "scenes/terrain.pov", NO_POVRAY | FEWER_PIXELS },
    /* These scenes use random rays through a lens. POV-Ray does not hit a blob at
     * distances below .01, where a reflected ray may start. */
    { "scenes/stage.pov", NO_POVRAY | FEWER_PIXELS },
    { "scenes/mist.pov", NO_POVRAY | FEWER_PIXELS },
    { "scenes/marbles.pov", NO_POVRAY | FEWER_PIXELS },
    { "scenes/drops.pov", NO_POVRAY | FEWER_PIXELS },
    { "scenes/shell.pov", FEWER_PIXELS },
    { "scenes/sails.pov", FEWER_PIXELS },
    { "scenes/vase.pov", FEWER_PIXELS },
    { "tests/scenes/areas.pov", ALL_PIXELS },
    { "tests/scenes/in_glass.pov", ALL_PIXELS },
    /* A cylinder's face is in a box's. */
    { "scenes/bearing.pov", NO_HISTORICAL },
};

static unsigned exceptions_of(const char *scene)
{
    for (size_t i = 0; i < sizeof exceptions / sizeof exceptions[0]; i++)
        if (strcmp(exceptions[i].scene, scene) == 0)
            return exceptions[i].what;
    return 0;
}

/* ---- One scene file ------------------------------------------------------ */

static size_t passed, failed;

static void verdict(bool good, const char *path, const char *what)
{
    good ? passed++ : failed++;
    if (!good)
        printf("FAILED %s: %s\n", path, what);
}

struct file {
    const char *path;
    unsigned exceptions;
    unsigned turn;   /* 0 to 2, or ALL_TURNS */
    bool historical; /* the program of 1984 has a kernel for a shape of the scene */
    bool lens;
    size_t width, height; /* size for which the scene was last read */
    struct scene *scene;
};
enum { TURNS = 3, ALL_TURNS = TURNS };

/* Returns the side of a frame with a third of the pixels, or all if THOROUGH. */
static size_t length_of(size_t length)
{
    return getenv("THOROUGH") ? length : length * 60 / 100;
}

static bool contains(const char *path, const char *word)
{
    char line[4096];
    bool found = false;
    FILE *file = fopen(path, "r");
    while (file && !found && fgets(line, sizeof line, file))
        found = strstr(line, word) != NULL;
    if (file)
        fclose(file);
    return found;
}

/* Returns true if POV-Ray has all shapes of a scene, or the scene tests for the others
 * by #ifdef. */
static bool povray_has_shapes(const char *path)
{
    for (int kind = 0; kind < PRIMITIVE_KINDS; kind++) {
        const char *name = primitive_kind_name((enum primitive_kind)kind);
        char shape[80], test[80];
        snprintf(shape, sizeof shape, "%s {", name);
        snprintf(test, sizeof test, "(%s)", name);
        if (!shapes[kind]->povray && contains(path, shape) && !contains(path, test))
            return false;
    }
    return true;
}

/* Returns true if the program of 1984 has a kernel for a shape of the scene. */
static bool has_historical_shape(const struct scene *scene)
{
    struct shape_words words;
    for (size_t i = 0; i < scene->primitive_count; i++)
        if (shape_words_historical(&scene->primitives[i], &words))
            return true;
    return false;
}

/* Reads the scene for a picture size. The default camera depends on the size. */
static const struct scene *scene_at(struct file *file, size_t width, size_t height)
{
    const struct scene_options options = { .width = (int)width,
                                           .height = (int)height,
                                           .read_raster = picture_read_raster };
    struct diagnostics reports = { 0 };
    if (file->scene && file->width == width && file->height == height)
        return file->scene;
    scene_free(file->scene);
    file->scene = scene_read(file->path, &options, &reports);
    if (!file->scene)
        diagnostics_print(&reports, stderr);
    diagnostics_free(&reports);
    file->width = width;
    file->height = height;
    return file->scene;
}

/* --- equal frames --------------------------------------------------------- */

static bool has_turn(const struct file *file, unsigned turn)
{
    return file->turn == ALL_TURNS || file->turn == turn;
}

struct way {
    unsigned turn;
    struct trace_options options;
};

/* Forms whose frames must equal the frame of the scalar form. */
static const struct way ways[] = {
    { 1, { .mode = TRACE_VECTOR, .queue = 77 } },
    { 2, { .mode = TRACE_VECTOR } },
    { 2, { .mode = TRACE_VECTOR, .queue = 65535 } },
    { 0, { .mode = TRACE_KERNELS, .queue = 333 } },
    { 0, { .mode = TRACE_VECTOR, .order = ORDER_ROWS, .queue = 77 } },
    { 2, { .mode = TRACE_KERNELS, .order = ORDER_TILES, .queue = 50 } },
    { 0, { .mode = TRACE_VECTOR, .visible = VISIBLE_EVERY } },
    { 0, { .mode = TRACE_SCALAR, .no_bounds = true } },
    { 2, { .mode = TRACE_VECTOR, .no_bounds = true } },
    { 1, { .mode = TRACE_VECTOR, .flat = true } },
};
enum { WAYS = sizeof ways / sizeof *ways };

/* Options with which the three modes must give the same frame. The frames are smaller,
 * because a queue of one ray is slow, and samples need many rays. */
static const struct way stages[] = {
    { 0, { .width = 18, .height = 14, .queue = 1 } },
    { 1, { .width = 20, .height = 15, .samples = 2 } },
    { 2, { .width = 34, .height = 5, .samples = 2, .threshold = .2 } },
};

static struct trace_options in_mode(struct trace_options options, enum trace_mode mode)
{
    options.mode = mode;
    if (options.queue == 0)
        options.queue = TRACE_QUEUE;
    return options;
}

/* Traces a scene in the scalar form and with other options, and compares the frames.
 * All have the size of the scalar frame. */
static void check_ways(struct file *file, struct trace_options scalar,
                       const struct way *others, size_t count)
{
    const struct scene *scene = scene_at(file, scalar.width, scalar.height);
    SCOPED(trace) *expected = traced_in(scene, in_mode(scalar, TRACE_SCALAR));
    char reason[MANY_REASON];
    for (size_t i = 0; i < count; i++) {
        struct trace_options options = sized(in_mode(others[i].options,
                                                     others[i].options.mode),
                                             scalar.width, scalar.height);
        if (has_turn(file, others[i].turn))
            verdict(same_in_form(scene, expected, options, reason), file->path, reason);
    }
}

static void check_modes(struct file *file, unsigned turn, struct trace_options options)
{
    const struct way others[] = { { turn, in_mode(options, TRACE_VECTOR) },
                                  { turn, in_mode(options, TRACE_KERNELS) } };
    if (has_turn(file, turn))
        check_ways(file, options, others, options.historical ? 1 : 2);
}

/* ---- Comparison with the plain tracer and POV-Ray ------------------------ */

static bool report(const char *who, const struct comparison *comparison,
                   const struct frame *expected, const struct frame *found,
                   const bool *inner)
{
    struct picture_difference is = compare_pictures(comparison, expected, found, inner);
    bool good = within(comparison, &is);
    printf("%-6s %-6s mean %8.2e  greatest %8.2e at %zu, %zu  "
           "beyond %.2e: %zu of %zu  %s\n",
           who, comparison->name, is.mean, is.greatest, is.worst_x, is.worst_y,
           comparison->tolerance, is.beyond, is.compared, good ? "ok" : "FAILED");
    return good;
}

/* Traces the scene on the machine, and compares the frame with the frame of the plain
 * tracer. The caller frees the frame. */
static bool same_as_plain(struct file *file, const struct frame *plain,
                          const bool *inner, bool historical, struct frame *frame)
{
    const struct trace_options options = { .historical = historical,
                                           .width = plain->width,
                                           .height = plain->height };
    const struct scene *scene = scene_at(file, plain->width, plain->height);
    SCOPED(trace) *trace = traced_in(scene, in_mode(options, TRACE_VECTOR));
    bool good = frame_allocate(frame, plain->width, plain->height);
    need(good);
    trace_read(trace, 0, frame);
    for (size_t i = 0; i < WITH_FRAME; i++)
        good &= report(historical ? "1984" : "rt205", &with_frame[i], plain, frame,
                       inner);
    return good;
}

/* Compares POV-Ray's picture with the frames of the plain tracer and of the machine. */
static bool same_as_povray(const struct file *file, const struct frame *plain,
                           const struct frame *frame, const bool *inner)
{
    const struct comparison *comparison = file->exceptions & ROUGH_POVRAY
                                              ? &roughly
                                              : &with_povray;
    c205_error error;
    struct frame povray;
    if (!run_povray(file->path, plain->width, plain->height, NULL, &povray, &error)) {
        fprintf(stderr, "%s\n", error.message);
        return false;
    }
    bool good = report("povray", comparison, plain, &povray, inner)
                & report("both", comparison, &povray, frame, inner);
    frame_free(&povray);
    return good;
}

static bool has_historical(const struct file *file)
{
    return file->historical && !(file->exceptions & NO_HISTORICAL);
}

static bool compare(struct file *file, const struct frame *plain, const bool *inner)
{
    struct frame frame = { 0 }, historical = { 0 };
    bool good = same_as_plain(file, plain, inner, false, &frame);
    if (good && !(file->exceptions & NO_POVRAY))
        good = same_as_povray(file, plain, &frame, inner);
    if (has_historical(file))
        good &= same_as_plain(file, plain, inner, true, &historical);
    frame_free(&frame);
    frame_free(&historical);
    return good;
}

static void check_others(struct file *file)
{
    bool fewer = file->exceptions & FEWER_PIXELS, all = file->exceptions & ALL_PIXELS;
    size_t width = fewer ? 60 : 120, height = fewer ? 45 : 90;
    if (!all) {
        width = length_of(width);
        height = length_of(height);
    }
    const struct scene *scene = scene_at(file, width, height);
    SCOPED_VALUE(frame) plain = { 0 };
    if (!scene || !plain_trace(scene, width, height, &plain))
        give_up("the scene has no plain frame");
    FREED bool *inner = inner_pixels(&plain);
    verdict(compare(file, &plain, inner), file->path, "not what the other tracers see");
}

/* ---- The command --------------------------------------------------------- */

static unsigned turn_of(const char *path)
{
    unsigned sum = 0;
    for (; *path; path++)
        sum = sum * 31 + (unsigned char)*path;
    return sum % TURNS;
}

/* Checks a file. Example scenes have many parts, so their frames have fewer pixels. */
static void check_file(const char *path, bool all)
{
    bool large = strncmp(path, "scenes/", 7) == 0;
    struct file file = { .path = path,
                         .exceptions = exceptions_of(path),
                         .turn = all ? ALL_TURNS : turn_of(path),
                         .lens = contains(path, "aperture") };
    size_t width = length_of(large ? 36 : 50), height = length_of(large ? 27 : 38);
    if (!povray_has_shapes(path))
        file.exceptions |= NO_POVRAY;
    printf("%s\n", path);
    const struct trace_options scalar = { .width = width, .height = height };
    if (!scene_at(&file, width, height)) {
        verdict(false, path, "the scene cannot be read");
        return;
    }
    file.historical = has_historical_shape(file.scene);
    check_ways(&file, scalar, ways, WAYS);
    if (has_historical(&file))
        check_modes(&file, file.turn,
                    (struct trace_options){
                        .historical = true, .width = width, .height = height });
    for (size_t i = 0; i < sizeof stages / sizeof *stages; i++)
        if (!(stages[i].options.threshold > 0 && file.lens))
            check_modes(&file, stages[i].turn, stages[i].options);
    check_others(&file);
    scene_free(file.scene);
}

int main(int count, char **words)
{
    bool all = count > 1 && strcmp(words[1], "all") == 0;
    if (count < 3 || (!all && strcmp(words[1], "some") != 0)) {
        fprintf(stderr, "usage: check_scene all|some SCENE.pov ..\n");
        return 2;
    }
    check_model = usual_model();
    for (int i = 2; i < count; i++)
        check_file(words[i], all);
    c205_model_free(check_model);
    printf("%zu passed, %zu failed\n", passed, failed);
    return failed > 0;
}
