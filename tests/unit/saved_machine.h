/* saved_machine.h - saves, restores and compares machines with programs. */
#ifndef TESTS_SAVED_MACHINE_H
#define TESTS_SAVED_MACHINE_H

#include "tests/oracle/random_program.h"
#include "tests/unit/asm_helper.h"

struct bytes {
    size_t count, room; /* capacity limit; 0: the buffer grows */
    unsigned char *byte;
    size_t reserved;
};

void bytes_free(struct bytes *bytes);
bool append(void *context, const void *more, size_t count);
struct bytes save(const c205 *machine);
c205 *restore(const struct bytes *bytes, const c205_model *model);

/* Fails unless both machines save the same bytes, which are their whole state. */
void assert_same(const c205 *a, const c205 *b);

/* Saves a machine, restores it to a new machine, compares both, and frees the old
 * machine. Returns the new machine. */
c205 *replace(c205 *machine);
void assert_same_stop(const c205_stop *a, const c205_stop *b);
c205 *machine_with(const c205_program *program, const c205_model *model);
c205 *machine_from(const char *path, const c205_model *model);

/* Return the model of a random program, and a machine that has loaded it. */
c205_model *model_of(const struct random_program *program);
c205 *machine_of(const struct random_program *program, const c205_model *model);

#endif
