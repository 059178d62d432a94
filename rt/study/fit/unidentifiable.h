/* unidentifiable.h - finds the constants of the models on which no fitted
 * observation depends. The fit cannot determine them, even if they change together
 * with others. */
#ifndef RT_FIT_UNIDENTIFIABLE_H
#define RT_FIT_UNIDENTIFIABLE_H

#include "rt/study/fit/fit.h"

enum { MAX_UNTOUCHED = 128 };

struct unidentifiable {
    const char *machine;
    const c205_constant *constant;
    const struct free_constant *moved_by; /* the group that it changes with; NULL: it
                                           * does not change */
};

struct unidentifiable_list {
    size_t count;
    struct unidentifiable items[MAX_UNTOUCHED];
};

/* Lists constants of the machines with free constants. A constant is listed if no
 * fitted time changes by a hundredth when it is doubled, halved or divided by
 * eight, as far as the model permits. Returns false with the reason in the error. */
bool unidentifiable_find(const struct fit *fit, const struct fit_change *change,
                         struct unidentifiable_list *unidentifiable, c205_error *error);

#endif
