/* random_stepping.c - makes random programs for a debugger to step through. */
#include "tests/unit/random_stepping.h"

#include "tests/random.h"

void draw_walk(uint64_t *state, struct text_buffer *text)
{
    static const char *const lines[] = {
        "        ADDNV   [a], [b], [c]\n",
        "        MPYSV   [b], [a], [b]\n",
        "        SUBNV   [c], [a], [a]\n",
        "        ADDX    one, count, count\n",
        "        STO     [data, one], count\n",
        "        LOD     [data, one], other\n",
        "        call    routine, link, place\n",
        "        ADDN    other, count, other\n",
        "        load_constant other, 1.5\n",
        "        EXIT    count, r0, 2\n",
    };
    struct sink sink = text_buffer_sink(text);
    size_t loops = 1 + xorshift_below(state, 3);
    *text = (struct text_buffer){ .text = NULL };
    sink_put(&sink, "        .include \"vectors.s\"\n"
                    "        .regs r16, a, b, c, one, count, data, other\n"
                    "        .regs r24, turns, link, place, to\n"
                    "        words a, 1.5, -2.0, 3.0, 4.0\n"
                    "        words b, 0.5, 0.25\n"
                    "        words c\n"
                    "        ES one, 1\n"
                    "        EX data, c.words\n");
    for (size_t i = 0; i < loops; i++) {
        sink_print(&sink, "        ES turns, %u\n        EX to, loop%zu\n",
                   (unsigned)(1 + xorshift_below(state, 40)), i);
        sink_print(&sink, "        .kernel k%zu\nloop%zu:\n", i, i);
        for (size_t k = 1 + xorshift_below(state, 8); k > 0; k--)
            sink_put(&sink, lines[xorshift_below(state, sizeof lines / sizeof *lines)]);
        sink_put(&sink, "        DBNZ turns, [to]\n        .endkernel\n");
    }
    sink_put(&sink, "        EXIT\n"
                    "routine: ADDX count, one, count\n"
                    "        return link\n");
}
