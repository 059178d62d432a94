/* regions.h - what is traced as one thing, as records in the machine's memory.
 *
 * How a region's tree is evaluated is worked out here, once: the order of the
 * steps, where their results stand, and where the crossings of its primitives
 * do.
 */
#ifndef RT_REGIONS_H
#define RT_REGIONS_H

#include "rt/layout/bounding.h"
#include "rt/layout/hierarchy.h"
#include "rt/layout/record.h"
#include "rt/scene/scene.h"

/* Of one primitive in its region. */
struct leaf_plan {
    bool simple;        /* its region is this primitive, and opaque */
    size_t first_state; /* which of the region's crossings are its
                           segments, */
    size_t first_event; /* and which are those that can be seen; */
    size_t value;       /* its place among the tree's values */
};

/* One for each of the scene's primitives.  Returns the crossings of the region
 * that has most. */
size_t plan_leaves(const struct scene *scene, struct leaf_plan *plans);
/* The crossings of the primitive that has most: what the kernels have room
 * for, if it is more than they have anyway (CROSSINGS_MOST in records.s). */
size_t most_crossings(const struct scene *scene);

/* A step of the evaluation, with the numbers of T_OPERATION. */
enum step_operation { STEP_AND, STEP_OR, STEP_AND_NOT };
struct tree_step {
    enum step_operation operation;
    size_t left, right, result; /* values: the primitives', then the steps' */
};

struct tree_plan {
    size_t step_count;
    size_t result; /* the value of the tree, or what it is not: the same
                      surfaces */
    struct tree_step *steps;
};

/* Into room for as many steps as the region has primitives.  False: no
 * memory. */
bool plan_tree(const struct scene *scene, const struct region *region,
               struct tree_plan *plan);

/* All regions, behind primitives that stand at that address. */
void layout_regions(struct record_layout *layout, const struct scene *scene,
                    enum bounding bounding, uint64_t primitives);

#endif
