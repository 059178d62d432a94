/* heat.h - computes the shape factors between the surfaces of a scene, by rays or
 * by lines, until their errors are small enough, and the radiative exchange. */
#ifndef RT_HEAT_H
#define RT_HEAT_H

#include "rt/heat/thermal.h"

struct heat_request {
    enum trace_mode mode;
    size_t queue, jobs;
    enum surfaces_by by;
    /* The number drawn of each repeat: points of each primitive, 1 ..
     * MAX_FACTORS_POINTS, or lines through the whole scene, a power of two. By lines
     * every primitive can emit. */
    bool by_lines;
    size_t drawn;
    size_t repeats; /* 2 or more */
    bool lattice;   /* else random */
    uint64_t seed;
    /* The number is increased fourfold until no factor's standard error exceeds the
     * tolerance, where the error is at least the contribution of one ray. 0: one
     * round. */
    double tolerance;
    size_t limit; /* largest number drawn, if there is a tolerance */
    bool smooth;  /* also smooth the factors (smooth.h), and use these for the
                   * exchange */
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
    struct thermal thermal;      /* if the exchange was requested */
    struct accounts accounts;    /* of all machines */
    uint64_t clocks[HEAT_STEPS]; /* the clocks of these machines, by step */
    size_t drawn, units; /* of the last round; packets, from this or other processes */
    double worst;        /* the largest error of a factor, at least that of one ray */
    size_t worst_from, worst_to; /* the factor that has it */
};

/* Prepares a computation. The arguments must outlive the heat. Returns false for a
 * scene without surfaces, for invalid names and values, or if out of memory. Call
 * heat_free in either case. */
bool heat_begin(const struct scene *scene, const struct heat_request *request,
                struct heat *heat, c205_error *error);
/* Computes everything. If the job set does not collect packets, only their number is
 * set. Returns false after a trap, if out of memory, if a file belongs to another
 * run, or for errors of factors.h, global_lines.h and thermal.h. */
bool heat_find(struct heat *heat, c205_error *error);
void heat_free(struct heat *heat);

bool heat_is_precise(const struct heat *heat);
/* Returns the name of a receiver. The last one is the environment. */
const char *heat_receiver(const struct heat *heat, size_t to);
/* Returns true if both have the same counts, and bitwise equal areas, factors and
 * flows. */
bool heat_is_same(const struct heat *one, const struct heat *other);

#endif
