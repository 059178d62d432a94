/* random_debug_program.c - makes random program texts that terminate. */
#include "tests/unit/random_debug_program.h"

#include "tests/random.h"

struct kinds {
    size_t count;
    const char *const *lines;
};

static const char *const scalar_lines[] = {
    "        ADDN    r30, r31, r32\n", "        MPYS    r32, r31, r33\n",
    "        ADDX    r40, r41, r42\n", "        LOD     [r50], r34\n",
    "        ES      r43, 5\n",        "        STO     [r51], r33\n",
};
static const char *const vector_lines[] = {
    "        ADDNV   [r50], [r51], [r52]\n",
    "        MPYSV   [r50], r31, [r51]\n",
    "        LINKV\n        MPYSV   [r50], r31, [r52]\n"
    "        ADDNV   [r52], [r51], [r51]\n",
    "        SUMV    [r50], r36\n",
};
static const struct kinds scalars = { sizeof scalar_lines / sizeof *scalar_lines,
                                      scalar_lines };
static const struct kinds vectors = { sizeof vector_lines / sizeof *vector_lines,
                                      vector_lines };

/* Adds a random number of lines, up to `most`. */
static void add_lines(uint64_t *state, char *text, int64_t most,
                      const struct kinds *kinds)
{
    int64_t count = xorshift_between(state, 0, most);
    while (count-- > 0)
        strcat(text, kinds->lines[xorshift(state) % kinds->count]);
}

void draw_program(uint64_t *state, char text[DRAWN_TEXT])
{
    strcpy(text, "        .include \"core.s\"\n"
                 "        .data\n"
                 "a:      .space n\nb:      .space n\nc:      .space n\n"
                 "        .code\n"
                 "        descriptor r50, a, n\n"
                 "        descriptor r51, b, n\n"
                 "        descriptor r52, c, n\n"
                 "        .kernel all\n");
    add_lines(state, text, 40, &scalars);
    add_lines(state, text, 3, &vectors);
    if (xorshift(state) % 2) {
        strcat(text, "        EX      r60, 0\n        EX      r61, n\n"
                     "        ES      r62, 1\nloop:\n");
        add_lines(state, text, 3, &scalars);
        strcat(text, "        IBXLT   r60, r62, r61, loop, r60\n");
    }
    strcat(text, "        .endkernel\n");
    add_lines(state, text, 10, &scalars);
    strcat(text, "        LOD     [r51], r35\n"
                 "        ADDN    r35, r35, r35\n        EXIT\n");
}
