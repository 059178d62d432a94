/* model_parts.h - the internal structure of a machine model, for the files that parse,
 * find and change models.
 */
#ifndef C205_MODEL_PARTS_H
#define C205_MODEL_PARTS_H

#include "vm/time/model.h"

enum constant_kind { WHOLE, DECIMAL, RATE, PAGE };

/* The constraints on a constant of a machine model. */
struct rule {
    const char *name;
    enum constant_kind kind;
    const char *unit;
    uint64_t least, most;
};

struct c205_model {
    char *name;
    char *text;             /* split into the strings of the constants */
    const c205_model *like; /* the model whose constants it inherits, or NULL */
    c205_model *own;        /* like, if this model must free it; otherwise NULL */
    const char *title;
    c205_belief fitted, compared;
    const struct rule *rules; /* a rule for each constant */
    size_t count;             /* number of rules */
    uint64_t ticks;           /* ticks per clock; times are in ticks */
    struct {
        c205_constant shown;
        uint64_t millionths;
        unsigned line; /* line of this text; 0: inherited */
    } constant[CONSTANTS];
};

bool model_find_rule(const c205_model *model, const char *name, size_t *index);
/* model_check_whole checks that the value of a constant is an integer if the rule has
 * the kind WHOLE. model_check_range checks that the value is in the range of the rule.
 * Otherwise they set an error that contains the text of the value, and return false. */
bool model_check_whole(const struct rule *rule, const char *text, uint64_t millionths,
                       c205_error *error);
bool model_check_range(const struct rule *rule, const char *text, uint64_t millionths,
                       c205_error *error);
/* Checks the constraints that relate two constants of a model. */
bool model_check_together(const c205_model *model, c205_error *error);

/* Sets the error "out of memory" and returns NULL. */
void *model_out_of_memory(c205_error *error);

#endif
