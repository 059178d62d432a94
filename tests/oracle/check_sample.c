/* check_sample.c - compares the picture of a third-party scene with POV-Ray's.
 *
 *     check_sample SCENE.pov WIDTH HEIGHT [SAMPLES THRESHOLD]
 *
 * Prints one line, with fields separated by tabs:
 *
 *     refused REASON          the first error
 *     untraced REASON
 *     read REPORTS SECONDS - -
 *     read 0 SECONDS BEYOND PIXELS
 *
 * SECONDS is the processor time of the trace, in vector form.  If there are no reports,
 * the picture is compared with POV-Ray's picture of the same file. BEYOND is the number
 * of pixels with a channel that differs by more than .02. PIXELS is the number of all
 * pixels. Exit status 1: POV-Ray made no picture; 2: wrong usage.
 *
 * With a threshold both tracers trace more rays for pixels that differ from their
 * neighbours.
 */
#include "rt/picture/picture.h"
#include "rt/scene/language/scene_read.h"
#include "rt/trace/trace.h"
#include "tests/oracle/compare_pictures.h"
#include "tests/oracle/give_up.h"
#include "tests/oracle/run_povray.h"
#include "tests/oracle/solid_text.h"
#include "tests/timed_program.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* POV-Ray and rt205 sample a pixel at different points. Users see no difference up to
 * this tolerance. */
static const struct comparison with_povray = { "colour", CHANNEL_RED, 3, 1,
                                               false,    .02,         1 };

static const char *first_error(const struct diagnostics *reports)
{
    for (size_t i = 0; i < reports->count; i++)
        if (reports->items[i].severity == SEVERITY_ERROR)
            return reports->items[i].message;
    return "it cannot be read";
}

static size_t count_reports(const struct diagnostics *reports)
{
    size_t count = 0;
    for (size_t i = 0; i < reports->count; i++)
        count += reports->items[i].severity == SEVERITY_REPORT;
    return count;
}

/* Replaces negative colours by 0, as in a picture file. */
static void cut(struct frame *frame)
{
    for (int i = CHANNEL_RED; i <= CHANNEL_BLUE; i++)
        for (size_t j = 0; j < frame->width * frame->height; j++)
            frame->channel[i][j] = fmax(0, frame->channel[i][j]);
}

static bool compare(const char *path, const struct trace_options *options,
                    const struct frame *frame)
{
    const struct antialiasing how = { options->samples, options->threshold };
    size_t pixels = frame->width * frame->height;
    FREED bool *all = test_room(pixels);
    c205_error error;
    struct frame theirs;
    bool good = run_povray(path, frame->width, frame->height,
                           options->threshold > 0 ? &how : NULL, &theirs, &error);
    if (good) {
        memset(all, true, pixels);
        struct picture_difference difference = compare_pictures(&with_povray, &theirs,
                                                                frame, all);
        printf("\t%zu\t%zu\n", difference.beyond, difference.compared);
        frame_free(&theirs);
    } else {
        printf("\t-\t-\n");
        fprintf(stderr, "%s: %s\n", path, error.message);
    }
    return good;
}

static bool print_scene(const char *path, const struct scene *scene,
                        const struct trace_options *options, size_t reports)
{
    c205_error error = { "out of memory" };
    struct frame frame;
    bool good = true;
    SCOPED(trace) *trace = trace_new(scene, options, &error);
    double begin = processor_seconds();
    if (!trace || !trace_run(trace, &error)) {
        printf("untraced\t%s\n", error.message);
    } else {
        printf("read\t%zu\t%.3f%s", reports, processor_seconds() - begin,
               reports ? "\t-\t-\n" : "");
        if (!reports && !frame_allocate(&frame, options->width, options->height))
            give_up("out of memory");
        if (!reports) {
            trace_read(trace, 0, &frame);
            cut(&frame);
            good = compare(path, options, &frame);
            frame_free(&frame);
        }
    }
    return good;
}

static bool print_case(const char *path, const struct trace_options *options)
{
    const struct scene_options reading = { .width = (int)options->width,
                                           .height = (int)options->height,
                                           .read_raster = picture_read_raster };
    SCOPED_VALUE(diagnostics) reports = { 0 };
    SCOPED(scene) *scene = scene_read(path, &reading, &reports);
    bool good = true;
    if (scene)
        good = print_scene(path, scene, options, count_reports(&reports));
    else
        printf("refused\t%s\n", first_error(&reports));
    return good;
}

int main(int count, char **words)
{
    struct trace_options options = { .mode = TRACE_VECTOR,
                                     .queue = TRACE_QUEUE,
                                     .jobs = 1 };
    c205_error error;
    c205_model *model;
    if (count != 4 && count != 6) {
        fputs("usage: check_sample SCENE.pov WIDTH HEIGHT [SAMPLES THRESHOLD]\n",
              stderr);
        return 2;
    }
    options.width = strtoul(words[2], NULL, 10);
    options.height = strtoul(words[3], NULL, 10);
    if (count == 6) {
        options.samples = strtoul(words[4], NULL, 10);
        options.threshold = strtod(words[5], NULL);
    }
    options.model = model = c205_model_find("cyber205-2pipe", &error);
    bool good = model && print_case(words[1], &options);
    c205_model_free(model);
    return good ? 0 : 1;
}
