/* constants.h - the constants that the fit may change. They are the rows of
 * rt/study/fit/constants.csv.
 *
 * A free constant is a group of constants of a model that change by a common factor.
 * Its place is measured in widths of its prior: 0 is the prior, and 1 is one width
 * above the prior.
 */
#ifndef RT_FIT_CONSTANTS_H
#define RT_FIT_CONSTANTS_H

#include "rt/study/fit/csv.h"
#include "vm/c205.h"

#define MAX_FREE 24
#define MAX_MEMBERS 24

struct free_constant {
    const char *name, *machine;
    char source;
    double width;       /* relative width of the prior */
    double prior;       /* prior of the first member, in its unit */
    double least, most; /* bounds of the first member, in its unit */
    const char *unit;
    size_t member_count;
    struct {
        char name[32];
        double prior;
    } members[MAX_MEMBERS];
};

enum { FREE_MACHINES = 3 };

struct constants {
    size_t count;
    struct free_constant items[MAX_FREE];
    struct csv file;
    c205_model *priors[FREE_MACHINES];
};

/* Reads the free constants of a file. Built-in models contain the priors. On failure
 * reports diagnostics and returns false. */
bool constants_read(struct constants *constants, const char *path,
                    struct diagnostics *diagnostics);
void constants_free(struct constants *constants);

/* Returns the model that contains a machine's priors, or NULL. */
const c205_model *constants_prior(const struct constants *constants,
                                  const char *machine);

/* A constant's place is its distance from its prior, in widths of the prior.
 * constant_value returns the value of the first member at a place. constant_place
 * returns the place at which the first member has a value. */
double constant_value(const struct free_constant *constant, double place);
double constant_place(const struct free_constant *constant, double value);
/* Returns true if a model is this machine or a variant of it. The name of a variant,
 * such as "cyber205-2pipe", begins with the machine's name. */
bool model_is_of(const c205_model *model, const char *machine, size_t length);
/* Returns true if the constant belongs to this model. */
bool constant_is_of(const struct free_constant *constant, const c205_model *model);

/* constants_settings lists the settings that give the free constants of a model their
 * values at these places (constant_value), and returns the number of settings. */
enum { MAX_SETTINGS = MAX_FREE * MAX_MEMBERS };
size_t constants_settings(const struct constants *constants, const double *places,
                          const c205_model *model, c205_setting settings[MAX_SETTINGS]);

#endif
