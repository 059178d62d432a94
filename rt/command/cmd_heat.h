/* cmd_heat.h - shared by the files of rt205 heat. */
#ifndef RT_CMD_HEAT_H
#define RT_CMD_HEAT_H

#include "rt/command/session.h"

struct heat_arguments {
    struct trace_arguments shared;
    struct scene_arguments scene;
    struct job_arguments jobs;
    size_t rays, repeats, seed, lines; /* lines 0: use rays */
    int points;                        /* 0: lattice, 1: random */
    int by, shown;
    bool exchange, smooth, hits, stages;
    bool details;     /* also the surfaces without visible area */
    double tolerance; /* 0: none */
    size_t limit;
    const char *from;                                /* the emitter, or NULL: all */
    struct command_texts emissivities, temperatures; /* NAME=VALUE */
};

/* Runs rt205 heat --hits. Returns the exit code. */
int cmd_heat_hits(struct trace_session *session, const struct heat_arguments *args);

#endif
