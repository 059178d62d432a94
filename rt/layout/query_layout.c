/* query_layout.c - writes a scene and the lines of a query into the machine's
 * memory. */
#include "rt/layout/query_layout.h"

#include <stdlib.h>

#include "rt/layout/program.h"
#include "rt/layout/record.h"
#include "rt/layout/solids.h"
#include "rt/layout/trees.h"

struct query_layout {
    const struct object *program;
    struct image image;
    uint64_t end; /* the next unused address */
    size_t most;  /* largest number of crossings of a line */
    size_t objects;
};

/* Writes the primitives without images, because the surfaces are plain, and without
 * viewpoints, because the lines have no common origin. */
static void layout_bare_solids(struct record_layout *layout, const struct scene *scene,
                               enum bounding bounding)
{
    struct interiors interiors;
    if (interiors_find(scene, &interiors))
        layout_solids(layout, scene, &interiors, NULL, NULL, bounding);
    else
        layout_fail(layout, "out of memory");
    interiors_free(&interiors);
}

struct query_layout *query_layout_new(const struct object *program,
                                      const struct scene *scene, enum bounding bounding,
                                      c205_error *error)
{
    struct query_layout *whole = calloc(1, sizeof *whole);
    struct record_layout layout = { .program = program,
                                    .error = error,
                                    .free = program_end(program) };
    if (!whole) {
        layout_fail(&layout, "out of memory");
        return NULL;
    }
    layout.image = &whole->image;
    layout_bare_solids(&layout, scene, bounding);
    whole->program = program;
    whole->end = layout.free;
    whole->most = max_ray_hits(scene);
    whole->objects = scene->object_count;
    image_share(&whole->image);
    if (!layout.failed)
        return whole;
    query_layout_free(whole);
    return NULL;
}

void query_layout_free(struct query_layout *layout)
{
    if (!layout)
        return;
    image_free(&layout->image);
    free(layout);
}

/* Writes six planes: the coordinates of the origins, then of the directions. */
static void layout_rays(struct record_layout *layout,
                        const struct packet_layout *packet)
{
    size_t count = packet->count;
    c205_word *words = calloc(6 * count, sizeof *words);
    uint64_t rays = layout_reserve(layout, 6 * count);
    if (!words)
        layout_fail(layout, "out of memory");
    for (size_t i = 0; words && i < count; i++)
        for (size_t k = 0; k < 3; k++) {
            const struct scene_ray *line = &packet->lines[i];
            words[k * count + i] = c205_from_double(line->origin[k]);
            words[(3 + k) * count + i] = c205_from_double(line->direction[k]);
        }
    if (words)
        layout_words(layout, rays, words, 6 * count);
    free(words);
    layout_word(layout, "query_rays", rays);
}

static void layout_packet(struct record_layout *layout,
                          const struct query_layout *whole,
                          struct packet_layout *packet)
{
    size_t size = (size_t)layout_symbol(layout, "RAY_HIT_SIZE");
    size_t most = whole->most, objects = whole->objects;
    layout_rays(layout, packet);
    packet->counts = layout_reserve(layout, packet->count);
    packet->found = layout_reserve(layout, size * most * packet->count);
    layout_word(layout, "query_count", c205_from_integer((int64_t)packet->count));
    layout_word(layout, "query_start", c205_from_double(packet->behind));
    layout_word(layout, "query_counts", packet->counts);
    layout_word(layout, "query_hits", packet->found);
    layout_word(layout, "query_list", layout_reserve(layout, size * most));
    if (object_symbol(layout->program, "DEPTH_SIZE"))
        layout_word(layout, "query_depths",
                    layout_reserve(layout,
                                   objects
                                       * (size_t)layout_symbol(layout, "DEPTH_SIZE")));
}

bool query_layout_put(const struct query_layout *whole, c205 *machine,
                      struct packet_layout *packet, c205_error *error)
{
    struct image image = { 0 };
    struct record_layout layout = {
        .image = &image, .program = whole->program, .error = error, .free = whole->end
    };
    bool good;
    layout_packet(&layout, whole, packet);
    good = !layout.failed && image_load(&whole->image, machine, error)
           && image_load(&image, machine, error);
    image_free(&image);
    return good;
}
