/* interrupt.c - catches signals, and removes incomplete files if a signal ends the
 * program.
 */
#include "base/interrupt.h"

#include <fcntl.h>

static int create(const char *path)
{
    return open(path, O_WRONLY | O_CREAT | O_EXCL, 0666);
}

/* WASI, the system interface of WebAssembly, has no signals. */
#ifdef __wasi__

void interrupt_catch(void)
{
}

void interrupt_catch_lines(bool terminal)
{
    (void)terminal;
}

bool interrupt_pending(void)
{
    return false;
}

bool interrupt_ends(void)
{
    return false;
}

void interrupt_clear(void)
{
}

int interrupt_create(const char *path)
{
    return create(path);
}

void interrupt_release(const char *path)
{
    (void)path;
}

#else

#include <signal.h>
#include <stddef.h>
#include <unistd.h>

/* ---- Files ---------------------------------------------------------------- */

/* Maximum number of files that a command writes at the same time. */
enum { FILES = 16 };
static const char *volatile files[FILES];
static volatile pid_t owner; /* the process that owns the files; a forked process must
                                not remove them */

/* Signals that come from other processes, the terminal or resource limits, and that end
 * a program by default. */
static const int endings[] = { SIGHUP,  SIGINT,  SIGQUIT, SIGPIPE, SIGALRM,
                               SIGTERM, SIGUSR1, SIGUSR2, SIGXCPU, SIGXFSZ };
enum { ENDINGS = sizeof endings / sizeof *endings };

/* Removes the files. The program ends when the handler returns, because the default
 * action is restored. */
static void end_process(int number)
{
    for (size_t i = 0; i < FILES && owner == getpid(); i++)
        if (files[i])
            unlink(files[i]);
    signal(number, SIG_DFL);
    raise(number);
}

static void catch_endings(void)
{
    struct sigaction action = { .sa_handler = end_process }, now;
    for (size_t i = 0; i < ENDINGS; i++)
        if (sigaction(endings[i], NULL, &now) == 0 && now.sa_handler == SIG_DFL)
            sigaction(endings[i], &action, NULL);
}

static void replace(const char *old, const char *path)
{
    size_t i = 0;
    while (i < FILES && files[i] != old)
        i++;
    if (i < FILES)
        files[i] = path;
}

/* Creates a file. Signals are blocked until the file is in the list. */
int interrupt_create(const char *path)
{
    sigset_t all, before;
    catch_endings();
    sigfillset(&all);
    sigprocmask(SIG_BLOCK, &all, &before);
    int file = create(path);
    if (file >= 0) {
        owner = getpid();
        replace(NULL, path);
    }
    sigprocmask(SIG_SETMASK, &before, NULL);
    return file;
}

void interrupt_release(const char *path)
{
    if (path)
        replace(path, NULL);
}

/* ---- The flag ----------------------------------------------------------- */

static volatile sig_atomic_t came; /* number of the signal that has arrived; 0: none */

/* Records the first signal. The second signal ends the program. */
static void note(int number)
{
    if (came)
        end_process(number);
    came = number;
}

/* Records the first signal and ignores later signals, which never end the program. */
static void note_again(int number)
{
    came = came ? came : number;
}

void interrupt_catch(void)
{
    struct sigaction action = { .sa_handler = note }, now;
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
    /* SIGHUP remains ignored if nohup ignored it. */
    if (sigaction(SIGHUP, NULL, &now) == 0 && now.sa_handler != SIG_IGN)
        sigaction(SIGHUP, &action, NULL);
}

void interrupt_catch_lines(bool terminal)
{
    struct sigaction action = { .sa_handler = terminal ? note_again : note,
                                .sa_flags = SA_RESTART };
    interrupt_catch();
    sigaction(SIGINT, &action, NULL);
}

bool interrupt_pending(void)
{
    return came;
}

bool interrupt_ends(void)
{
    return came && came != SIGINT;
}

void interrupt_clear(void)
{
    if (came == SIGINT)
        came = 0;
}

#endif
