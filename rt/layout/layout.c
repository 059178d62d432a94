/* layout.c - writes a scene as records in the machine's memory. */
#include "rt/layout/layout.h"

#include <stdlib.h>

#include "rt/layout/find_viewpoints.h"
#include "rt/layout/images.h"
#include "rt/layout/interiors.h"
#include "rt/layout/lens.h"
#include "rt/layout/lights.h"
#include "rt/layout/program.h"
#include "rt/layout/record.h"
#include "rt/layout/solids.h"
#include "rt/layout/surface.h"
#include "rt/layout/environment.h"
#include "rt/layout/trees.h"
#include "rt/picture/picture.h"

/* Returns the largest number of rays in a chain. It is 1 in a scene without mirrors and
 * glass. */
static size_t count_levels(const struct scene *scene)
{
    if (scene_has_interiors(scene))
        return (size_t)scene->max_trace_level + MAX_STRAIGHT;
    for (size_t i = 0; i < scene->primitive_count; i++)
        if (surface_is_mirror(&scene->primitives[i].finish))
            return (size_t)scene->max_trace_level;
    return 1;
}

static void layout_levels(struct record_layout *layout, const struct scene *scene)
{
    size_t levels = count_levels(scene);
    layout_word(layout, "scene_levels",
                layout_reserve(layout,
                               levels * (size_t)layout_symbol(layout, "LEVEL_SIZE")));
    layout_word(layout, "scene_level_count", c205_from_integer((int64_t)levels));
    layout_word(layout, "scene_bailout", c205_from_double(scene->adc_bailout));
}

static void layout_camera(struct record_layout *layout, const struct scene *scene)
{
    const struct camera *camera = &scene->camera;
    c205_word words[12];
    put_numbers(words, camera->location, 3);
    put_numbers(words + 3, camera->direction, 3);
    put_numbers(words + 6, camera->right, 3);
    put_numbers(words + 9, camera->up, 3);
    layout_words(layout, layout_symbol(layout, "scene_camera"), words, 12);
    put_numbers(words, scene->background, 3);
    layout_words(layout, layout_symbol(layout, "scene_background"), words, 3);
}

/* Writes the settings for pixels whose samples are averaged in linear light, and the
 * settings for the camera's lens. */
static void layout_samples(struct record_layout *layout, double gamma,
                           const struct camera *camera, struct frame_layout *frame)
{
    if (gamma > 0)
        layout_word(layout, "scene_gamma", c205_from_double(gamma));
    if (camera->lens_radius > 0)
        layout_lens(layout, camera, frame->samples);
}

/* The camera rays of a program form a grid of rows and columns. */
struct ray_grid {
    size_t columns, first_row, rows;
};

static size_t count_rays(const struct ray_grid *grid)
{
    return grid->columns * grid->rows;
}

/* Returns the grid of camera rays without adaptive sampling: samples x samples rays for
 * each pixel. */
static struct ray_grid all_samples(const struct frame_layout *frame, size_t samples)
{
    return (struct ray_grid){ frame->width * samples, frame->first_row * samples,
                              frame->rows * samples };
}

/* Returns the grid of the first camera rays of adaptive sampling: one ray for each
 * pixel of the band, and for the neighbours on its left and above, with which pixels
 * are compared. */
static struct ray_grid first_rays(const struct frame_layout *frame)
{
    return (struct ray_grid){ frame->width + 1, frame->first_row, frame->rows + 1 };
}

/* The gamma at which colours are compared (POV-Ray's Antialias_Gamma). */
#define COMPARED_GAMMA 2.5

/* Reserves the memory of adaptive.s: its planes, and the samples of a batch. */
static void layout_adaptive(struct record_layout *layout, double gamma,
                            const struct frame_layout *frame,
                            const struct ray_grid *grid)
{
    size_t samples = frame->samples * frame->samples;
    size_t rays = count_rays(grid);
    size_t pixels = rays > samples ? rays / samples : 1;
    size_t strings = (size_t)layout_symbol(layout, "FINE_STRINGS")
                     * (frame->width / 64 + 4);
    layout_word(layout, "scene_threshold", c205_from_double(frame->threshold));
    if (gamma > 0)
        layout_word(layout, "scene_power", c205_from_double(gamma / COMPARED_GAMMA));
    layout_word(layout, "scene_wide", c205_from_double((double)grid->columns));
    layout_word(layout, "scene_fine",
                layout_reserve(layout,
                               (size_t)layout_symbol(layout, "FINE_PLANES") * rays
                                   + strings));
    layout_word(layout, "scene_sampled_pixels", c205_from_integer((int64_t)pixels));
    layout_word(layout, "scene_sampled",
                layout_reserve(layout, FRAME_CHANNELS * samples * pixels));
}

