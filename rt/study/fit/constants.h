/* constants.h - what the fit may move: rows of rt/study/fit/constants.csv.
 *
 * A free constant is a group of a model's constants that move together, by
 * one factor.  Its place is told in widths of its prior: 0 is the prior, 1 one
 * width more.
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
    double width;       /* of the prior, relative */
    double prior;       /* of the first member, in its unit */
    double least, most; /* likewise */
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

/* The priors are those of built-in models.  False: the error says why. */
bool constants_read(struct constants *constants, const char *path,
                    struct diagnostics *diagnostics);
void constants_free(struct constants *constants);

/* The model of a machine's priors; NULL: there is none. */
const c205_model *constants_prior(const struct constants *constants,
                                  const char *machine);

/* The first member's value at a place, and the other way round. */
double constant_value(const struct free_constant *constant, double place);
double constant_place(const struct free_constant *constant, double value);
/* Whether a model is a machine's, or of one like it: the name of such a model,
 * "cyber205-2pipe", begins with the machine's. */
bool model_is_of(const c205_model *model, const char *machine, size_t length);
/* Whether it is one of this model's. */
bool constant_is_of(const struct free_constant *constant, const c205_model *model);

/* What the places of all set in a model; gives their number. */
enum { MAX_SETTINGS = MAX_FREE * MAX_MEMBERS };
size_t constants_settings(const struct constants *constants, const double *places,
                          const c205_model *model, c205_setting settings[MAX_SETTINGS]);

#endif
