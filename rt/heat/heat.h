/* heat.h - computes the shape factors between the surfaces of a scene, by rays or by
 * lines, until their errors are small enough. Also computes the radiative exchange. */
#ifndef RT_HEAT_H
#define RT_HEAT_H

#include "rt/heat/thermal.h"

struct heat_request {
    enum trace_mode mode;
    size_t queue, jobs;
    enum surfaces_by by;
    /* `drawn` is the number of samples in each repeat. If by_lines is false, the
     * samples are points on each primitive, 1 .. MAX_FACTORS_POINTS. If by_lines is
     * true, they are lines through the scene: their number is a power of two, and every
     * primitive can emit. */
    bool by_lines;
    size_t drawn;
    size_t repeats; /* at least 2 */
    bool lattice;   /* lattice points, else random points */
    uint64_t seed;
    /* `drawn` is multiplied by four until no standard error of a factor exceeds the
     * tolerance. An error is at least the contribution of one ray. 0: only one
     * round. */
    double tolerance;
    size_t limit; /* largest value of `drawn` with a tolerance */
    bool smooth;  /* also compute smoothed factors (smooth.h), and use them for the
                   * exchange */
    bool exchange;
    const char *const *emissivities, *const *temperatures; /* texts NAME=VALUE */
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
    const char **refusals; /* reason for each primitive, as in heat_source.h */
    struct named_values emissivities, temperatures;
    struct surfaces surfaces;
    struct thermal thermal;      /* present if the exchange was requested */
    struct accounts accounts;    /* accounts of all machines */
    uint64_t clocks[HEAT_STEPS]; /* clocks of all machines for each step */
    size_t drawn, units;         /* drawn: value in the last round; units: packets of
                                    this and other processes */
    double worst; /* largest error of a factor, at least the contribution of one ray */
    size_t worst_from, worst_to; /* factor with the largest error */
};

/* Prepares a computation. The arguments must outlive `heat`. Returns false for a scene
 * without surfaces, for invalid names or values, or if out of memory. Call heat_free in
 * either case. */
bool heat_begin(const struct scene *scene, const struct heat_request *request,
                struct heat *heat, c205_error *error);
/* Computes the factors and, on request, the exchange. If this process does not collect
 * packets, only the number of packets is set. Returns false after a trap, if out of
 * memory, if a file belongs to another run, or after an error of factors.h,
 * global_lines.h or thermal.h. */
bool heat_find(struct heat *heat, c205_error *error);
void heat_free(struct heat *heat);

/* Returns true if no error exceeds the tolerance, or if there is no tolerance. */
bool heat_is_precise(const struct heat *heat);
/* Returns the name of a receiver. The last receiver is the environment. */
const char *heat_receiver(const struct heat *heat, size_t to);
/* Returns true if both computations have the same counts, and if their areas, factors
 * and flows are equal bit for bit. */
bool heat_is_same(const struct heat *one, const struct heat *other);

#endif
