/* scoped.h - variables whose values are freed at the end of their block.
 *
 *     SCOPED(scene) *scene = read_scene(text);    by scene_free(scene)
 *     SCOPED_VALUE(frame) frame;                  by frame_free(&frame)
 *     FREED char *text = malloc(count);           by free(text)
 *     FREED_BY(client_leave) struct client c;     by client_leave(&c)
 *
 * Variables are freed in the reverse order of their declaration.
 */
#ifndef TESTS_SCOPED_H
#define TESTS_SCOPED_H

#include <stdlib.h>

#define SCOPED(name) FREED_BY(free_##name##_at) struct name
#define SCOPED_VALUE(name) FREED_BY(name##_free) struct name
/* Marks a parameter that a function must take and does not use. */
#define UNUSED __attribute__((unused))

#define FREED_BY(function) __attribute__((cleanup(function)))
#define FREED FREED_BY(free_at)

static inline void free_at(void *at)
{
    free(*(void **)at);
}

/* Allows SCOPED for a struct that a function NAME_free frees. */
#define SCOPED_BY_FREE(name) \
    struct name; \
    void name##_free(struct name *value); \
    static inline void free_##name##_at(struct name **at) \
    { \
        name##_free(*at); \
    } \
    struct name

SCOPED_BY_FREE(c205);
SCOPED_BY_FREE(c205_history);
SCOPED_BY_FREE(c205_model);
SCOPED_BY_FREE(c205_projection);
SCOPED_BY_FREE(debugger);
SCOPED_BY_FREE(emission);
SCOPED_BY_FREE(engine);
SCOPED_BY_FREE(factors);
SCOPED_BY_FREE(line_profile);
SCOPED_BY_FREE(ray_query);
SCOPED_BY_FREE(object);
SCOPED_BY_FREE(point_maker);
SCOPED_BY_FREE(register_owners);
SCOPED_BY_FREE(scene);
SCOPED_BY_FREE(table);
SCOPED_BY_FREE(trace);

#endif
