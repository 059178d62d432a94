/* disc.c - the descriptor of discs: checks their arguments, computes their bounds and
 * the words of their records, and names their kernels. */
#include "rt/shapes/shape.h"

#include "rt/scene/vector3.h"
#include "rt/shapes/axis.h"
#include "rt/shapes/flat_faces.h"

static const struct shape_field fields[] = {
    { TAKES_VECTOR, SHAPE_AT(disc, center), NULL, 0, NULL },
    { TAKES_VECTOR, SHAPE_AT(disc, normal), NULL, 0, NULL },
    { TAKES_RADIUS, SHAPE_AT(disc, radius), NULL, 0, NULL },
    { TAKES_MORE, SHAPE_AT(disc, hole), NULL, 0, NULL },
    { TAKES_END, 0, NULL, 0, NULL },
};

static const char *finish(struct primitive *primitive)
{
    const char *fault = axis_make_normal(primitive->shape.disc.normal);
    primitive->shape.disc.hole = fabs(primitive->shape.disc.hole);
    if (!fault && primitive->shape.disc.hole >= primitive->shape.disc.radius)
        fault = "the disc has no area";
    return fault ? shape_empty(primitive, fault) : NULL;
}

static void put_bound(const struct primitive *primitive, struct bound *bound)
{
    struct hull hull = { .count = 0 };
    hull_ring(&hull, primitive, primitive->shape.disc.center,
              primitive->shape.disc.normal, primitive->shape.disc.radius);
    bound_hull(&hull, bound);
}

/* Writes the words of the disc's plane, then its centre, then the squares of the radii
 * of the disc and of its hole. */
static size_t put_words(const struct primitive *primitive, double *words)
{
    double radius = primitive->shape.disc.radius, hole = primitive->shape.disc.hole;
    copy3(primitive->shape.disc.normal, words);
    words[3] = dot3(primitive->shape.disc.normal, primitive->shape.disc.center);
    copy3(primitive->shape.disc.center, words + 4);
    words[7] = radius * radius;
    words[8] = hole * hole;
    return 9;
}

/* Describes the disc as a frustum of height 0, from the outer to the inner edge. The
 * length of its axis is arbitrary. */
static const char *emit(const struct primitive *primitive, struct emitter *emitter)
{
    const double *center = primitive->shape.disc.center;
    const double *normal = primitive->shape.disc.normal;
    double above[3], below[3], half;
    for (int i = 0; i < 3; i++) {
        above[i] = center[i] + normal[i];
        below[i] = center[i] - normal[i];
    }
    if (!emitter_about_axis(emitter, below, above, &half))
        return emitter_no_memory;
    emitter_add_frustum(emitter, 0, primitive->shape.disc.radius, 0,
                        primitive->shape.disc.hole);
    return NULL;
}

static bool put_faces(const struct primitive *primitive, struct face_search *search)
{
    faces_add_ring(search, primitive->shape.disc.center, primitive->shape.disc.normal,
                   primitive->shape.disc.radius, false);
    return false;
}

const struct shape shape_disc = {
    .fields = fields,
    .finish = finish,
    .povray = true,
    .bound = put_bound,
    .endless = true,
    .words = put_words,
    .flat_faces = put_faces,
    .region = "disc",
    .emit = emit,
    .kernels = { .kernel = "disc",
                 .normal = "normal_plane",
                 .segments = 1,
                 .state = "plane" },
};
