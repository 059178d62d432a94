/* plain_ray.c - replaces the camera of a scene by a single ray and traces it. */
#include "plain_ray.h"

void trace_ray(const struct look *look, const char *head, const char *text,
               double values[FRAME_CHANNELS])
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
