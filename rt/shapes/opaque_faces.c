/* opaque_faces.c - collects the faces of opaque surfaces, and the side of each face on
 * which its body is solid.
 *
 * If one closed opaque body rests on another, the common face is inside their union,
 * and no ray from outside reaches it. The side is therefore recorded, but only for
 * bodies that no ray enters.
 */
#include "rt/shapes/opaque_faces.h"

#include <math.h>
#include <stdlib.h>

#include "base/array.h"
#include "rt/scene/transform.h"
#include "rt/scene/vector3.h"
#include "rt/shapes/coincident.h"
#include "rt/shapes/path.h"
#include "rt/shapes/flat_faces.h"
#include "rt/shapes/quadric_face.h"
#include "rt/shapes/shape.h"

/* Rounding error of a coordinate, relative to its size. */
#define ROUNDING 1e-12

struct face_search {
    const struct scene *scene;
    struct face_list *list;
    size_t region; /* index of the region whose faces are added */
    const struct primitive *primitive;
    bool sealed;        /* the region is a body that no ray enters */
    struct bound limit; /* box around the region */
};

static struct face *add_face(struct face_search *search, enum face_sort sort,
                             const struct bound *box)
{
    struct face_list *list = search->list;
    struct face *face;
    struct bound parts[2] = { *box, search->limit }, part;
    bound_common(parts, 2, &part);
    for (int i = 0; i < 3; i++)
        if (part.low[i] > part.high[i] + COINCIDENT)
            return NULL;
    face = array_add(&list->faces, &list->count, NULL, sizeof *face);
    list->failed = list->failed || !face;
    if (!face)
        return NULL;
    *face = (struct face){ .sort = sort,
                           .region = search->region,
                           .primitive = search->primitive };
    if (search->sealed)
        face->side = search->primitive->inverted ? -1 : 1;
    copy3(part.low, face->low);
    copy3(part.high, face->high);
    return face;
}

/* Computes a linear combination of three coordinates. Its irregular factors make it
 * unlikely that it is 0, or equal for different planes or points of a scene. */
static double mix3(const double numbers[3])
{
    return .5377 * numbers[0] + .6413 * numbers[1] + .5473 * numbers[2];
}

/* ---- Flat faces ---------------------------------------------------------- */

void faces_add_flat(struct face_search *search, const double normal[3],
                    const double point[3], bool outward, const struct bound *box)
{
    double way[3], at[3], length;
    struct face *face;
    copy3(normal, way);
    copy3(point, at);
    transform_normal(&search->primitive->to_local, way);
    transform_point(&search->primitive->to_world, at);
    length = length3(way);
    if (!(length > 0) || !(face = add_face(search, FACE_FLAT, box)))
        return;
    scale3(1 / length, way);
    face->side *= outward;
    if (mix3(way) < 0) {
        scale3(-1, way);
        face->side = -face->side;
    }
    copy3(way, face->plane);
    face->plane[3] = dot3(way, at);
    face->key = face->plane[3] + mix3(way);
}

void faces_add_hull(struct face_search *search, const double normal[3],
                    const double point[3], bool outward, const struct hull *hull)
{
    struct bound box;
    bound_hull_box(hull, &box);
    faces_add_flat(search, normal, point, outward, &box);
}

void faces_add_ring(struct face_search *search, const double center[3],
                    const double axis[3], double radius, bool outward)
{
    struct hull hull = { .count = 0 };
    if (!(radius > 0))
        return;
    hull_ring(&hull, search->primitive, center, axis, radius);
    faces_add_hull(search, axis, center, outward, &hull);
}

static void add_triangle(struct face_search *search, const double (*corners)[3])
{
    struct hull hull = { .count = 0 };
    double u[3], v[3], normal[3];
    for (int i = 0; i < 3; i++)
        hull_point(&hull, search->primitive, corners[i]);
    subtract3(corners[1], corners[0], u);
    subtract3(corners[2], corners[0], v);
    cross3(u, v, normal);
    faces_add_hull(search, normal, corners[0], false, &hull);
}

