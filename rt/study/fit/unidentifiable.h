/* unidentifiable.h - the constants of the models on which no fitted observation
 * depends: of them the fit can tell nothing, whatever it makes of those with
 * which they move.
 */
#ifndef RT_FIT_UNIDENTIFIABLE_H
#define RT_FIT_UNIDENTIFIABLE_H

#include "rt/study/fit/fit.h"

enum { MAX_UNTOUCHED = 128 };

struct untouched {
    const char *machine;
    const c205_constant *constant;
    const struct free_constant *moved_by; /* with others; NULL: it stays */
};

struct untouched_list {
    size_t count;
    struct untouched items[MAX_UNTOUCHED];
};

/* Constants of the machines that have free ones which change no time that is
 * fitted by a hundredth when they are doubled, halved or divided by eight, as
 * far as they can be.  False: the error says why. */
bool untouched_find(const struct fit *fit, const struct fit_change *change,
                    struct untouched_list *untouched, c205_error *error);

#endif
