/* unidentifiable.h - finds the constants of models that affect no fitted observation.
 * The fit cannot determine them, even in combination with other constants. */
#ifndef RT_FIT_UNIDENTIFIABLE_H
#define RT_FIT_UNIDENTIFIABLE_H

#include "rt/study/fit/fit.h"

enum { MAX_UNTOUCHED = 128 };

struct unidentifiable {
    const char *machine;
    const c205_constant *constant;
    const struct free_constant *moved_by; /* the group with which it changes; NULL: it
                                           * does not change */
};

struct unidentifiable_list {
    size_t count;
    struct unidentifiable items[MAX_UNTOUCHED];
};

/* For each machine with a free constant, lists the constants that the fitted times do
 * not determine. No fitted time changes by 1 % or more when such a constant is doubled,
 * halved or divided by eight. A value that the model rejects counts as no change. On
 * failure sets the error and returns false. */
bool unidentifiable_find(const struct fit *fit, const struct fit_change *change,
                         struct unidentifiable_list *unidentifiable, c205_error *error);

#endif
