/* ranks.h - processes that share a run, told apart by their rank, 0 ...
 *
 * Rank 0 hands out units, collects and tells; the others work for it.  What carries
 * messages between them is an adapter, a library that is opened only where a
 * run has several ranks, for it is long to load and need not be installed.  One
 * thread of a process, always the same, calls it.
 */
#ifndef RT_FARM_RANKS_H
#define RT_FARM_RANKS_H

#include "rt/jobs/serialized_result.h"
#include "vm/c205.h"

/* What the adapter offers, by the name RANKS_SYMBOL. */
#define RANKS_FILE "rt205_mpi.so"
#define RANKS_SYMBOL "rt205_ranks_adapter"
struct ranks_adapter {
    /* Called once; false: it has no ranks. */
    bool (*begin)(size_t *rank, size_t *count);
    void (*send)(size_t to, const uint64_t *words, size_t count);
    /* Whether a message has come: from whom, of how many words. */
    bool (*ready)(size_t *from, size_t *count);
    void (*receive)(size_t from, uint64_t *words, size_t count);
    void (*end)(void);
};

struct ranks {
    const struct ranks_adapter *adapter;
    size_t rank, count;
    bool released; /* of ranks other than 0: their work is done */
};

/* Whether this process is one of several, as the environment has it. */
bool ranks_are_many(void);
/* Join the others.  False: there is no adapter; the error says which package has it. */
bool ranks_join(struct ranks *ranks, c205_error *error);
/* Rank 0 releases all others; they tell it what failed, if something did, and wait for
 * that. */
void ranks_leave(struct ranks *ranks, const char *failure);

/* The first word of a message says what it is. */
enum rank_message {
    RANK_ASKS,   /* for a unit */
    RANK_DOES,   /* a unit: its number */
    RANK_DONE,   /* .. then its words */
    RANK_FAILS,  /* a unit, or UINT64_MAX; then why, a letter a word */
    RANK_ENDS,   /* a round: there are no more units of it */
    RANK_AGREES, /* a word that all shall have */
    RANK_FREE,   /* work is done */
    RANK_LEAVES
};
void ranks_send(const struct ranks *ranks, size_t to, enum rank_message message,
                uint64_t word, const struct serialized_result *more);
/* False: none has come.  message->at is behind the first word. */
bool ranks_receive(const struct ranks *ranks, size_t *from,
                   struct serialized_result *message);
/* What rank 0 says next, to one of the others. */
enum rank_message ranks_await(struct ranks *ranks, uint64_t *word);
/* Tell rank 0 why a unit is not done. */
void ranks_fail(const struct ranks *ranks, uint64_t unit, const char *failure);
/* A moment in which others work: 50 us, then twice as long each time up to 4 ms, so that
 * who waits long asks seldom.  Begin with { 0 }, again when a message has come. */
struct ranks_pause {
    long nanoseconds;
};
void ranks_wait(struct ranks_pause *pause);

/* Rank 0's word becomes that of all.  False: the work is done. */
bool ranks_agree(struct ranks *ranks, uint64_t *word);

#endif
