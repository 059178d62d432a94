/* heat_study.h - computes the view factors between the surfaces of a scene by rays. */
#ifndef TESTS_HEAT_STUDY_H
#define TESTS_HEAT_STUDY_H

#include "rt/heat/surfaces.h"
#include "tests/unit/prior_model.h"
#include "tests/unit/scene_reading.h"

struct study {
    struct scene *scene;
    struct named_parts parts;
    struct surfaces surfaces;
    struct factor_row *rows;
};

/* Reads a scene and finds its surfaces. If there is an error, the test fails. */
struct study study_of(const char *text, enum surfaces_by by);
/* Finds the factors of all primitives i for which refusals[i] is NULL. */
void study_find(struct study *study, const char *const *refusals, enum trace_mode mode,
                size_t points);
void study_free(struct study *study);

#endif