void faces_add_disks(struct face_search *search, const double base[3],
                     double base_radius, const double cap[3], double cap_radius)
{
    double up[3], down[3];
    subtract3(cap, base, up);
    subtract3(base, cap, down);
    faces_add_ring(search, base, down, base_radius, true);
    faces_add_ring(search, cap, up, cap_radius, true);
}

void faces_add_caps(struct face_search *search, const struct outline *path, double low,
                    double high)
{
    const double up[3] = { 0, 1, 0 }, down[3] = { 0, -1, 0 };
    const double top[3] = { 0, high, 0 }, bottom[3] = { 0, low, 0 };
    struct bound box;
    path_bound(search->primitive, path, low, low, &box);
    faces_add_flat(search, down, bottom, true, &box);
    path_bound(search->primitive, path, high, high, &box);
    faces_add_flat(search, up, top, true, &box);
}

/* ---- All faces ----------------------------------------------------------- */

static void add_curved(struct face_search *search)
{
    bool quadric = shape_of(search->primitive)->quadric != NULL;
    struct face *face;
    struct bound box;
    bound_primitive(search->primitive, &box);
    face = add_face(search, quadric ? FACE_QUADRIC : FACE_SHAPE, &box);
    if (!face)
        return;
    if (quadric)
        face->key = quadric_face_key(search->primitive);
    else if (!bound_is_none(&box))
        face->key = mix3(box.center) + .3 * box.radius;
}

bool face_same_plane(const struct face *a, const struct face *b, const double at[3],
                     double reach)
{
    double beside[3], between;
    subtract3(a->plane, b->plane, beside);
    between = dot3(beside, at) - (a->plane[3] - b->plane[3]);
    return fabs(between) + length3(beside) * reach
           <= COINCIDENT + ROUNDING * (length3(at) + reach);
}

int face_compare(const void *a, const void *b)
{
    const struct face *one = a, *other = b;
    if (one->sort != other->sort)
        return one->sort < other->sort ? -1 : 1;
    if (one->key != other->key)
        return one->key < other->key ? -1 : 1;
    if (one->low[0] != other->low[0])
        return one->low[0] > other->low[0] ? 1 : -1;
    return (one->region > other->region) - (one->region < other->region);
}

double face_middle(const double low[3], const double high[3], double center[3])
{
    double half[3];
    for (int i = 0; i < 3; i++) {
        center[i] = (low[i] + high[i]) / 2;
        half[i] = (high[i] - low[i]) / 2;
    }
    return length3(half);
}

/* Merges triangles of the same plane into one face. */
static void join_triangles(struct face_search *search, size_t first)
{
    struct face *faces = search->list->faces;
    size_t kept = first;
    if (search->list->failed)
        return;
    qsort(faces + first, search->list->count - first, sizeof *faces, face_compare);
    for (size_t i = first; i < search->list->count; i++) {
        struct face *last = &faces[kept > first ? kept - 1 : first];
        double center[3];
        double reach = face_middle(faces[i].low, faces[i].high, center);
        if (kept == first || !face_same_plane(last, &faces[i], center, reach)) {
            faces[kept++] = faces[i];
            continue;
        }
        for (int k = 0; k < 3; k++) {
            last->low[k] = fmin(last->low[k], faces[i].low[k]);
            last->high[k] = fmax(last->high[k], faces[i].high[k]);
        }
    }
    search->list->count = kept;
}

void faces_add_triangles(struct face_search *search, const struct triangles *triangles)
{
    size_t first = search->list->count;
    for (size_t i = 0; i < triangles->count && !search->list->failed; i++)
        add_triangle(search, (const double(*)[3])triangles->list[i].corners);
    join_triangles(search, first);
}

static void add_faces(struct face_search *search)
{
    const struct shape *shape = shape_of(search->primitive);
    if (!shape->flat_faces || shape->flat_faces(search->primitive, search))
        add_curved(search);
}

