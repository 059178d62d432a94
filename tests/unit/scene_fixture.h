/* scene_fixture.h - scenes in a machine's memory, of which tests read fields of records
 * by name. */
#ifndef TESTS_SCENE_FIXTURE_H
#define TESTS_SCENE_FIXTURE_H

#include "tests/unit/prior_model.h"
#include "tests/unit/scene_reading.h"

#include "rt/layout/bounding.h"
#include "rt/layout/program.h"

struct stage {
    struct scene_layout *layout;
    struct scene *scene;
    struct object *program;
    c205 *machine;
};

struct stage stage_of(const char *text, enum bounding bounding);
void stage_free(struct stage *stage);
uint64_t symbol(const struct stage *stage, const char *name);
c205_word stage_word(const struct stage *stage, uint64_t address);
c205_word scene_word(const struct stage *stage, const char *name);

/* Returns a field of record i in the array that begins at `first`. */
c205_word field_of(const struct stage *stage, uint64_t first, const char *size,
                   size_t i, const char *name);
c205_word primitive(const struct stage *stage, size_t i, const char *name);
c205_word region(const struct stage *stage, size_t i, const char *name);
uint64_t primitive_at(const struct stage *stage, size_t i);
void assert_integer(c205_word word, int64_t expected);
void assert_number(c205_word word, double expected);
void check_numbers(const struct stage *stage, size_t i, const char *name,
                   const double *expected, size_t count);

#endif
