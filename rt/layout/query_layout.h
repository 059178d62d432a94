/* query_layout.h - writes a scene and the lines of a query into the machine's memory,
 * in the format of rt/kernels/query/query.s. */
#ifndef RT_LAYOUT_QUERY_LAYOUT_H
#define RT_LAYOUT_QUERY_LAYOUT_H

#include "asm/object/object.h"
#include "rt/layout/bounding.h"
#include "rt/scene/scene.h"

/* A line. The length of its direction is arbitrary, but not 0. */
struct scene_ray {
    double origin[3], direction[3];
};

/* The addresses of a packet of lines and of its results in memory. */
struct packet_layout {
    const struct scene_ray *lines;
    size_t count;    /* number of lines */
    double behind;   /* distance of a line's start before its origin */
    uint64_t counts; /* address of a plane: the number of crossings of each line */
    uint64_t found;  /* address of RAY_HIT_SIZE planes for each crossing */
};

/* The part of memory that all machines share. All surfaces of its scene must be plain,
 * and scene.every_crossing must be set. */
struct query_layout;

/* Writes the scene for a program of queries into memory that machines can share.
 * Returns NULL if out of memory, or if a number is out of range. */
struct query_layout *query_layout_new(const struct object *program,
                                      const struct scene *scene, enum bounding bounding,
                                      c205_error *error);
void query_layout_free(struct query_layout *layout);

/* Maps and fills the memory that the program reads, and maps the memory that it writes.
 * Call this after c205_load. The layout must outlive all use of the machine. */
bool query_layout_put(const struct query_layout *layout, c205 *machine,
                      struct packet_layout *packet, c205_error *error);

#endif
