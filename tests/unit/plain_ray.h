/* plain_ray.h - traces one ray through a scene with the plain tracer. */
#ifndef TESTS_PLAIN_RAY_H
#define TESTS_PLAIN_RAY_H

#include "tests/oracle/plain_shapes.h"
#include "tests/oracle/plain_tracer.h"
#include "tests/unit/scene_reading.h"

/* The origin and direction of a ray. */
struct look {
    double from[3], along[3];
};

/* Traces the ray in the scene `head` `text`. Sets `values` to the pixel's channels. */
static inline void trace_ray(const struct look *look, const char *head,
                             const char *text, double values[FRAME_CHANNELS])
{
    SCOPED_VALUE(frame) frame;
    SCOPED(scene) *scene = read_format("%s%s", head, text);
    scene->camera = (struct camera){ .location = { 0 } };
    copy(scene->camera.location, look->from);
    copy(scene->camera.direction, look->along);
    assert_true(plain_trace(scene, 1, 1, &frame));
    for (int i = 0; i < FRAME_CHANNELS; i++)
        values[i] = frame.channel[i][0];
}

#endif
