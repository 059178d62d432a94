/* mass.h - the mass properties of a scene's parts and materials, and of all of them, with
 * errors that are small enough.
 */
#ifndef RT_MASS_H
#define RT_MASS_H

#include "base/diagnostic.h"
#include "rt/mass/figures.h"
#include "rt/mass/units.h"
#include "rt/scene/scene_internal.h"

enum mass_by { MASS_BY_PART, MASS_BY_MATERIAL, MASS_BYS };

struct mass_request {
    enum trace_mode mode;
    size_t queue, jobs;
    const char *const *parts; /* or materials; none: all that have an end */
    size_t part_count;
    const char *const *densities; /* NAME=VALUE */
    size_t density_count;
    const char *density_file; /* of more of them, or NULL */
    struct mass_units units;
    double about[3]; /* the point of the inertia */
    enum mass_by by; /* what is added up */
    bool overlaps;   /* are asked, too */
    enum columns_points points;
    size_t rays; /* of a view, in all shifts; made a power of two in each */
    size_t repeats;
    uint64_t seed;
    /* With four times the rays until no error is larger (mass_worst); 0: once. */
    double tolerance;
    size_t limit;            /* rays at most, if there is a tolerance */
    struct job_set *job_set; /* as in job_set_work */
    const c205_model *model;
    bool (*progress)(void *context, size_t done, size_t all);
    void *context;
};

/* A part, a material, or all of them. */
struct mass_row {
    const char *name;
    double *density; /* of each part, 0: it is none of it */
    struct mass_figures figures;
};

struct mass {
    const struct mass_request *request;
    const struct scene *scene;
    struct scene bodies; /* what is measured of it */
    struct named_parts parts;
    struct overlaps overlaps; /* of bodies, if they are asked */
    size_t row_count;
    struct mass_row *rows;
    double *weights;   /* densities of parts */
    double *densities; /* of all rows */
    size_t rays_log;   /* of a view under a shift */
    struct columns_sums sums;
    double worst; /* the largest error, beside what it is of, */
    size_t worst_row, worst_figure;
};

/* Which parts are measured, and what they weigh.  What is given must outlive the mass.  False:
 * a name that nobody has, a density that is missing or out of range, a file of them that
 * cannot be read, which the reports tell of; no memory.  Free it in either case. */
bool mass_begin(const struct scene *scene, const struct mass_request *request,
                struct mass *mass, struct diagnostics *reports, c205_error *error);
/* Where the job set does not collect packets nothing but their number is found.  False: what
 * columns_sum refuses. */
bool mass_find(struct mass *mass, c205_error *error);
void mass_free(struct mass *mass);

bool mass_is_precise(const struct mass *mass);
/* Of all views and shifts. */
size_t mass_rays(const struct mass *mass);

#endif
