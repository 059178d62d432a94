/* packet.h - a packet of rays: one repeat of an emitter or a piece of it, its points, which of them are
 * seen, and what receives the rays that go out from these.
 *
 * A point of the emitter's source stays if the surface is seen there, that is if its
 * region has another value before it than behind it.  Of the points that stay one ray goes
 * out each, and what it meets first receives it; one that begins within another body is
 * counted as covered.
 */
#ifndef RT_PACKET_H
#define RT_PACKET_H

#include "rt/jobs/serialized_result.h"
#include "rt/heat/factors.h"
#include "rt/heat/source.h"

/* What the packets of a scene have in common. */
struct packet_programs {
    const struct scene *scene;
    struct factors_options options;
    struct ray_query *normals, *rays;
    struct object *faces, *received;
};

/* False: options that cannot be, no memory.  End it in either case. */
bool packet_programs_begin(struct packet_programs *programs, c205_error *error);
void packet_programs_end(struct packet_programs *programs);

/* What receives something: .. and the environment, the last one. */
size_t packet_receivers(const struct packet_programs *programs);

/* What the rays of a repeat come to, and what that took. */
struct packet {
    uint64_t made;     /* points of the source */
    uint64_t stay;     /* .. that are on faces */
    size_t width;      /* of words */
    c205_word *sums;   /* of weights: by receiver, of what is covered, of all */
    c205_word *counts; /* of rays: by receiver, of what is covered */
    struct accounts accounts;
    uint64_t clocks[HEAT_STEPS]; /* .. of them */
};

/* False: no memory.  Free it in either case. */
bool packet_begin(struct packet *packet, const struct packet_programs *programs);
void packet_free(struct packet *packet);

/* Which points a packet has: those of a repeat of a primitive, from number `first` on. */
struct packet_choice {
    size_t primitive, repeat, first;
};

/* Any number of threads may run packets at a time.  False: a trap, no memory. */
bool packet_run(const struct packet_programs *programs,
                const struct heat_source *source, const struct packet_choice *choice,
                struct packet *packet, c205_error *error);

/* As a unit of work comes to it. */
void packet_put(const struct packet *packet, struct serialized_result *words);
/* False: these are no such words; the packet is as good as new. */
bool packet_take(struct packet *packet, struct serialized_result *words);

#endif
