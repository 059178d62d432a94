/* heat.h - the shape factors between the surfaces of a scene, found by rays or by lines,
 * with errors that are small enough; and what these surfaces exchange.
 */
#ifndef RT_HEAT_H
#define RT_HEAT_H

#include "rt/heat/thermal.h"

struct heat_request {
    enum trace_mode mode;
    size_t queue, jobs;
    enum surfaces_by by;
    /* Of each repeat: points of each primitive, 1 .. MAX_FACTORS_POINTS, or lines through all of
     * the scene, a power of two.  By lines no primitive is without emission. */
    bool by_lines;
    size_t drawn;
    size_t repeats; /* 2 or more */
    bool lattice;   /* or random */
    uint64_t seed;
    /* With four times as many until no factor's standard error, or what one of its rays
     * says, is larger; 0: once. */
    double tolerance;
    size_t limit; /* drawn at most, if there is a tolerance */
    bool smooth;  /* factors, too, and the exchange is by them (smooth.h) */
    bool exchange;
    const char *const *emissivities, *const *temperatures; /* NAME=VALUE */
    size_t emissivity_count, temperature_count;
    struct job_set *job_set; /* as in job_set_work */
    const c205_model *model;
    bool (*progress)(void *context, size_t done, size_t all);
    void *context;
};

struct heat {
    const struct heat_request *request;
    const struct scene *scene;
    struct named_parts parts;
    const char **refusals; /* of each primitive, as in source.h */
    struct named_values emissivities, temperatures;
    struct surfaces surfaces;
    struct thermal thermal;      /* if the exchange is asked */
    struct accounts accounts;    /* of all machines that found it */
    uint64_t clocks[HEAT_STEPS]; /* .. of them */
    size_t drawn, units; /* of the last round; packets, done here or elsewhere */
    double worst;        /* the largest error of a factor, one ray at least, */
    size_t worst_from, worst_to; /* .. and whose it is */
};

/* What is given must outlive the heat.  False: a scene without surfaces, names and values
 * that cannot be; no memory.  Free it in either case. */
bool heat_begin(const struct scene *scene, const struct heat_request *request,
                struct heat *heat, c205_error *error);
/* Where the job set does not collect packets nothing but their number is found.  False: a trap,
 * no memory, a file of another run, whatever factors.h, global_lines.h and thermal.h
 * refuse. */
bool heat_find(struct heat *heat, c205_error *error);
void heat_free(struct heat *heat);

bool heat_is_precise(const struct heat *heat);
/* The surface to which a factor goes: the last one is the environment. */
const char *heat_receiver(const struct heat *heat, size_t to);
/* That is what both found: the same counts and the same bits of areas, factors and flows. */
bool heat_is_same(const struct heat *one, const struct heat *other);

#endif
