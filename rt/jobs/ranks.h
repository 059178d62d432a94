/* ranks.h - processes that share a run, identified by their ranks 0, 1, ..
 *
 * Rank 0 distributes units, collects results and reports; the other ranks work for
 * it. Messages are carried by an adapter, a library that is opened only if a run
 * has several ranks, because it takes long to load and need not be installed. Only
 * one thread of a process, always the same, calls it.
 */
#ifndef RT_FARM_RANKS_H
#define RT_FARM_RANKS_H

#include "rt/jobs/serialized_result.h"
#include "vm/c205.h"

/* The functions of the adapter, which exports them under the name RANKS_SYMBOL. */
#define RANKS_FILE "rt205_mpi.so"
#define RANKS_SYMBOL "rt205_ranks_adapter"
struct ranks_adapter {
    /* Called once. Returns false if there are no ranks. */
    bool (*begin)(size_t *rank, size_t *count);
    void (*send)(size_t to, const uint64_t *words, size_t count);
    /* Returns true if a message has arrived, with its sender and its number of
     * words. */
    bool (*ready)(size_t *from, size_t *count);
    void (*receive)(size_t from, uint64_t *words, size_t count);
    void (*end)(void);
};

struct ranks {
    const struct ranks_adapter *adapter;
    size_t rank, count;
    bool released; /* for ranks other than 0: the work is over */
};

/* Returns true if this process is one of several, according to the environment. */
bool ranks_are_many(void);
/* Joins the other ranks. Returns false if there is no adapter; the error names the
 * package that has it. */
bool ranks_join(struct ranks *ranks, c205_error *error);
/* Ends the work. Rank 0 releases all other ranks. They report a failure, if any,
 * and wait for the release. */
void ranks_leave(struct ranks *ranks, const char *failure);

/* The first word of a message is its kind. The second word is given here; more
 * words may follow. */
enum rank_message {
    RANK_ASKS,   /* requests a unit */
    RANK_DOES,   /* assigns a unit: its number */
    RANK_DONE,   /* a finished unit: its number, then its words */
    RANK_FAILS,  /* a failed unit, or UINT64_MAX; then the reason, one letter per
                  * word */
    RANK_ENDS,   /* a round: there are no more units in it */
    RANK_AGREES, /* a word for all ranks */
    RANK_FREE,   /* the work is over */
    RANK_LEAVES
};
void ranks_send(const struct ranks *ranks, size_t to, enum rank_message message,
                uint64_t word, const struct serialized_result *more);
/* Receives a message, if one has arrived. message->at is at the first word. */
bool ranks_receive(const struct ranks *ranks, size_t *from,
                   struct serialized_result *message);
/* Returns the next message of rank 0 to another rank. */
enum rank_message ranks_await(struct ranks *ranks, uint64_t *word);
/* Reports to rank 0 why a unit failed. */
void ranks_fail(const struct ranks *ranks, uint64_t unit, const char *failure);
/* Sleeps for 50 us, then twice as long each time up to 4 ms, so that long waits
 * poll rarely. Start with { 0 }, and again after each message. */
struct ranks_pause {
    long nanoseconds;
};
void ranks_wait(struct ranks_pause *pause);

/* Sets the word of all ranks to that of rank 0. Returns false if the work is over. */
bool ranks_agree(struct ranks *ranks, uint64_t *word);

#endif