static void layout_band(struct record_layout *layout, const struct ray_grid *grid)
{
    const double rows[2] = { (double)grid->first_row,
                             (double)(grid->first_row + grid->rows) };
    c205_word words[2];
    put_numbers(words, rows, 2);
    layout_words(layout, layout_symbol(layout, "scene_band"), words, 2);
    layout_word(layout, "scene_first_pixel",
                c205_from_integer((int64_t)(grid->first_row * grid->columns)));
    layout_word(layout, "scene_pixels", c205_from_integer((int64_t)count_rays(grid)));
}

static void layout_frame(struct record_layout *layout, double gamma,
                         const struct camera *camera, struct frame_layout *frame)
{
    size_t samples = frame->samples > 0 ? frame->samples : 1;
    bool adaptive = frame->threshold > 0;
    struct ray_grid grid = adaptive ? first_rays(frame) : all_samples(frame, samples);
    layout_word(layout, "scene_width",
                c205_from_double((double)(frame->width * samples)));
    layout_word(layout, "scene_height",
                c205_from_double((double)(frame->height * samples)));
    layout_band(layout, &grid);
    if (frame->tiles)
        layout_word(layout, "scene_tiles", 1);
    frame->address = layout_reserve(layout, count_rays(&grid) * FRAME_CHANNELS);
    layout_word(layout, "scene_frame", frame->address);
    if (samples == 1)
        return;
    layout_word(layout, "scene_samples", c205_from_integer((int64_t)frame->samples));
    frame->address = layout_reserve(layout,
                                    frame->width * frame->rows * FRAME_CHANNELS);
    layout_word(layout, "scene_picture", frame->address);
    if (adaptive)
        layout_adaptive(layout, gamma, frame, &grid);
    else
        layout_samples(layout, gamma, camera, frame);
}

struct scene_layout {
    const struct object *program;
    struct image image;
    uint64_t end; /* the next unused address */
    double gamma; /* gamma of the scene's colours; 0: not specified */
    struct camera camera;
};

static void layout_things(struct record_layout *layout, const struct scene *scene,
                          enum bounding bounding)
{
    uint64_t *images = images_layout(layout, scene);
    struct interiors interiors;
    struct viewpoints viewpoints;
    if (!images)
        return;
    viewpoints_find(scene, &viewpoints);
    layout_sky(layout, scene, images);
    if (interiors_find(scene, &interiors)) {
        layout_solids(layout, scene, &interiors, images, &viewpoints, bounding);
        interiors_layout(layout, &interiors, scene);
    } else {
        layout_fail(layout, "out of memory");
    }
    interiors_free(&interiors);
    free(images);
}

struct scene_layout *layout_new(const struct object *program, const struct scene *scene,
                                enum bounding bounding, bool (*go_on)(void *context),
                                void *context, c205_error *error)
{
    struct scene_layout *whole = calloc(1, sizeof *whole);
    struct record_layout layout = { .program = program,
                                    .error = error,
                                    .free = program_end(program),
                                    .go_on = go_on,
                                    .context = context };
    if (!whole) {
        layout_fail(&layout, "out of memory");
        return NULL;
    }
    layout.image = &whole->image;
    layout_camera(&layout, scene);
    layout_things(&layout, scene, bounding);
    layout_levels(&layout, scene);
    layout_lights(&layout, scene);
    layout_fogs(&layout, scene);
    whole->program = program;
    whole->end = layout.free;
    whole->gamma = scene->assumed_gamma;
    whole->camera = scene->camera;
    image_share(&whole->image);
    if (!layout.failed)
        return whole;
    layout_free(whole);
    return NULL;
}

void layout_free(struct scene_layout *layout)
{
    if (!layout)
        return;
    image_free(&layout->image);
    free(layout);
}

bool layout_put(const struct scene_layout *whole, c205 *machine,
                struct frame_layout *frame, c205_error *error)
{
    struct image image = { 0 };
    struct record_layout layout = {
        .image = &image, .program = whole->program, .error = error, .free = whole->end
    };
    bool good;
    layout_frame(&layout, whole->gamma, &whole->camera, frame);
    good = !layout.failed && image_load(&whole->image, machine, error)
           && image_load(&image, machine, error);
    image_free(&image);
    return good;
}
