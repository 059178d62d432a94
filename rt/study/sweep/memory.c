/* memory.c - computes the memory that a queue needs. */
#include <stdlib.h>
#include <string.h>

#include "rt/layout/trees.h"
#include "rt/study/sweep/sweep_types.h"

enum { SMALLEST_PAGE = 512, SIDE = 32 };

/* Computes the number of words that a frame of one queue accesses. The frame has side x
 * side rays. */
static bool touched(struct sweep *sweep, size_t side, double *words, c205_error *error)
{
    struct sweep_point point = sweep->base;
    uint64_t count;
    point.trace.width = point.trace.height = side;
    point.trace.queue = side * side;
    if (!sweep_touched(sweep, &point, SMALLEST_PAGE, &count, error))
        return false;
    *words = (double)count;
    return true;
}

/* Computes the number of crossings for which rt/layout/layout.c reserves room for each
 * ray: the largest number of crossings of a ray with one region. */
static bool count_crossings(const struct scene *scene, size_t *crossings,
                            c205_error *error)
{
    struct leaf_plan *plans = calloc(scene->primitive_count + 1, sizeof *plans);
    strcpy(error->message, "out of memory");
    if (plans)
        *crossings = plan_leaves(scene, plans);
    free(plans);
    return plans != NULL;
}

/* Computes the memory for a ray from two frames of the same picture, one with four
 * times as many rays. The difference is the memory of the additional rays. */
bool sweep_memory(struct sweep *sweep, struct sweep_memory *memory, c205_error *error)
{
    double rays = SIDE * SIDE;
    double few, many;
    memset(memory, 0, sizeof *memory);
    if (!touched(sweep, SIDE, &few, error) || !touched(sweep, 2 * SIDE, &many, error)
        || (sweep->scene != NULL
            && !count_crossings(sweep->scene, &memory->crossings, error)))
        return false;
    memory->a_ray = (many - few) / (3 * rays);
    memory->fixed = few - rays * memory->a_ray;
    memory->real = c205_model_lookup(sweep->base.trace.model, "memory.real_words")
                       ->value;
    memory->fills = (memory->real - memory->fixed) / memory->a_ray;
    return true;
}
