/* saved_machine.h - machines from programs, saved, restored and compared. */
#ifndef TESTS_SAVED_MACHINE_H
#define TESTS_SAVED_MACHINE_H

#include "tests/oracle/random_program.h"
#include "tests/unit/asm_helper.h"

struct bytes {
    size_t count, room; /* room 0: it grows */
    unsigned char *byte;
    size_t reserved;
};

bool append(void *context, const void *more, size_t count);
struct bytes save(const c205 *machine);
c205 *restore(const struct bytes *bytes, const c205_model *model);

/* All that a machine is, is saved: two with the same bytes are the same. */
void assert_same(const c205 *a, const c205 *b);

/* The machine in another one's place. */
c205 *replace(c205 *machine);
void assert_same_stop(const c205_stop *a, const c205_stop *b);
c205 *machine_with(const c205_program *program, const c205_model *model);
c205 *machine_from(const char *path, const c205_model *model);

/* The model of a random program, and a machine with the program. */
c205_model *model_of(const struct random_program *program);
c205 *machine_of(const struct random_program *program, const c205_model *model);

#endif
