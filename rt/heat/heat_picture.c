/* heat_picture.c - draws a scene coloured by heat flows or shape factors. */
#include "rt/heat/heat_picture.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "vm/error.h"
#include "rt/heat/color_scale.h"

static const struct shown {
    const char *name, *unit, *title;
} shown_values[HEAT_SHOWN] = {
    [SHOWN_FLOW] = { "flow", " W/m^2", "flow, W/m^2" },
    [SHOWN_FACTOR] = { "factor", "", "shape factor, no unit" },
};

const char *heat_shown_name(enum heat_shown shown)
{
    return shown < HEAT_SHOWN ? shown_values[shown].name : NULL;
}

const char *heat_shown_unit(enum heat_shown shown)
{
    return shown_values[shown].unit;
}

struct heat_drawing {
    const struct heat *heat;
    const struct heat_look *look;
    struct heat_drawn *drawn;
    double *values;     /* value of each surface; NaN: none */
    size_t from;        /* surface that emits the factors */
    struct scene scene; /* the scene in the new colours */
    struct light lamp;
    c205_error *error;
};

/* ---- Values ----------------------------------------------------------------- */

static bool find_from(struct heat_drawing *drawing)
{
    const struct surfaces *surfaces = &drawing->heat->surfaces;
    const char *name = drawing->look->from ? drawing->look->from : "";
    while (drawing->from < surfaces->count
           && strcmp(surfaces->list[drawing->from].name, name) != 0)
        drawing->from++;
    if (drawing->from < surfaces->count && surfaces->list[drawing->from].sent > 0)
        return true;
    error_set(drawing->error,
              "unknown surface '%s', or a surface that emits nothing; surfaces", name);
    for (size_t i = 0; i < surfaces->count; i++)
        if (surfaces->list[i].sent > 0)
            named_parts_add_name(drawing->error, i == 0 ? ": " : ", ",
                                 surfaces->list[i].name);
    return false;
}

static void put_factors(const struct heat_drawing *drawing)
{
    const struct surfaces *surfaces = &drawing->heat->surfaces;
    const struct surface *from = &surfaces->list[drawing->from];
    for (size_t i = 0; i < surfaces->count; i++)
        drawing->values[i] = surface_factor(from, i);
}

static void put_flows(const struct heat_drawing *drawing)
{
    const struct thermal *thermal = &drawing->heat->thermal;
    for (size_t i = 0; i < thermal->count; i++) {
        size_t surface = thermal->surface[i];
        drawing->values[surface] = thermal->exchange.flow[i]
                                   / drawing->heat->surfaces.list[surface].area.value;
    }
}

static bool find_range(const struct heat_drawing *drawing)
{
    struct heat_drawn *drawn = drawing->drawn;
    drawn->least = INFINITY;
    drawn->most = -INFINITY;
    for (size_t i = 0; i < drawing->heat->surfaces.count; i++) {
        drawn->least = fmin(drawn->least, drawing->values[i]);
        drawn->most = fmax(drawn->most, drawing->values[i]);
    }
    return drawn->least <= drawn->most
           || error_set(drawing->error, "no surface has a value to draw");
}

static bool find_values(struct heat_drawing *drawing)
{
    size_t count = drawing->heat->surfaces.count;
    drawing->values = calloc(count + 1, sizeof *drawing->values);
    if (!drawing->values)
        return error_set(drawing->error, "out of memory");
    for (size_t i = 0; i < count; i++)
        drawing->values[i] = NAN;
    if (drawing->look->shown == SHOWN_FLOW)
        put_flows(drawing);
    else if (find_from(drawing))
        put_factors(drawing);
    else
        return false;
    return find_range(drawing);
}

/* ---- Colours ---------------------------------------------------------------- */

static const double grey[3] = { .25, .25, .25 }, green[3] = { .1, .55, .1 };

/* Interpolates in a list of count colours. Share 0 is the first colour, share 1 the
 * last. */
static void mix(const double (*way)[3], size_t count, double share, double color[3])
{
    double at = fmin(fmax(share, 0), 1) * (double)(count - 1);
    size_t i = at < (double)(count - 2) ? (size_t)at : count - 2;
    for (int k = 0; k < 3; k++)
        color[k] = way[i][k] + (at - (double)i) * (way[i + 1][k] - way[i][k]);
}

/* Computes the colour for a share of the largest value: -1 is the largest gain, and 1
 * is the largest loss or the largest factor. */
static void color_at(const void *given, double share, double color[3])
{
    const struct heat_drawing *drawing = given;
    static const double flow[][3] = { { .02, .08, .6 },
                                      { .2, .45, .85 },
                                      { .9, .9, .9 },
                                      { .9, .35, .15 },
                                      { .55, .01, .02 } };
    static const double factor[][3] = {
        { .01, .02, .12 }, { .2, .02, .35 }, { .75, .12, .1 }, { .95, .75, .1 }
    };
    if (drawing->look->shown == SHOWN_FLOW)
        mix(flow, 5, (1 + share) / 2, color);
    else
        mix(factor, 4, share, color);
}

