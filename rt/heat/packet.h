/* packet.h - a packet of rays: the points of one repeat of an emitter, or of a
 * piece of it, the visible points among them, and the receivers of their rays.
 *
 * A point of the emitter's source is kept if the surface is visible there, which
 * means that the tree of its region has different values on its two sides. Each
 * kept point sends one ray, and the first hit receives it. A ray that begins
 * within another body is counted as covered.
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

/* Returns false for invalid options, or if out of memory. Call packet_programs_end
 * in either case. */
bool packet_programs_begin(struct packet_programs *programs, c205_error *error);
void packet_programs_end(struct packet_programs *programs);

/* Returns the number of receivers. The last one is the environment. */
size_t packet_receivers(const struct packet_programs *programs);

/* The results of a packet, and their cost. */
struct packet {
    uint64_t made;     /* points of the source */
    uint64_t stay;     /* points on visible faces */
    size_t width;      /* number of words of sums and counts */
    c205_word *sums;   /* of weights: by receiver, of covered points, of all */
    c205_word *counts; /* of rays: by receiver, of covered points */
    struct accounts accounts;
    uint64_t clocks[HEAT_STEPS]; /* the clocks of these machines, by step */
};

/* Returns false if out of memory. Call packet_free in either case. */
bool packet_begin(struct packet *packet, const struct packet_programs *programs);
void packet_free(struct packet *packet);

/* Selects the points of a packet: those of a repeat of a primitive, from number
 * `first` on. */
struct packet_choice {
    size_t primitive, repeat, first;
};

/* Runs a packet. Threads may run packets concurrently. Returns false after a trap,
 * or if out of memory. */
bool packet_run(const struct packet_programs *programs,
                const struct heat_source *source, const struct packet_choice *choice,
                struct packet *packet, c205_error *error);

/* Appends the packet to the words of a unit of work. */
void packet_put(const struct packet *packet, struct serialized_result *words);
/* Reads a packet from words. Returns false if their format is wrong; the packet
 * then needs no cleanup. */
bool packet_take(struct packet *packet, struct serialized_result *words);

#endif
