/* test_patterns.c - every row of rt/scene/patterns.def is compared with the kernels,
 * the scene language and the plain tracer. A row with another formula fails here. */
#include "rt/layout/program.h"
#include "tests/oracle/plain_light.h"
#include "tests/unit/asm_helper.h"
#include "tests/unit/scene_reading.h"

static const char *const names[PATTERN_FUNCTIONS] = {
#define PATTERN(KIND, name, ...) #name,
#include "rt/scene/patterns.def"
};

static void check_routines(const char *kernel)
{
    static const struct asm_define defines[] = {
        { "QUEUE", 100 },
        { "PATTERNS", 1 },
        { "BUMPS", 1 },
        { NULL, 0 },
    };
    SCOPED(object) *program = NON_NULL(program_assemble(kernel, defines, &failure));
    for (size_t i = 0; i < PATTERN_FUNCTIONS; i++)
        FAIL_IF(i != PATTERN_QUILTED
                    && !object_symbol(program, pattern_rules[i].routine),
                "%s has no %s", kernel, pattern_rules[i].routine);
}

TEST(routines)
{
    check_routines("frame/frame_scalar.s");
    check_routines("frame/frame_vector.s");
}

TEST(values)
{
    for (size_t i = 0; i < PATTERN_FUNCTIONS; i++) {
        static const double point[3] = { .3, -.7, 1.1 };
        char words[40];
        snprintf(words, sizeof words, "%s%s", names[i],
                 i == PATTERN_GRADIENT ? " x" : "");
        SCOPED(scene) *scene = read_format("sphere { 0, 1 normal { %s } }", words);
        const struct pigment *pattern = &scene->primitives[0].bumps.list->bump.pattern;
        assert_int_equal(pattern->pattern.function, i);
        double value = plain_pattern(pattern, point);
        FAIL_IF(i != PATTERN_QUILTED && !(value >= 0), "the value of %s is %g",
                names[i], value);
    }
}

/* A pigment of a row with a list has as many colours as the row. */
TEST(lists)
{
    for (size_t i = 0; i < PATTERN_FUNCTIONS; i++) {
        size_t listed = pattern_rules[i].listed;
        if (listed == 0)
            continue;
        SCOPED(scene) *scene = read_format("sphere { 0, 1 pigment { %s } }", names[i]);
        const struct pigment *pigment = &scene->primitives[0].pigment;
        assert_int_equal(pigment_list_count(pigment), listed);
        for (size_t k = 0; k < listed; k++) {
            const double *color = pattern_rules[i].colors[k];
            assert_vector(pigment_listed(pigment, k).color, color[0], color[1],
                          color[2]);
        }
    }
}
