/* cmd_jobs.c - runs commands whose units of work can be shared with other
 * processes. */
#include "rt/command/rt205_command.h"

#include <ctype.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>

#include "rt/platform/processes.h"
#include "base/plural.h"

/* ---- Shares -------------------------------------------------------------- */

/* Reads a number of digits only. Returns the text after the digits, or NULL. */
static const char *read_digits(const char *text, size_t *number)
{
    char *end;

    errno = 0;
    *number = strtoul(text, &end, 10);
    return isdigit((unsigned char)*text) && errno == 0 ? end : NULL;
}

bool cmd_is_part(const char *text, struct job_set *job_set)
{
    text = read_digits(text, &job_set->part);
    if (!text || *text != '/')
        return false;
    text = read_digits(text + 1, &job_set->parts);
    return text && !*text && job_set->part > 0 && job_set->part <= job_set->parts;
}

bool cmd_take_part(char *text, void *job_set)
{
    return cmd_is_part(text, job_set);
}

int cmd_print_share(const struct rt205_arguments *arguments, size_t units)
{
    const struct job_set *job_set = &arguments->units.job_set;

    if (job_set->file)
        cmd_print_line(stderr, "%s: part %zu of %zu is done: %s has %zu of %zu unit%s",
                       arguments->command, job_set->part, job_set->parts,
                       job_set->paths[0], checkpoint_count(job_set->file), units,
                       plural(units));
    return CMD_DONE;
}

static int check_share(const struct rt205_arguments *arguments)
{
    const char *why = NULL;

    if (arguments->units.job_set.parts == 0)
        return CMD_DONE;
    if (arguments->units.resume.count == 0)
        why = "--part requires --resume FILE";
    else if (arguments->output || arguments->results.path)
        why = "--part cannot be combined with -o or --json";
    return why ? cmd_usage(arguments->command, "%s", why) : CMD_DONE;
}

/* ---- Ranks --------------------------------------------------------------- */

/* Replaces this process by mpirun, which starts that many copies of this program. */
static int begin_ranks(const struct rt205_arguments *arguments)
{
    char count[24];
    char *const words[] = {
        "mpirun", "--oversubscribe", "--bind-to", "none", "-n", count, NULL
    };

    snprintf(count, sizeof count, "%zu", arguments->units.ranks);
    /* mpirun refuses to run as root without these variables. */
    setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 1);
    setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 1);
    /* Selects communication within a machine. The search for networks of all kinds
     * would take 0.2 s first. */
    setenv("OMPI_MCA_pml", "ob1", 0);
    process_become(words);
    return cmd_failed(arguments->command, errno == ENOENT
                                              ? "mpirun is not installed; install the "
                                                "package openmpi-bin"
                                              : "cannot start mpirun");
}

/* Redirects all output of a rank other than 0. */
static void be_silent(struct rt205_arguments *arguments)
{
    arguments->output = NULL;
    arguments->results.path = NULL;
    arguments->results.format = OUTPUT_TEXT;
    if (!freopen("/dev/null", "w", stdout) || !freopen("/dev/null", "w", stderr))
        abort();
}

static int work_in_ranks(struct rt205_arguments *arguments, cmd_work *work)
{
    struct ranks *ranks = &arguments->units.joined;
    c205_error error;
    int code;

    if (arguments->trace.jobs > 1)
        return cmd_usage(arguments->command,
                         "--jobs cannot be combined with ranks: each rank runs one "
                         "unit at a time");
    if (!ranks_join(ranks, &error))
        return cmd_failed(arguments->command, "%s", error.message);
    arguments->units.job_set.ranks = ranks;
    arguments->trace.jobs = 1;
    if (ranks->rank > 0)
        be_silent(arguments);
    code = cmd_with_machine(arguments, work);
    ranks_leave(ranks, code == CMD_DONE ? NULL : "its run failed");
    return ranks->rank > 0 ? CMD_DONE : code;
}

int cmd_with_jobs(struct rt205_arguments *arguments, cmd_work *work)
{
    struct cmd_units *units = &arguments->units;
    int code = check_share(arguments);

    if (code != CMD_DONE)
        return code;
    units->job_set.paths = units->resume.items;
    units->job_set.path_count = units->resume.count;
    arguments->trace.job_set = &units->job_set;
    if (ranks_are_many())
        code = work_in_ranks(arguments, work);
    else if (units->ranks > 1)
        code = begin_ranks(arguments);
    else
        code = cmd_with_machine(arguments, work);
    job_set_close(&units->job_set, false);
    return code;
}
