/* threads.h - threads of this process, and locks.
 *
 * No other file of rt uses the system's threads.
 */
#ifndef RT_HOST_THREADS_H
#define RT_HOST_THREADS_H

/* A lock, which one thread at a time can hold. */
struct lock;

/* Returns a new lock, or NULL if out of memory. */
struct lock *lock_new(void);
/* Frees a lock that no thread holds. NULL is ignored. */
void lock_free(struct lock *lock);
void lock_take(struct lock *lock);
void lock_give_back(struct lock *lock);

struct thread;

/* Runs the work in a new thread. If no thread can be started, returns NULL, and the
 * work is not run. */
struct thread *thread_begin(void (*work)(void *context), void *context);
/* Waits until the thread's work is done, and frees the thread. NULL is ignored. */
void thread_end(struct thread *thread);

#endif
