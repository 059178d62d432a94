/* saved_programs.c - caches the assembled kernels of a test program.
 *
 * A program depends only on the kernel and the constants, and a test of many scenes
 * repeatedly assembles the same few programs. The linker redirects calls of
 * program_assemble and object_free to this file (--wrap in the Makefile). If the cache
 * is full, the least recently used program without a user is freed.
 */
#include "rt/layout/program.h"

#include <pthread.h>
#include <stdio.h>
#include <string.h>

struct object *__real_program_assemble(const char *kernel,
                                       const struct asm_define *defines,
                                       c205_error *error);
struct object *__wrap_program_assemble(const char *kernel,
                                       const struct asm_define *defines,
                                       c205_error *error);
void __real_object_free(struct object *object);
void __wrap_object_free(struct object *object);

enum { KEPT = 32, ASKED_ROOM = 2000 };

static struct kept {
    char asked[ASKED_ROOM]; /* key: the kernel and the constants */
    struct object *object;  /* NULL: the slot is free */
    size_t users;
    unsigned long used; /* time of the last request */
} all_kept[KEPT];
static unsigned long now;
static pthread_mutex_t one_at_a_time = PTHREAD_MUTEX_INITIALIZER;

/* Writes the key. Returns false if it is too long. */
static bool write_asked(const char *kernel, const struct asm_define *defines,
                        char asked[ASKED_ROOM])
{
    size_t n = (size_t)snprintf(asked, ASKED_ROOM, "%s", kernel);
    for (; defines && defines->name && n < ASKED_ROOM; defines++)
        n += (size_t)snprintf(asked + n, ASKED_ROOM - n, " %s=%lld", defines->name,
                              (long long)defines->value);
    return n < ASKED_ROOM;
}

static struct kept *find(const char *asked)
{
    for (size_t i = 0; i < KEPT; i++)
        if (all_kept[i].object && !strcmp(all_kept[i].asked, asked))
            return &all_kept[i];
    return NULL;
}

/* Returns a slot to reuse, or NULL if all slots are in use. */
static struct kept *make_room(void)
{
    struct kept *oldest = NULL;
    for (size_t i = 0; i < KEPT; i++)
        if (all_kept[i].users == 0 && (!oldest || all_kept[i].used < oldest->used))
            oldest = &all_kept[i];
    if (oldest && oldest->object)
        __real_object_free(oldest->object);
    if (oldest)
        *oldest = (struct kept){ .object = NULL };
    return oldest;
}

/* Returns a cached program with another user, or NULL. */
static struct object *reuse(const char *asked)
{
    pthread_mutex_lock(&one_at_a_time);
    struct kept *kept = find(asked);
    if (kept) {
        kept->users++;
        kept->used = ++now;
    }
    pthread_mutex_unlock(&one_at_a_time);
    return kept ? kept->object : NULL;
}

/* Caches a program with its first user, if there is room. */
static void cache(const char *asked, struct object *object)
{
    pthread_mutex_lock(&one_at_a_time);
    struct kept *kept = make_room();
    if (kept) {
        strcpy(kept->asked, asked);
        kept->object = object;
        kept->users = 1;
        kept->used = ++now;
    }
    pthread_mutex_unlock(&one_at_a_time);
}

/* The lock is not held during assembly, because a program with an error is freed there. */
struct object *__wrap_program_assemble(const char *kernel,
                                       const struct asm_define *defines,
                                       c205_error *error)
{
    char asked[ASKED_ROOM];
    bool is_cached = write_asked(kernel, defines, asked);
    struct object *object = is_cached ? reuse(asked) : NULL;
    if (object)
        return object;
    object = __real_program_assemble(kernel, defines, error);
    if (object && is_cached)
        cache(asked, object);
    return object;
}

static bool give_back(const struct object *object)
{
    for (size_t i = 0; object && i < KEPT; i++)
        if (all_kept[i].object == object) {
            all_kept[i].users--;
            return true;
        }
    return false;
}

void __wrap_object_free(struct object *object)
{
    pthread_mutex_lock(&one_at_a_time);
    bool kept = give_back(object);
    pthread_mutex_unlock(&one_at_a_time);
    if (!kept)
        __real_object_free(object);
}
