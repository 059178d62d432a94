/* trees.h - plans the evaluation of a region's tree.
 *
 * The plan is computed once. It contains the order of the steps, the positions of their
 * results, and the positions of the primitives' crossings.
 */
#ifndef RT_TREES_H
#define RT_TREES_H

#include "rt/scene/scene.h"

/* Returns true if the region is one opaque primitive, and the scene needs only the
 * nearest crossings. */
bool region_is_simple(const struct scene *scene, const struct region *region);

/* Returns true if all surfaces of the region belong to bodies and are visible. The part
 * of a line between two successive crossings is then alternately inside and outside. */
bool region_is_closed(const struct scene *scene, const struct region *region);

bool primitive_is_mesh(const struct primitive *primitive);
/* Returns true if a mesh of the scene is in a region that is not simple. The
 * kernels then need shapes/mesh_crossings_vector.s. */
bool scene_has_crossed_meshes(const struct scene *scene);

/* The plan of a primitive in its region. */
struct leaf_plan {
    bool simple;        /* its region is simple (region_is_simple) */
    size_t first_state; /* index of its first crossing that bounds a segment */
    size_t first_event; /* index of its first crossing that can be visible */
    size_t value;       /* its index among the tree's values */
};

/* Fills the plan of each primitive of the scene. Returns the largest number of
 * crossings that a region needs. */
size_t plan_leaves(const struct scene *scene, struct leaf_plan *plans);
/* Returns the largest number of crossings of a primitive. If it exceeds MAX_CROSSINGS
 * of records.s, the kernels need more room. */
size_t most_crossings(const struct scene *scene);
/* Returns an upper bound for the number of visible crossings of a line with the
 * scene. */
size_t max_ray_hits(const struct scene *scene);

/* A step of the evaluation. The operations are the values of T_OPERATION. */
enum step_operation { STEP_AND, STEP_OR, STEP_AND_NOT };
struct tree_step {
    enum step_operation operation;
    size_t left, right, result; /* indices of values: first the primitives' values, then
                                 * the steps' values */
};

/* The steps that compute a node from its children. `value` is the index of their
 * result. For a node without a bound, the result may be the complement of the node's
 * value. For a node with a bound, the result is always the node's value, which is false
 * for rays that miss the bound. */
struct tree_join {
    size_t value, first_step, step_count;
};

struct tree_plan {
    size_t step_count;
    size_t result;           /* the value of the tree or of its complement; both have
                              * the same surfaces */
    bool complement;         /* the result is the value of the complement */
    struct tree_step *steps; /* children come before their parents */
    struct tree_join *joins;
};

/* Plans the evaluation of a region's tree. The caller allocates plan->steps with an
 * element for each primitive of the region, and plan->joins with an element for each
 * node. Returns false if out of memory. */
bool plan_tree(const struct scene *scene, const struct region *region,
               struct tree_plan *plan);
/* Returns n, the largest number of primitives of a region. A tree of n primitives has n
 * values of primitives, n - 1 values of steps, and at most n branches that have a
 * value. */
size_t most_leaves(const struct scene *scene);

#endif
