/* processes.c - processes in the page. No process can be started, so no other process
 * locks a file.
 */
#include "rt/platform/processes.h"

#include <errno.h>

int process_run(const char *folder, char *const words[], FILE *output, size_t *written,
                FILE **messages)
{
    (void)folder, (void)words, (void)output, (void)written, (void)messages;
    errno = ENOSYS;
    return -1;
}

void process_become(char *const words[])
{
    (void)words;
    errno = ENOENT;
}

bool process_lock(int file, bool alone)
{
    (void)file, (void)alone;
    return true;
}

bool process_lock_is_held(void)
{
    return false;
}
