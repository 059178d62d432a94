/* threads.c - threads in the page. There is one thread, so locks do nothing. */
#include "rt/platform/threads.h"

#include <stdlib.h>

struct lock {
    char none;
};

struct lock *lock_new(void)
{
    return malloc(sizeof(struct lock));
}

void lock_free(struct lock *lock)
{
    free(lock);
}

void lock_take(struct lock *lock)
{
    (void)lock;
}

void lock_give_back(struct lock *lock)
{
    (void)lock;
}

struct thread *thread_begin(void (*work)(void *context), void *context)
{
    (void)work, (void)context;
    return NULL;
}

void thread_end(struct thread *thread)
{
    (void)thread;
}
