/* query_layout.h - a scene, and lines through it, as the programs of rt/kernels/query/ want
 * them (query.s). */
#ifndef RT_LAYOUT_QUERY_LAYOUT_H
#define RT_LAYOUT_QUERY_LAYOUT_H

#include "asm/assemble.h"
#include "rt/layout/bounding.h"
#include "rt/scene/scene.h"

/* Of any length but 0. */
struct scene_ray {
    double origin[3], direction[3];
};

/* Where a packet of lines, and what is found of them, lies. */
struct packet_layout {
    const struct scene_ray *lines;
    size_t count;    /* of the lines */
    double behind;   /* so far behind their origins they begin */
    uint64_t counts; /* address of a plane: the crossings of each */
    uint64_t found;  /* .. of SEEN_SIZE planes for each crossing */
};

/* What all machines have in common.  Of the scene all crossings are asked
 * (every_crossing), and its surfaces are plain. */
struct query_layout;

/* NULL: no memory, or numbers that do not fit. */
struct query_layout *query_layout_new(const struct object *program,
                                      const struct scene *scene, enum bounding bounding,
                                      c205_error *error);
void query_layout_free(struct query_layout *layout);

/* After c205_load: map and fill what the program reads, map what it writes.
 * The layout stays as long as the machine runs or is looked at. */
bool query_layout_put(const struct query_layout *layout, c205 *machine,
                      struct packet_layout *packet, c205_error *error);

#endif
