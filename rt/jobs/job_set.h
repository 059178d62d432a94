/* job_set.h - runs independent units of work in threads of this process, and in other
 * ranks (ranks.h) if there are any.
 *
 * The result of a unit is a row of words. Results are taken one at a time, in any
 * order, and stored in a checkpoint file if one is named (checkpoint_file.h).
 * Units that the file already has are not run again. A process may run a share of
 * the units; the shares are then merged from their files.
 */
#ifndef RT_FARM_H
#define RT_FARM_H

#include "rt/jobs/ranks.h"
#include "rt/jobs/checkpoint_file.h"

struct job_set {
    size_t part, parts;       /* the share is part 1 .. parts; parts 0: all units */
    const char *const *paths; /* the checkpoint file, then other files to merge */
    size_t path_count;
    struct ranks *ranks;          /* NULL: only this process */
    struct checkpoint_file *file; /* set by job_set_open */
    size_t kept;                  /* number of units that the files had */
};

/* Opens the files of the run with this key. */
bool job_set_open(struct job_set *job_set, uint64_t key, c205_error *error);
/* Closes the files. remove_it: also removes the checkpoint file, since the results
 * are saved elsewhere. */
void job_set_close(struct job_set *job_set, bool remove_it);
/* Returns true if this process receives the results of all units. */
bool job_set_collects(const struct job_set *job_set);
/* Sets the word of all ranks to that of rank 0. Returns false if the work is over. */
bool job_set_agree(struct job_set *job_set, uint64_t *word);
/* Returns the key of a run: a hash of its kind, the version, the state of a
 * machine before it runs, and further options. 0: no memory. */
uint64_t job_set_key(const char *kind, const c205 *machine, const uint64_t *options,
                     size_t count);

struct job_set_work {
    struct job_set *job_set; /* NULL: threads of this process, without checkpoints */
    size_t count;            /* of units, from 0 */
    size_t jobs;             /* threads; 0: one */
    /* Units have the number first + unit in the file, so a file may hold several
     * works. */
    uint64_t first;
    /* Runs a unit in the thread of the job and writes its result to the words. */
    bool (*run)(void *context, size_t job, size_t unit, struct serialized_result *words,
                c205_error *error);
    /* Takes a result. Calls never overlap. */
    bool (*take)(void *context, size_t unit, struct serialized_result *words,
                 c205_error *error);
    /* Called at intervals with the number of units done; calls never overlap. Returns
     * false, with an error, to stop. May be NULL. */
    bool (*go_on)(void *context, size_t done, c205_error *error);
    void *context;
    /* Called in the same way as go_on. If it returns false, the error has the number
     * of packets. May be NULL. */
    bool (*progress)(void *context, size_t done, size_t all);
    void *progress_context;
};

/* Runs all units. Returns false if a unit fails, or cannot be taken or stored; the
 * error is that of the lowest unit. If this process does not collect results
 * (job_set_collects), none are taken. */
bool job_set_run(const struct job_set_work *work, c205_error *error);

#endif
