/* threads.c - implements threads and locks with POSIX threads. */
#include "rt/platform/threads.h"

#include <pthread.h>
#include <stdlib.h>

struct lock {
    pthread_mutex_t mutex;
};

struct thread {
    pthread_t thread;
    void (*work)(void *context);
    void *context;
};

struct lock *lock_new(void)
{
    struct lock *lock = malloc(sizeof *lock);
    if (lock)
        pthread_mutex_init(&lock->mutex, NULL);
    return lock;
}

void lock_free(struct lock *lock)
{
    if (lock)
        pthread_mutex_destroy(&lock->mutex);
    free(lock);
}

void lock_take(struct lock *lock)
{
    pthread_mutex_lock(&lock->mutex);
}

void lock_give_back(struct lock *lock)
{
    pthread_mutex_unlock(&lock->mutex);
}

static void *run_thread(void *context)
{
    const struct thread *thread = context;
    thread->work(thread->context);
    return NULL;
}

struct thread *thread_begin(void (*work)(void *context), void *context)
{
    struct thread *thread = malloc(sizeof *thread);
    if (!thread)
        return NULL;
    thread->work = work;
    thread->context = context;
    if (pthread_create(&thread->thread, NULL, run_thread, thread) == 0)
        return thread;
    free(thread);
    return NULL;
}

void thread_end(struct thread *thread)
{
    if (thread)
        pthread_join(thread->thread, NULL);
    free(thread);
}
