/* bodies.c - extracts some of the regions of a scene. */
#include "rt/mass/bodies.h"

#include <stdlib.h>

#include "rt/layout/bounds.h"

static struct named_part *part_of(const struct named_parts *parts,
                                  const struct scene *scene,
                                  const struct region *region)
{
    size_t object = scene->primitives[region->first_primitive].object;
    return &parts->list[parts->part_of[object]];
}

bool bodies_find_endless(const struct scene *scene, struct named_parts *parts)
{
    struct bound *bounds = calloc(scene->node_count + 1, sizeof *bounds);
    bool good = bounds && bound_nodes(scene, bounds);
    for (size_t i = 0; good && i < scene->region_count; i++) {
        const struct region *region = &scene->regions[i];
        if (bound_is_none(&bounds[region->first_node]))
            part_of(parts, scene, region)->endless = true;
    }
    free(bounds);
    return good;
}

/* Appends a region with its primitives and nodes. Adjusts their indices. */
static void copy_region(const struct scene *scene, const struct region *region,
                        struct scene *bodies)
{
    struct region *copy = &bodies->regions[bodies->region_count++];
    size_t primitive = bodies->primitive_count, node = bodies->node_count;
    *copy = *region;
    copy->first_primitive = primitive;
    copy->first_node = node;
    for (size_t i = 0; i < region->primitive_count; i++)
        bodies->primitives[primitive + i] =
            scene->primitives[region->first_primitive + i];
    for (size_t i = 0; i < region->node_count; i++) {
        struct tree_node *to = &bodies->nodes[node + i];
        *to = scene->nodes[region->first_node + i];
        to->next = to->next - region->first_node + node;
        if (to->operation == TREE_LEAF)
            to->primitive = to->primitive - region->first_primitive + primitive;
    }
    bodies->primitive_count += region->primitive_count;
    bodies->node_count += region->node_count;
}

bool bodies_take(const struct scene *scene, const struct named_parts *parts,
                 struct scene *bodies)
{
    *bodies = *scene;
    bodies->primitive_count = bodies->node_count = bodies->region_count = 0;
    bodies->primitives = calloc(scene->primitive_count + 1, sizeof *bodies->primitives);
    bodies->nodes = calloc(scene->node_count + 1, sizeof *bodies->nodes);
    bodies->regions = calloc(scene->region_count + 1, sizeof *bodies->regions);
    if (!bodies->primitives || !bodies->nodes || !bodies->regions)
        return false;
    for (size_t i = 0; i < scene->region_count; i++)
        if (!part_of(parts, scene, &scene->regions[i])->left_out)
            copy_region(scene, &scene->regions[i], bodies);
    return true;
}

void bodies_free(struct scene *bodies)
{
    free(bodies->primitives);
    free(bodies->nodes);
    free(bodies->regions);
}
