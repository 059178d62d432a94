/* expect.h - compares a run with the expectations of its program
 * (asm/object/expectation.h).
 */
#ifndef ASM_EXPECT_H
#define ASM_EXPECT_H

#include "asm/object/expectation.h"
#include "asm/object/object.h"

/* Returns true if the program has any expectation except expect-model. */
bool expect_anything(const struct object *object);

/* Returns the first expectation of a kind, or NULL if there is none. */
const struct asm_expectation *expect_find(const struct object *object,
                                          enum expectation_kind kind);

/* Returns the model on which the expected clocks are valid, or NULL for any model. */
const char *expect_model(const struct object *object);

/* Returns true if the clocks that the program expects are those of another model. They
 * are then not compared. */
bool expect_other_model(const struct object *object, const c205 *machine);

/* Returns the warnings that the program declares as intended. */
warning_set expect_warnings(const struct object *object);

/* Compares a stopped machine with the expectations of its program. printed is the whole
 * output, warned are the warnings of the program. Each failure is a line of the report.
 * Returns true if there is no failure. */
bool expect_check(const struct object *object, const c205 *machine,
                  const c205_stop *stop, const char *printed, warning_set warned,
                  const struct sink *report);

#endif
