/* test_formulas.c - random functions that a scene declares are compared with their
 * bodies as expressions of the scene, bit for bit. A wrong operator, precedence or
 * parameter, or the effect of a later declaration, fails here. */
#include "tests/random.h"
#include "tests/unit/scene_reading.h"

/* Writes an expression of floats that is defined for all values. */
static void put_formula(FILE *text, uint64_t *random, int depth)
{
    static const char *const forms[] = { "#",
                                         "(# + #)",
                                         "(# - #)",
                                         "(# * #)",
                                         "# * #",
                                         "-#",
                                         "+#",
                                         "(# / (2 + abs(#)))",
                                         "sin(#)",
                                         "max(#, #, #)",
                                         "select(#, #, #)",
                                         "(# < #)",
                                         "(# >= #)",
                                         "(# & # | #)",
                                         "atan2(#, 1 + #*#)",
                                         "floor(#)",
                                         "(# != #)",
                                         "min(#, #)",
                                         "select(#, #, #, #)",
                                         "pow(2, sin(#))",
                                         "(# = # | #)" };
    static const char *const leaves[] = { "a", "b", "K", "1.5", "c", ".25", "pi" };
    if (depth == 0) {
        fputs(leaves[xorshift(random) % COUNT(leaves)], text);
        return;
    }
    for (const char *form = forms[xorshift(random) % COUNT(forms)]; *form; form++)
        if (*form == '#')
            put_formula(text, random, depth - 1);
        else
            fputc(*form, text);
}

/* The value of a function must equal the value of its body, with the parameters
 * declared as names, bit for bit. Later declarations do not change it. */
TEST(by_chance)
{
    enum { FORMULAS = 500, DEPTH = 4 };
    static const char frame[] =
        "#declare K = -.75;\n#declare F = function(a, b, c) { %s }\n"
        "#declare a = 2.5; #declare b = -1.25; #declare c = .5;\n"
        "#declare V = (%s);\n#declare K = 9;\n"
        "sphere { <F(a, b, c), V, 0>, 1 }";
    uint64_t random = RANDOM_SEED;
    for (int i = 0; i < FORMULAS; i++) {
        FREED char *formula = NULL;
        size_t length;
        FILE *file = NON_NULL(open_memstream(&formula, &length));
        put_formula(file, &random, DEPTH);
        fclose(file);
        size_t room = sizeof frame + 2 * strlen(formula);
        FREED char *text = NON_NULL(malloc(room));
        snprintf(text, room, frame, formula, formula);
        SCOPED(scene) *scene = read_scene(text);
        const double *center = scene->primitives->shape.sphere.center;
        FAIL_IF(memcmp(&center[0], &center[1], sizeof *center),
                "%.17g and %.17g of:\n%s", center[0], center[1], text);
    }
}

/* Nested functions can need exponential time, so the reader limits their evaluation. */
TEST(long_ones)
{
    static char text[20000];
    size_t length = (size_t)snprintf(text, sizeof text,
                                     "#declare F0 = function(x) { x + 1 }\n");
    for (int i = 1; i < 100; i++)
        length += (size_t)snprintf(text + length, sizeof text - length,
                                   "#declare F%d = function(x) { F%d(x) + F%d(x) }\n",
                                   i, i - 1, i - 1);
    snprintf(text + length, sizeof text - length, "sphere { 0, F99(1) }");
    assert_refused(text, 1, "too long to read");
}
