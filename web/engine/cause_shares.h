/* cause_shares.h - sums the clocks of a range by cause, in columns of a picture. */
#ifndef WEB_ENGINE_CAUSE_SHARES_H
#define WEB_ENGINE_CAUSE_SHARES_H

#include "base/json.h"
#include "vm/c205.h"

enum { MAX_COLUMNS = 4096 };

struct cause_shares {
    uint64_t from, to; /* the range in clocks */
    size_t columns;    /* number of columns of equal length */
    uint64_t *clocks;  /* of each column and cause */
};

/* Returns NULL if memory is exhausted. `columns` is at most MAX_COLUMNS, and the range
 * is at least as long. */
struct cause_shares *cause_shares_new(uint64_t from, uint64_t to, size_t columns);
void cause_shares_free(struct cause_shares *shares);
/* Adds the pieces of an instruction. */
void cause_shares_add(struct cause_shares *shares, const c205_event *event);
/* Writes the causes that have clocks: cause, clocks (for each column). */
void cause_shares_put(const struct cause_shares *shares, struct json *reply);

#endif
