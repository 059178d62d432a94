/* mass.h - computes the mass properties of a scene's parts and materials, until their
 * errors are small enough. Also computes the mass properties of all parts together. */
#ifndef RT_MASS_H
#define RT_MASS_H

#include "base/diagnostic.h"
#include "rt/mass/figures.h"
#include "rt/mass/units.h"
#include "rt/scene/named_parts.h"

enum mass_by { MASS_BY_PART, MASS_BY_MATERIAL, MASS_BYS };

struct mass_request {
    enum trace_mode mode;
    size_t queue, jobs;
    const char *const *parts; /* names of parts or materials; if there are none, all
                               * bounded parts are measured */
    size_t part_count;
    const char *const *densities; /* texts NAME=VALUE */
    size_t density_count;
    const char *density_file; /* a file with more densities, or NULL */
    struct mass_units units;
    double about[3]; /* reference point of the inertia */
    enum mass_by by; /* the subject of a row */
    bool overlaps;   /* also compute overlaps */
    enum columns_points points;
    size_t rays; /* number of rays of a view for all shifts; rounded to a power of two
                  * for each shift */
    size_t repeats;
    uint64_t seed;
    /* The number of rays is multiplied by four until no error exceeds the tolerance
     * (mass_worst). 0: only one round. */
    double tolerance;
    size_t limit;            /* largest number of rays with a tolerance */
    struct job_set *job_set; /* as in job_set_work */
    const c205_model *model;
    bool (*progress)(void *context, size_t done, size_t all);
    void *context;
};

/* The mass properties of a part, of a material, or of all parts together. */
struct mass_row {
    const char *name;
    double *density; /* density of each part; 0: the part is not in the row */
    struct mass_figures figures;
};

struct mass {
    const struct mass_request *request;
    const struct scene *scene;
    struct scene bodies; /* the measured parts of the scene */
    struct named_parts parts;
    struct overlaps overlaps; /* overlaps of the bodies, if requested */
    size_t row_count;
    struct mass_row *rows;
    double *weights;   /* density of each part */
    double *densities; /* densities of all rows */
    size_t rays_log;   /* a view has 2^rays_log rays for each shift */
    struct columns_sums sums;
    double worst; /* largest relative error, and its row and figure */
    size_t worst_row, worst_figure;
};

/* Selects the parts to measure, and sets their densities. The arguments must outlive
 * `mass`. Returns false for an unknown name, for a density that is missing or out of
 * range, if the file of densities cannot be read (the reports give the reason), or if
 * out of memory. Call mass_free in either case. */
bool mass_begin(const struct scene *scene, const struct mass_request *request,
                struct mass *mass, struct diagnostics *reports, c205_error *error);
/* Computes the mass properties of all rows. If the job set does not collect packets,
 * only the number of packets is set. Returns false after an error of columns_sum. */
bool mass_find(struct mass *mass, c205_error *error);
void mass_free(struct mass *mass);

/* Returns true if no error exceeds the tolerance, or if there is no tolerance. */
bool mass_is_precise(const struct mass *mass);
/* Returns the number of rays of all views and shifts. */
size_t mass_rays(const struct mass *mass);

#endif
