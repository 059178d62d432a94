/* cmd_heat.h - declarations that the files of rt205 heat share. */
#ifndef RT_CMD_HEAT_H
#define RT_CMD_HEAT_H

#include "rt/command/session.h"

struct heat_arguments {
    struct trace_arguments shared;
    struct scene_arguments scene;
    struct job_arguments jobs;
    size_t rays, repeats, seed, lines; /* lines: number of lines of a repeat; 0: rays
                                        * are used */
    int points;                        /* 0: lattice, 1: random */
    int by, shown;
    bool exchange, smooth, hits, stages;
    bool details;     /* also print surfaces without visible area */
    double tolerance; /* 0: no tolerance */
    size_t limit;
    const char *from;                                /* name of the emitter; NULL: all
                                                      * surfaces */
    struct command_texts emissivities, temperatures; /* texts NAME=VALUE */
};

/* Runs rt205 heat --hits. Returns the exit code. */
int cmd_heat_hits(struct trace_session *session, const struct heat_arguments *args);

#endif
