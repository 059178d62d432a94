/* packet.h - a packet of rays. It consists of the points of a repeat of an emitter (or
 * of a piece of the repeat), the visible points among them, and the receivers of their
 * rays.
 *
 * A point of the emitter's source is visible if the tree of its region has different
 * values on the two sides of the surface. Each visible point sends one ray, and the
 * first hit is its receiver. A ray that begins inside another body is counted as
 * covered.
 */
#ifndef RT_PACKET_H
#define RT_PACKET_H

#include "rt/jobs/serialized_result.h"
#include "rt/heat/factors.h"
#include "rt/heat/heat_source.h"

/* The data that all packets of a scene share. */
struct packet_programs {
    const struct scene *scene;
    struct sampling_options options;
    struct ray_query *normals, *rays;
    struct object *faces, *received;
};

/* Assembles the programs and lays the scene out. Returns false for invalid options, or
 * if out of memory. Call packet_programs_end in either case. */
bool packet_programs_begin(struct packet_programs *programs, c205_error *error);
void packet_programs_end(struct packet_programs *programs);

/* Returns the number of receivers. The last receiver is the environment. */
size_t packet_receivers(const struct packet_programs *programs);

/* The results of a packet, and their cost. */
struct packet {
    uint64_t made;     /* number of points of the source */
    uint64_t stay;     /* number of points on visible faces */
    size_t width;      /* number of words in `sums` and `counts` together */
    c205_word *sums;   /* sums of weights: of the rays to each receiver, of covered
                        * points, of all points */
    c205_word *counts; /* numbers of rays to each receiver, and of covered points */
    struct accounts accounts;
    uint64_t clocks[HEAT_STEPS]; /* clocks of all machines for each step */
};

/* Allocates the sums and counts of a packet. Returns false if out of memory. Call
 * packet_free in either case. */
bool packet_begin(struct packet *packet, const struct packet_programs *programs);
void packet_free(struct packet *packet);

/* Selects the points of a packet: the points of one repeat on one primitive, from the
 * number `first` on. */
struct packet_choice {
    size_t primitive, repeat, first;
};

/* Runs a packet. Threads may run packets concurrently. Returns false after a trap,
 * or if out of memory. */
bool packet_run(const struct packet_programs *programs,
                const struct heat_source *source, const struct packet_choice *choice,
                struct packet *packet, c205_error *error);

/* Appends the packet to a serialized result. */
void packet_put(const struct packet *packet, struct serialized_result *words);
/* Reads a packet from a serialized result. Returns false if its format is wrong. The
 * packet then needs no cleanup. */
bool packet_take(struct packet *packet, struct serialized_result *words);

#endif
