#include "base/interrupt.h"

#include <fcntl.h>

static int create(const char *path)
{
    return open(path, O_WRONLY | O_CREAT | O_EXCL, 0666);
}

/* WebAssembly's system interface has no signals. */
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

/* A command writes a few files at a time. */
enum { FILES = 16 };
static const char *volatile files[FILES];
static volatile pid_t owner; /* a forked process owns none of them */

/* All that end a program unless it catches them. */
static const int endings[] = { SIGHUP,  SIGINT,  SIGQUIT, SIGPIPE, SIGALRM,
                               SIGTERM, SIGUSR1, SIGUSR2, SIGXCPU, SIGXFSZ };
enum { ENDINGS = sizeof endings / sizeof *endings };

/* When the handler returns the program ends, as without a handler. */
static void end(int number)
{
    for (size_t i = 0; i < FILES && owner == getpid(); i++) {
        if (files[i]) {
            unlink(files[i]);
        }
    }
    signal(number, SIG_DFL);
    raise(number);
}

static void catch_endings(void)
{
    struct sigaction action = { .sa_handler = end }, now;
    for (size_t i = 0; i < ENDINGS; i++) {
        if (sigaction(endings[i], NULL, &now) == 0 && now.sa_handler == SIG_DFL) {
            sigaction(endings[i], &action, NULL);
        }
    }
}

static void replace(const char *old, const char *path)
{
    size_t i = 0;
    while (i < FILES && files[i] != old) {
        i++;
    }
    if (i < FILES) {
        files[i] = path;
    }
}

/* No signal comes between the file and its entry. */
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
    if (path) {
        replace(path, NULL);
    }
}

/* ---- A question ------------------------------------------------------------ */

static volatile sig_atomic_t came; /* the signal's number */

/* The second time it is as if nobody had asked for the first. */
static void note(int number)
{
    if (came) {
        end(number);
    }
    came = number;
}

/* Any number of times. */
static void note_again(int number)
{
    came = came ? came : number;
}

void interrupt_catch(void)
{
    struct sigaction action = { .sa_handler = note }, now;
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
    /* nohup has it ignored. */
    if (sigaction(SIGHUP, NULL, &now) == 0 && now.sa_handler != SIG_IGN) {
        sigaction(SIGHUP, &action, NULL);
    }
}

void interrupt_catch_lines(bool terminal)
{
    struct sigaction action = { .sa_handler = terminal ? note_again : note,
                                .sa_flags = terminal ? 0 : SA_RESTART };
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
    if (came == SIGINT) {
        came = 0;
    }
}

#endif
