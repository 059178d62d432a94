/* trees.h - plans the evaluation of a region's tree.
 *
 * The plan is computed once. It has the order of the steps, the positions of their
 * results, and the positions of the crossings of the primitives.
 */
#ifndef RT_TREES_H
#define RT_TREES_H

#include "rt/scene/scene.h"

/* Returns true for a region that is one opaque primitive with no yield, if only
 * its nearest crossing ahead is needed. */
bool region_is_simple(const struct scene *scene, const struct region *region);

/* Returns true if all surfaces of the region belong to bodies and are visible. A
 * line is then inside of it between two crossings. */
bool region_is_closed(const struct scene *scene, const struct region *region);

bool primitive_is_mesh(const struct primitive *primitive);
/* Returns true if a mesh of the scene is in a region that is not simple. The
 * kernels then need shapes/mesh_crossings_vector.s. */
bool scene_has_crossed_meshes(const struct scene *scene);

/* The plan of a primitive in its region. */
struct leaf_plan {
    bool simple;        /* its region is simple (region_is_simple) */
    size_t first_state; /* its first crossing that bounds a segment */
    size_t first_event; /* its first crossing that can be visible */
    size_t value;       /* its index among the tree's values */
};

/* Plans each of the scene's primitives. Returns the largest number of crossings of
 * a region. */
size_t plan_leaves(const struct scene *scene, struct leaf_plan *plans);
/* Returns the largest number of crossings of a primitive. The kernels need room
 * for it if it exceeds their default (MAX_CROSSINGS in records.s). */
size_t most_crossings(const struct scene *scene);
/* Returns a bound on the visible crossings of a line with the whole scene. */
size_t max_ray_hits(const struct scene *scene);

/* A step of the evaluation. The operations are the values of T_OPERATION. */
enum step_operation { STEP_AND, STEP_OR, STEP_AND_NOT };
struct tree_step {
    enum step_operation operation;
    size_t left, right, result; /* values: the primitives', then the steps' */
};

/* For a node: the index of its value, or of its complement's value, and the steps
 * that compute it from its children's values. A node with a bound is not a
 * complement, so its value is false for rays that miss the bound. */
struct tree_join {
    size_t value, first_step, step_count;
};

struct tree_plan {
    size_t step_count;
    size_t result;           /* the value of the tree, or of its complement, which
                              * has the same surfaces */
    bool complement;         /* the result is that of the complement */
    struct tree_step *steps; /* children come before their parents */
    struct tree_join *joins;
};

/* Plans a region's tree. The caller provides room for as many steps as the region
 * has primitives, and for as many joins as it has nodes. Returns false if out of
 * memory. */
bool plan_tree(const struct scene *scene, const struct region *region,
               struct tree_plan *plan);
/* Returns the largest number of primitives of a region. n primitives make n values
 * and n - 1 steps with a value each. At most as many branches have a value. */
size_t most_leaves(const struct scene *scene);

#endif
