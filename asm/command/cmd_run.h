/* cmd_run.h - the arguments of c205 run, and the function for c205 run --check. */
#ifndef ASM_CMD_RUN_H
#define ASM_CMD_RUN_H

#include "asm/command/session.h"

struct run_arguments {
    struct shared_arguments shared;
    struct source_arguments source;
    struct command_texts files;
    const char *save, *restore; /* file names, or NULL */
    uint64_t limit;
    bool check, trace, profile, in_order, no_limit, exit_status, warm;
};

/* Runs test programs and compares them with their expectations (run --check). Returns
 * the exit code. */
int cmd_run_check(const struct run_arguments *args);

#endif
