/* check_scene.c - a frame of rt205 against two other tracers.
 *
 *     check_scene SCENE.pov WIDTH HEIGHT FRAME.exr [--povray | --roughly]
 *                 [HISTORICAL.exr]
 *
 * FRAME.exr is what rt205 rendered of the scene, with 32-bit samples.  It is
 * compared with the plain tracer's frame, channel by channel; with --povray
 * POV-Ray's picture of the same file is compared with that of the plain
 * tracer, and with the frame ("both"); --roughly allows for rays that POV-Ray
 * sends at random, through a lens.  A FRAME.exr of "-" leaves the frame
 * out; HISTORICAL.exr, the way of 1984, is compared with the plain tracer's, too.
 * Prints one line per comparison.  Exit code 1: one failed; 2: wrong
 * usage.
 */
#include "rt/picture/picture.h"
#include "rt/scene/language/scene_read.h"
#include "tests/oracle/compare_pictures.h"
#include "tests/oracle/plain_tracer.h"
#include "tests/oracle/run_povray.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Half a step of POV-Ray's 16-bit samples is 7.6e-6; it computes colours in 24
 * bits besides, so a whole step. */
#define POVRAY_TOLERANCE (1. / 65535)

static const struct comparison with_povray = {
    "colour", CHANNEL_RED, 3, 1, false, POVRAY_TOLERANCE, DECIDED_BY_ROUNDING
};
/* .. hundreds of them, beside a few of ours. */
static const struct comparison roughly = { "colour", CHANNEL_RED, 3,   1,
                                           false,    .05,         .002 };

struct request {
    const char *scene;
    const char *frame, *historical; /* NULL: leave that out */
    size_t width, height;
    const struct comparison *povray; /* or NULL */
};

/* --- comparisons -------------------------------------------------------- */

static bool report(const char *who, const struct comparison *comparison,
                   const struct frame *expected, const struct frame *found,
                   const bool *inner)
{
    struct picture_difference is = compare_pictures(comparison, expected,
                                                    found, inner);
    bool good = within(comparison, &is);
    printf("%-6s %-6s mean %8.2e  greatest %8.2e at %zu, %zu  "
           "beyond %.2e: %zu of %zu  %s\n",
           who, comparison->name, is.mean, is.greatest, is.worst_x,
           is.worst_y, comparison->tolerance, is.beyond, is.compared,
           good ? "ok" : "FAILED");
    return good;
}

static bool same_size(const char *who, const struct frame *expected,
                      const struct frame *found)
{
    if (expected->width == found->width && expected->height == found->height)
        return true;
    fprintf(stderr, "%s: the picture is %zu x %zu\n", who, found->width,
            found->height);
    return false;
}

static bool check_frame(const char *who, const struct frame *expected,
                        const char *path, const bool *inner)
{
    struct picture_error error;
    struct frame found;
    if (!picture_read(path, &found, &error)) {
        fprintf(stderr, "%s\n", error.message);
        return false;
    }
    bool good = same_size(who, expected, &found);
    for (size_t i = 0, sized = good; sized && i < WITH_FRAME; i++)
        good &= report(who, &with_frame[i], expected, &found, inner);
    frame_free(&found);
    return good;
}

static bool check_directly(const struct frame *povray,
                           const struct request *request, const bool *inner)
{
    struct picture_error error;
    struct frame frame;
    if (!picture_read(request->frame, &frame, &error)) {
        fprintf(stderr, "%s\n", error.message);
        return false;
    }
    bool good = same_size("both", povray, &frame)
                && report("both", request->povray, povray, &frame, inner);
    frame_free(&frame);
    return good;
}

/* POV-Ray's picture, against the plain tracer's and against rt205's own if
 * there is one. */
static bool check_povray(const struct frame *expected,
                         const struct request *request, const bool *inner)
{
    const char *path = request->scene;
    struct picture_error error;
    struct frame found;
    if (!run_povray(path, expected->width, expected->height, NULL, &found,
                    &error)) {
        fprintf(stderr, "%s\n", error.message);
        return false;
    }
    bool good = same_size("povray", expected, &found)
                && report("povray", request->povray, expected, &found, inner);
    if (good && request->frame)
        good = check_directly(&found, request, inner);
    frame_free(&found);
    return good;
}

/* --- the command -------------------------------------------------------- */

/* What may stand behind the frame, in any order. */
static bool parse_more(const char *word, struct request *request)
{
    bool is_way = word[0] == '-';
    if (is_way ? request->povray != NULL : request->historical != NULL)
        return false;
    if (!is_way)
        request->historical = word;
    else
        request->povray = strcmp(word, "--povray") == 0    ? &with_povray
                          : strcmp(word, "--roughly") == 0 ? &roughly
                                                           : NULL;
    return !is_way || request->povray;
}

static bool parse(int count, char **words, struct request *request)
{
    if (count < 5)
        return false;
    *request = (struct request){ .scene = words[1],
                                 .width = strtoul(words[2], NULL, 10),
                                 .height = strtoul(words[3], NULL, 10),
                                 .frame = strcmp(words[4], "-") ? words[4]
                                                                : NULL };
    for (int i = 5; i < count; i++)
        if (!parse_more(words[i], request))
            return false;
    return request->width && request->height;
}

static struct scene *read_scene(const struct request *request)
{
    const struct scene_options options = {
        .width = (int)request->width,
        .height = (int)request->height,
        .read_raster = picture_read_raster
    };
    struct diagnostics reports = { 0 };
    struct scene *scene = scene_read(request->scene, &options, &reports);
    diagnostics_print(&reports, stderr);
    diagnostics_free(&reports);
    return scene;
}

static bool compare(const struct request *request, const struct scene *scene)
{
    struct frame expected;
    if (!plain_trace(scene, request->width, request->height, &expected))
        return false;
    bool *inner = inner_pixels(&expected);
    bool good = inner != NULL;
    if (good && request->frame)
        good = check_frame("rt205", &expected, request->frame, inner);
    if (inner && request->historical)
        good &= check_frame("1984", &expected, request->historical, inner);
    if (inner && request->povray)
        good &= check_povray(&expected, request, inner);
    free(inner);
    frame_free(&expected);
    return good;
}

int main(int count, char **words)
{
    struct request request;
    if (!parse(count, words, &request)) {
        fprintf(stderr,
                "usage: check_scene SCENE.pov WIDTH HEIGHT "
                "FRAME.exr [--povray | --roughly] [HISTORICAL.exr]\n");
        return 2;
    }
    struct scene *scene = read_scene(&request);
    bool good = scene && compare(&request, scene);
    scene_free(scene);
    return good ? 0 : 1;
}