static bool is_opaque(const struct primitive *primitive)
{
    return !primitive->invisible && !pigment_is_clear(&primitive->pigment);
}

/* Returns true if a point outside of all primitives is inside the solid at a node. */
static bool is_endless(const struct scene *scene, size_t node)
{
    const struct tree_node *solid = &scene->nodes[node];
    bool any = false, all = true;
    for (size_t i = node + 1; i < solid->next; i = scene->nodes[i].next) {
        bool below = is_endless(scene, i);
        any = any || below;
        all = all && below;
    }
    switch (solid->operation) {
    case TREE_AND: return all;
    case TREE_OR: return any;
    case TREE_NOT: return !any;
    default: return false;
    }
}

/* Returns true if all camera rays start outside of a primitive. They start in a sphere
 * around the camera. */
static bool starts_outside(const struct camera *camera,
                           const struct primitive *primitive)
{
    double reach = camera->lens_radius, normal[3], at[3];
    struct bound box;
    if (camera->orthographic)
        reach += length3(camera->right) + length3(camera->up);
    if (primitive->kind == PRIMITIVE_PLANE) {
        copy3(primitive->shape.plane.normal, normal);
        copy3(camera->location, at);
        transform_point(&primitive->to_local, at);
        transform_normal(&primitive->to_local, normal);
        return dot3(primitive->shape.plane.normal, at) - primitive->shape.plane.distance
               > (reach + COINCIDENT) * length3(normal);
    }
    bound_primitive(primitive, &box);
    for (int i = 0; i < 3; i++)
        if (camera->location[i] + reach < box.low[i]
            || camera->location[i] - reach > box.high[i])
            return true;
    return false;
}

/* Returns true for a closed shape. A lathe whose ends are nearly on the axis counts as
 * closed. */
static bool is_closed(const struct primitive *primitive)
{
    const struct shape_kernels *kernels = shape_kernels_of(primitive);
    const struct outline *path = &primitive->shape.lathe.path;
    if (primitive->kind == PRIMITIVE_LATHE && path->points[0][0] < COINCIDENT
        && path->points[path->count - 1][0] < COINCIDENT)
        return true;
    return kernels->segments > 0 && !kernels->state;
}

/* Bounds a region by its primitives that are not subtracted. The region is sealed if
 * all its primitives are closed, visible and opaque, and the camera is outside. No ray
 * enters a sealed region. */
static void find_limit(struct face_search *search, const struct region *region)
{
    const struct primitive *first = &search->scene->primitives[region->first_primitive];
    bool some = false;
    search->limit = bound_none;
    search->sealed = !is_endless(search->scene, region->first_node);
    if (!search->sealed)
        return;
    for (size_t i = 0; i < region->primitive_count; i++) {
        struct bound parts[2];
        search->sealed = search->sealed && is_opaque(&first[i]) && is_closed(&first[i]);
        if (first[i].inverted)
            continue;
        bound_primitive(&first[i], &parts[0]);
        parts[1] = some ? search->limit : parts[0];
        bound_box(parts, 2, &search->limit);
        some = true;
        search->sealed = search->sealed
                         && starts_outside(&search->scene->camera, &first[i]);
    }
}

bool face_is_near(const struct face *a, const struct face *b)
{
    return a->sort == b->sort
           && b->key - a->key <= 4 * COINCIDENT + ROUNDING * (fabs(a->key) + 1);
}

void opaque_faces_add(struct face_list *list, const struct scene *scene, size_t region)
{
    struct face_search search = { .scene = scene, .list = list, .region = region };
    const struct region *solid = &scene->regions[region];
    find_limit(&search, solid);
    for (size_t i = 0; i < solid->primitive_count && !list->failed; i++) {
        search.primitive = &scene->primitives[solid->first_primitive + i];
        if (is_opaque(search.primitive))
            add_faces(&search);
    }
}