static void color_of(const struct heat_drawing *drawing, size_t surface,
                     double color[3])
{
    const struct heat_drawn *drawn = drawing->drawn;
    double value = drawing->values[surface];
    double most = value < 0 ? -drawn->least : drawn->most;
    double share = most > 0 ? value / most : 0; /* losses and gains are scaled
                                                 * separately */

    if (isnan(value))
        memcpy(color, grey, sizeof grey);
    else if (drawing->look->shown == SHOWN_FACTOR && surface == drawing->from
             && value == 0)
        memcpy(color, green, sizeof green);
    else
        color_at(drawing, share, color);
}

/* Gives a primitive one colour. Half of the colour is emitted, so that a face that is
 * nearly parallel to the lamp's rays is not dark. */
static void paint(struct primitive *primitive, const double color[3])
{
    primitive->pigment = (struct pigment){ .kind = PIGMENT_COLOR };
    primitive->bumps = (struct bumps){ .list = NULL };
    primitive->finish = (struct finish){ .emission = { .5, .5, .5 },
                                         .diffuse = .5,
                                         .phong_size = 40,
                                         .roughness = .05,
                                         .reflection_falloff = 1,
                                         .brilliance = 1 };
    primitive->ior = 1;
    memcpy(primitive->pigment.color[0], color, 3 * sizeof *color);
}

static bool paint_scene(struct heat_drawing *drawing)
{
    const struct scene *from = drawing->heat->scene;
    struct scene *scene = &drawing->scene;
    size_t size = (from->primitive_count + 1) * sizeof *from->primitives;
    *scene = *from;
    scene->primitives = malloc(size);
    if (!scene->primitives)
        return error_set(drawing->error, "out of memory");
    for (size_t i = 0; i < from->primitive_count; i++) {
        double color[3];
        scene->primitives[i] = from->primitives[i];
        color_of(drawing, drawing->heat->surfaces.surface_of[i], color);
        paint(&scene->primitives[i], color);
    }
    drawing->lamp = (struct light){ .color = { 1, 1, 1 }, .shadowless = true };
    memcpy(drawing->lamp.position, from->camera.location,
           sizeof drawing->lamp.position);
    scene->lights = &drawing->lamp;
    scene->light_count = 1;
    scene->sky = (struct pigment){ .kind = PIGMENT_COLOR,
                                   .color = { { .02, .02, .02 } } };
    scene->fog_count = scene->image_count = 0;
    scene->camera.lens_radius = 0;
    scene->gamma_off = false;
    return true;
}

/* ---- The frame -------------------------------------------------------------- */

static void put_values(const struct heat_drawing *drawing, const struct frame *frame)
{
    for (size_t i = 0; i < frame->width * frame->height; i++) {
        size_t id = (size_t)frame->channel[CHANNEL_ID][i];
        double value = id > 0
                           ? drawing->values[drawing->heat->surfaces.surface_of[id - 1]]
                           : 0;
        frame->value[i] = value;
    }
}

static bool write_frame(const struct heat_drawing *drawing, struct frame *frame)
{
    const struct heat_look *look = drawing->look;
    char range[80], clocks[32];
    const struct picture_note notes[] = {
        { "Software", "rt205 " C205_VERSION },
        { "rt205:values", range },
        { "rt205:model", c205_model_name(look->trace.model) },
        { "rt205:clocks", clocks },
        { NULL, NULL },
    };
    snprintf(range, sizeof range, "%s from %g to %g%s", heat_shown_name(look->shown),
             drawing->drawn->least, drawing->drawn->most, heat_shown_unit(look->shown));
    snprintf(clocks, sizeof clocks, "%llu", (unsigned long long)drawing->drawn->clocks);
    return picture_write(look->path, frame, notes, false, drawing->error);
}

static bool read_and_write(const struct heat_drawing *drawing,
                           const struct trace *trace)
{
    const struct trace_options *options = &drawing->look->trace;
    const struct color_scale scale = {
        .title = shown_values[drawing->look->shown].title,
        .least = drawing->drawn->least,
        .most = drawing->drawn->most,
        .color = color_at,
        .context = drawing,
    };
    size_t height = options->height + color_scale_rows(&scale, options->width);
    struct frame frame;
    double *value = calloc(options->width * height, sizeof *value);
    bool good = frame_allocate(&frame, options->width, height) && value;
    if (good) {
        frame.layer = heat_shown_name(drawing->look->shown);
        frame.value = value;
        frame.height = options->height;
        trace_read(trace, 0, &frame);
        put_values(drawing, &frame);
        frame.height = height;
        color_scale_draw(&scale, &frame, options->height);
        good = write_frame(drawing, &frame);
    } else {
        error_set(drawing->error, "out of memory");
    }
    frame_free(&frame);
    free(value);
    return good;
}

static bool trace_and_write(const struct heat_drawing *drawing)
{
    struct trace *trace = trace_new(&drawing->scene, &drawing->look->trace,
                                    drawing->error);
    bool good = trace && trace_run(trace, drawing->error);
    if (good)
        drawing->drawn->clocks = trace_accounts(trace)->clocks;
    good = good && read_and_write(drawing, trace);
    trace_free(trace);
    return good;
}

bool heat_draw(const struct heat *heat, const struct heat_look *look,
               struct heat_drawn *drawn, c205_error *error)
{
    struct heat_drawing drawing = {
        .heat = heat, .look = look, .drawn = drawn, .error = error
    };
    bool good = find_values(&drawing) && paint_scene(&drawing)
                && trace_and_write(&drawing);
    free(drawing.scene.primitives);
    free(drawing.values);
    return good;
}
