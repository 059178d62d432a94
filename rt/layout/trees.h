/* trees.h - how a region's tree is evaluated.
 *
 * It is worked out here, once: the order of the steps, where their results
 * stand, and where the crossings of its primitives do.
 */
#ifndef RT_TREES_H
#define RT_TREES_H

#include "rt/scene/scene.h"

/* One opaque primitive, of which the nearest crossing ahead is all that is
 * wanted, with no yield. */
bool region_is_simple(const struct scene *scene, const struct region *region);

/* Are all its surfaces those of bodies, and seen?  Then a line is inside of it
 * between one crossing and another. */
bool region_is_closed(const struct scene *scene, const struct region *region);

bool primitive_is_mesh(const struct primitive *primitive);
/* Whether any mesh is not simple: the kernels need
 * shapes/mesh_crossings_vector.s. */
bool scene_has_crossed_meshes(const struct scene *scene);

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
 * for, if it is more than they have anyway (MAX_CROSSINGS in records.s). */
size_t most_crossings(const struct scene *scene);
/* The crossings of a line with all of the scene that may be seen, at most. */
size_t seen_crossings_most(const struct scene *scene);

/* A step of the evaluation, with the numbers of T_OPERATION. */
enum step_operation { STEP_AND, STEP_OR, STEP_AND_NOT };
struct tree_step {
    enum step_operation operation;
    size_t left, right, result; /* values: the primitives', then the steps' */
};

/* Of a node: where its value stands, or what it is not, and the steps that make
 * it of the values of its children.  What has a bound is not a complement, so
 * where no ray comes near a node its value is false. */
struct tree_join {
    size_t value, first_step, step_count;
};

struct tree_plan {
    size_t step_count;
    size_t result;           /* the value of the tree, or what it is not: the same
                      surfaces */
    bool complement;         /* .. the latter */
    struct tree_step *steps; /* those of a node before those above it */
    struct tree_join *joins;
};

/* Into room for as many steps as the region has primitives, and as many joins
 * as it has nodes.  False: no memory. */
bool plan_tree(const struct scene *scene, const struct region *region,
               struct tree_plan *plan);
/* The primitives of the region that has most; n make n values, and n - 1 steps
 * as many more, so no more branches have any. */
size_t most_leaves(const struct scene *scene);

#endif
