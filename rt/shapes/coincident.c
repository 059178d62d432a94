/* coincident.c - finds coincident surfaces and computes the yields of regions.
 *
 * Two surfaces may coincide if their bounding boxes overlap and one of these conditions
 * holds: both have a flat face in the same plane; both have a face of the same quadric;
 * they are equal shapes at the same place. Two flat faces that only touch along an edge
 * do not coincide. Two faces do not coincide if no ray enters their bodies, and the
 * bodies are on opposite sides of the faces.
 *
 * The depth of a region is the length of the longest chain of regions that begins with
 * the region. Each region of a chain is later in the scene than its predecessor, and
 * may coincide with it. The yield of a region is its depth divided by (1 + the greatest
 * depth).
 */
#include "rt/shapes/coincident.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "rt/scene/vector3.h"
#include "rt/shapes/opaque_faces.h"
#include "rt/shapes/quadric_face.h"
#include "rt/shapes/shape.h"

/* Unbounded boxes are clipped at this distance. */
#define FAR 1e4

struct face_pair {
    uint32_t earlier, later; /* indices of regions */
};

struct pair_list {
    size_t count;
    struct face_pair *pairs;
    bool failed; /* out of memory */
};

/* Computes the intersection of two boxes. Returns false if the intersection has no
 * area. */
static bool overlap(const struct face *a, const struct face *b, double low[3],
                    double high[3])
{
    int wide = 0;
    for (int i = 0; i < 3; i++) {
        double least = fmax(a->low[i], b->low[i]);
        double most = fmin(a->high[i], b->high[i]);
        if (most - least < -COINCIDENT)
            return false;
        wide += most - least > COINCIDENT;
        low[i] = fmax(least, fmin(most, 0) - FAR);
        high[i] = fmin(most, fmax(least, 0) + FAR);
    }
    return wide >= 2;
}

static bool same_shape(const struct face *a, const struct face *b)
{
    struct bound one, other;
    double beside[3];
    if (a->primitive->kind != b->primitive->kind)
        return false;
    bound_primitive(a->primitive, &one);
    bound_primitive(b->primitive, &other);
    if (bound_is_none(&one) || bound_is_none(&other))
        return memcmp(&a->primitive->shape, &b->primitive->shape,
                      sizeof a->primitive->shape)
                   == 0
               && memcmp(&a->primitive->to_local, &b->primitive->to_local,
                         sizeof a->primitive->to_local)
                      == 0;
    subtract3(one.center, other.center, beside);
    return length3(beside) + fabs(one.radius - other.radius)
           <= COINCIDENT * fmax(one.radius, 1);
}

static bool coincide(const struct face *a, const struct face *b)
{
    double low[3], high[3], center[3], reach;
    int sense;
    if (a->region == b->region || !overlap(a, b, low, high))
        return false;
    reach = face_middle(low, high, center);
    switch (a->sort) {
    case FACE_FLAT:
        return a->side * b->side >= 0 && face_same_plane(a, b, center, reach);
    case FACE_QUADRIC:
        sense = quadric_face_compare(a->primitive, b->primitive, center, reach);
        return sense != 0 && sense * a->side * b->side >= 0;
    default: return same_shape(a, b);
    }
}

static void add_pair(struct pair_list *list, const struct face *a, const struct face *b)
{
    struct face_pair pair = {
        (uint32_t)(a->region < b->region ? a->region : b->region),
        (uint32_t)(a->region < b->region ? b->region : a->region),
    };
    if (!array_add(&list->pairs, &list->count, &pair, sizeof pair))
        list->failed = true;
}

static int compare_places(const void *a, const void *b)
{
    const struct face *one = a, *other = b;
    return (one->low[0] > other->low[0]) - (one->low[0] < other->low[0]);
}

/* The largest number of overlapping faces that a face is compared with. With thousands
 * of objects at one position, comparing all pairs would take minutes. */
enum { COMPARED_MAX = 64 };

/* Adds the pairs of regions that have coincident faces, among faces with nearly the
 * same key. Sorts these faces by their left ends. */
static void pair_group(struct pair_list *pairs, struct face *faces, size_t count)
{
    qsort(faces, count, sizeof *faces, compare_places);
    for (size_t i = 0; i < count; i++) {
        size_t compared = 0;
        for (size_t k = i + 1; k < count && !pairs->failed && compared < COMPARED_MAX
                               && faces[k].low[0] <= faces[i].high[0] + COINCIDENT;
             k++) {
            double low[3], high[3];

            compared += overlap(&faces[i], &faces[k], low, high);
            if (coincide(&faces[i], &faces[k]))
                add_pair(pairs, &faces[i], &faces[k]);
        }
    }
}

static void pair_faces(const struct face_list *list, struct pair_list *pairs)
{
    struct face *faces = list->faces;
    qsort(faces, list->count, sizeof *faces, face_compare);
    for (size_t i = 0, end; i < list->count; i = end) {
        for (end = i + 1;
             end < list->count && face_is_near(&faces[end - 1], &faces[end]);)
            end++;
        pair_group(pairs, faces + i, end - i);
    }
}

/* ---- Yields -------------------------------------------------------------- */

static int compare_pairs(const void *a, const void *b)
{
    const struct face_pair *one = a, *other = b;
    return (one->earlier < other->earlier) - (one->earlier > other->earlier);
}

/* Computes the depth of each region in its member `yield`, then divides all depths by 1
 * + the greatest depth. The pairs are sorted in descending order of the earlier region,
 * so the depth of a later region is final when it is used. */
static void put_yields(const struct pair_list *list, struct region *regions,
                       size_t count)
{
    double most = 0;
    for (size_t i = 0; i < count; i++)
        regions[i].yield = 0;
    qsort(list->pairs, list->count, sizeof *list->pairs, compare_pairs);
    for (size_t i = 0; i < list->count; i++) {
        struct region *earlier = &regions[list->pairs[i].earlier];
        earlier->yield = fmax(earlier->yield, regions[list->pairs[i].later].yield + 1);
        most = fmax(most, earlier->yield);
    }
    for (size_t i = 0; i < count; i++)
        regions[i].yield /= most + 1;
}

bool coincident_find(struct scene *scene)
{
    struct face_list faces = { 0 };
    struct pair_list pairs = { 0 };
    for (size_t i = 0; scene->region_count > 1 && i < scene->region_count; i++)
        opaque_faces_add(&faces, scene, i);
    if (!faces.failed && faces.count > 0)
        pair_faces(&faces, &pairs);
    if (pairs.count > 0)
        put_yields(&pairs, scene->regions, scene->region_count);
    free(faces.faces);
    free(pairs.pairs);
    return !faces.failed && !pairs.failed;
}
