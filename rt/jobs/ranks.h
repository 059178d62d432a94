/* ranks.h - processes that share a run. Their ranks are 0, 1, ..
 *
 * Rank 0 distributes units, collects results and reports. The other ranks work for it.
 * An adapter transfers the messages. The adapter is a library that is opened only if a
 * run has several ranks, because it takes long to load and need not be installed. Only
 * one thread of a process calls the adapter.
 */
#ifndef RT_RANKS_H
#define RT_RANKS_H

#include "rt/jobs/serialized_result.h"
#include "vm/c205.h"

/* The functions of the MPI adapter, which exports this structure under the name
 * RANKS_SYMBOL. */
#define RANKS_FILE "rt205_mpi.so"
#define RANKS_SYMBOL "rt205_ranks_adapter"
struct ranks_adapter {
    /* Starts the communication. Called once. Returns false if MPI cannot start. */
    bool (*begin)(size_t *rank, size_t *count);
    void (*send)(size_t to, const uint64_t *words, size_t count);
    /* Returns true if a message has arrived. Sets its sender and its number of
     * words. */
    bool (*ready)(size_t *from, size_t *count);
    void (*receive)(size_t from, uint64_t *words, size_t count);
    void (*end)(void);
};

struct ranks {
    const struct ranks_adapter *adapter;
    size_t rank, count;
    bool released; /* only on ranks other than 0: the work is over */
};

/* Returns true if the environment indicates that this process is one of several. */
bool ranks_are_many(void);
/* Opens the MPI adapter, and joins the other ranks. Returns false if the adapter is
 * missing, or if MPI cannot start. If the adapter is missing, the error names the
 * package to install. */
bool ranks_join(struct ranks *ranks, c205_error *error);
/* Ends the work. Rank 0 releases all other ranks. Another rank reports its failure, if
 * any, and waits for the release. */
void ranks_leave(struct ranks *ranks, const char *failure);

/* The first word of a message is its kind. The comments describe the words after it. */
enum rank_message {
    RANK_ASKS,   /* requests a unit */
    RANK_DOES,   /* assigns a unit: its number */
    RANK_DONE,   /* a finished unit: its number, then its words */
    RANK_FAILS,  /* a failed unit, or UINT64_MAX; then the reason, one character per
                  * word */
    RANK_ENDS,   /* the round has no more units */
    RANK_AGREES, /* a word that all ranks shall have */
    RANK_FREE,   /* the work is over */
    RANK_LEAVES
};
void ranks_send(const struct ranks *ranks, size_t to, enum rank_message message,
                uint64_t word, const struct serialized_result *more);
/* Receives a message if one has arrived, and otherwise returns false. message->at is
 * the index of its first word. */
bool ranks_receive(const struct ranks *ranks, size_t *from,
                   struct serialized_result *message);
/* Waits for the next message from rank 0. Returns its kind, and sets *word to the word
 * after the kind. */
enum rank_message ranks_await(struct ranks *ranks, uint64_t *word);
/* Reports to rank 0 the reason why a unit failed. */
void ranks_fail(const struct ranks *ranks, uint64_t unit, const char *failure);
/* The length of the next sleep. ranks_wait sleeps for 50 us at first, then twice as
 * long each time, up to 4 ms, so that a long wait polls rarely. Set the length to 0 at
 * first and after each message. */
struct ranks_pause {
    long nanoseconds;
};
void ranks_wait(struct ranks_pause *pause);

/* Sets the word on all ranks to its value on rank 0. Returns false if the work is
 * over. */
bool ranks_agree(struct ranks *ranks, uint64_t *word);

#endif
