/* model_parts.h - the inside of a machine model, for what reads, finds and
 * changes one.
 */
#ifndef C205_MODEL_PARTS_H
#define C205_MODEL_PARTS_H

#include "vm/time/model.h"

enum constant_kind { WHOLE, DECIMAL, RATE, PAGE };

/* What a constant may be. */
struct rule {
    const char *name;
    enum constant_kind kind;
    const char *unit;
    uint64_t least, most;
};

struct c205_model {
    char *name;
    char *text;             /* cut into the strings that the constants point to */
    const c205_model *like; /* whose constants it took over, or NULL .. */
    c205_model *own;        /* .. the same, if it goes with this model */
    const char *title;
    c205_belief fitted, compared;
    const struct rule *rules; /* that hold for it .. */
    size_t count;             /* .. so many */
    uint64_t ticks;           /* in which its times count, of a clock */
    struct {
        c205_constant shown;
        uint64_t millionths;
        unsigned line; /* where this text gives it; 0: it does not */
    } constant[CONSTANTS];
};

bool model_find_rule(const c205_model *model, const char *name, size_t *index);
/* Whether a constant may have this value, given as text for the message;
 * whether it is whole where it must be, and whether it lies in range. */
bool model_check_whole(const struct rule *rule, const char *text, uint64_t millionths,
                       c205_error *error);
bool model_check_range(const struct rule *rule, const char *text, uint64_t millionths,
                       c205_error *error);
/* What two constants must be to each other. */
bool model_check_together(const c205_model *model, c205_error *error);

/* NULL, with the message. */
void *model_out_of_memory(c205_error *error);

#endif
