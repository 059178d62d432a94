/* threads.h - threads of this process, and locks between them.
 *
 * The only file of rt that knows the threads of the system it runs on.
 */
#ifndef RT_HOST_THREADS_H
#define RT_HOST_THREADS_H

/* What one thread at a time holds. */
struct lock;

/* NULL: there is no memory. */
struct lock *lock_new(void);
/* Nobody holds it; NULL is none. */
void lock_free(struct lock *lock);
void lock_take(struct lock *lock);
void lock_give_back(struct lock *lock);

struct thread;

/* Begin the work in a thread of its own.  NULL: none can be had, nothing is
 * begun. */
struct thread *thread_begin(void (*work)(void *context), void *context);
/* Wait until its work is done, and free it; NULL is none. */
void thread_end(struct thread *thread);

#endif
