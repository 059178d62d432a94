/* heat_study.c - finds the surfaces of a scene and their factors from rays. */
#include "heat_study.h"

struct study study_of(const char *text, enum surfaces_by by)
{
    struct study study = { .scene = read_scene(text) };
    assert_true(named_parts_find(study.scene, &study.parts));
    assert_true(surfaces_find(study.scene, &study.parts, by, &study.surfaces));
    return study;
}

void study_find(struct study *study, const char *const *refusals, enum trace_mode mode,
                size_t points)
{
    struct sampling_options options = ON_PRIOR(.mode = mode, .queue = 2000,
                                               .points = points, .repeats = 16,
                                               .lattice = true, .seed = 1,
                                               .surface_of = study->surfaces.surface_of,
                                               .surfaces = study->surfaces.count);
    size_t count = study->scene->primitive_count;
    SCOPED(factors) *factors = NON_NULL(factors_new(study->scene, &options, &failure));
    study->rows = calloc(count + 1, sizeof *study->rows);
    for (size_t i = 0; i < count; i++)
        REQUIRE(refusals[i] || factors_find(factors, &i, 1, &study->rows[i], &failure));
    surfaces_combine(&study->surfaces, study->rows);
}

void study_free(struct study *study)
{
    for (size_t i = 0; i < study->scene->primitive_count; i++)
        factor_row_free(&study->rows[i]);
    free(study->rows);
    surfaces_free(&study->surfaces);
    named_parts_free(&study->parts);
    scene_free(study->scene);
}
