/* job_set.h - units of work that do not depend on one another, done by threads of this
 * process, and by other ranks (ranks.h) if there are any.
 *
 * What a unit comes to is a row of words.  Those that are done are taken one at a time in
 * any order, and kept in a file if one is named (checkpoint_file.h); those that this
 * file has are not done again.  A process may do a share of them: those of all shares come
 * together from their files.
 */
#ifndef RT_FARM_H
#define RT_FARM_H

#include "rt/jobs/ranks.h"
#include "rt/jobs/checkpoint_file.h"

struct job_set {
    size_t part, parts;       /* 1 .. parts; parts 0: all units are done */
    const char *const *paths; /* of the file, then of others to take from */
    size_t path_count;
    struct ranks *ranks;          /* NULL: this process is alone */
    struct checkpoint_file *file; /* once it is kept */
    size_t kept;                  /* units that the files had */
};

/* Open the files: of the run of that key. */
bool job_set_open(struct job_set *job_set, uint64_t key, c205_error *error);
/* Close them; all is safe elsewhere: remove that of this run. */
void job_set_close(struct job_set *job_set, bool remove_it);
/* Whether this process gets all that the units come to. */
bool job_set_collects(const struct job_set *job_set);
/* The first rank's word becomes that of all.  False: there is no more work for others. */
bool job_set_agree(struct job_set *job_set, uint64_t *word);
/* What the units of a run depend on: its kind, this version, all of the state that a machine
 * has before it begins, and options besides.  0: no memory. */
uint64_t job_set_key(const char *kind, const c205 *machine, const uint64_t *options,
                     size_t count);

struct job_set_work {
    struct job_set *job_set; /* NULL: threads of this process, and nothing is kept */
    size_t count;            /* of units, 0 .. */
    size_t jobs;             /* threads; 0: one */
    /* Numbers in the file are first + unit, for a file may have several works. */
    uint64_t first;
    /* In the thread of that job: what the unit comes to. */
    bool (*run)(void *context, size_t job, size_t unit, struct serialized_result *words,
                c205_error *error);
    /* One at a time. */
    bool (*take)(void *context, size_t unit, struct serialized_result *words,
                 c205_error *error);
    /* Asked now and then, never twice at a time, with so many units done; false: stop,
     * the error says why.  NULL: go on. */
    bool (*go_on)(void *context, size_t done, c205_error *error);
    void *context;
    /* Asked as go_on is; where that says no the error tells after how many packets.
     * NULL: nobody wants to know. */
    bool (*progress)(void *context, size_t done, size_t all);
    void *progress_context;
};

/* False: a unit failed, or cannot be taken or kept; the error is that of the lowest.
 * Where this process does not collect them (job_set_collects), nothing is taken. */
bool job_set_run(const struct job_set_work *work, c205_error *error);

#endif
