/* job_set.h - runs independent units of work in threads of this process, and in other
 * ranks (ranks.h) if there are any.
 *
 * The result of a unit is a sequence of words. Results are taken one at a time, in any
 * order. They are also stored in a checkpoint file if paths are specified
 * (checkpoint_file.h). Units that are in the file are not run again. A process may run
 * a share of the units. The shares are then merged from their files.
 */
#ifndef RT_JOB_SET_H
#define RT_JOB_SET_H

#include "rt/jobs/ranks.h"
#include "rt/jobs/checkpoint_file.h"

struct job_set {
    size_t part, parts;       /* the share is `part` of 1 .. parts; parts 0: all
                               * units */
    const char *const *paths; /* paths of the checkpoint file, and of other files that
                               * are merged into it */
    size_t path_count;
    struct ranks *ranks;          /* NULL: only this process runs units */
    struct checkpoint_file *file; /* set by job_set_open */
    size_t kept;                  /* number of units that were in the files */
};

/* Opens the files of the run with this key, and counts the units in them. On failure
 * sets the error and returns false. */
bool job_set_open(struct job_set *job_set, uint64_t key, c205_error *error);
/* Closes the files. remove_it: also removes the checkpoint file, because the results
 * have been saved elsewhere. */
void job_set_close(struct job_set *job_set, bool remove_it);
/* Returns true if this process receives the results of all units. */
bool job_set_collects(const struct job_set *job_set);
/* Sets the word on all ranks to its value on rank 0. Returns false if the work is
 * over. */
bool job_set_agree(struct job_set *job_set, uint64_t *word);
/* Returns the key of a run: a hash of the run's kind, the version, the state of a
 * machine before it runs, and further options. Returns 0 if out of memory. */
uint64_t job_set_key(const char *kind, const c205 *machine, const uint64_t *options,
                     size_t count);

struct job_set_work {
    struct job_set *job_set; /* NULL: threads of this process, without checkpoints */
    size_t count;            /* number of units */
    size_t jobs;             /* number of threads; 0: one */
    /* The file stores a unit under the number first + unit, so that one file can hold
     * the units of several rounds of a run. */
    uint64_t first;
    /* Runs a unit in the thread of the job, and writes the result to `words`. */
    bool (*run)(void *context, size_t job, size_t unit, struct serialized_result *words,
                c205_error *error);
    /* Receives the result of a unit. Calls never overlap. */
    bool (*take)(void *context, size_t unit, struct serialized_result *words,
                 c205_error *error);
    /* Called at intervals with the number of finished units. Calls never overlap. To
     * stop, sets the error and returns false. May be NULL. */
    bool (*go_on)(void *context, size_t done, c205_error *error);
    void *context;
    /* Called in the same way as go_on. If it returns false, the error states the number
     * of finished packets. May be NULL. */
    bool (*progress)(void *context, size_t done, size_t all);
    void *progress_context;
};

/* Runs all units. Returns false if a unit fails, or cannot be taken or stored. The
 * lowest such unit sets the error. If this process does not collect results
 * (job_set_collects), it takes none. */
bool job_set_run(const struct job_set_work *work, c205_error *error);

#endif
