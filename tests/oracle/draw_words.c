/* draw_words.c - writes the machine's random stream for external tests of randomness.
 *
 *     draw_words [--bare] SEED
 *
 * Writes the upper 32 of the 47 bits of each number to stdout, ray by ray, in the
 * host's byte order, until the reader closes the pipe.  The machine computes the
 * numbers in vector form (rt/kernels/points). --bare: writes the states of the
 * generator, computed from its definition, without its output function; these numbers
 * are known to be bad.
 */
#include "tests/oracle/give_up.h"
#include "tests/oracle/points.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { RAYS = 65535, WORDS = RAYS * STREAM_DRAWS };

static c205_word planes[WORDS];
static uint32_t drawn[WORDS];

static bool write_drawn(void)
{
    return fwrite(drawn, sizeof *drawn, WORDS, stdout) == WORDS;
}

static void draw_by_machine(uint64_t seed)
{
    static const struct point_kind kind = { .form = POINTS_VECTOR,
                                            .queue = RAYS,
                                            .points = RAYS,
                                            .coordinates = STREAM_DRAWS };
    struct point_choice choice = { .seed = seed };
    SCOPED(point_maker) *maker = NEEDED(point_maker_new(&kind, &last_error));
    do {
        need(point_maker_run(maker, &choice, planes, &last_error));
        for (size_t k = 0; k < WORDS; k++)
            drawn[k] = (uint32_t)(planes[k % STREAM_DRAWS * RAYS + k / STREAM_DRAWS]
                                  >> 15);
        choice.first += RAYS;
    } while (write_drawn());
}

static void draw_bare(uint64_t seed)
{
    uint64_t step = stream_state_at(1), mask = (UINT64_C(1) << 47) - 1;
    uint64_t x = stream_state_at(seed);
    do {
        for (size_t k = 0; k < WORDS; k++) {
            x = x * step & mask;
            drawn[k] = (uint32_t)(x >> 15);
        }
    } while (write_drawn());
}

int main(int argc, char **argv)
{
    bool bare = argc == 3 && strcmp(argv[1], "--bare") == 0;
    if (argc != 2 && !bare)
        give_up("usage: draw_words [--bare] SEED");
    (bare ? draw_bare : draw_by_machine)(strtoull(argv[argc - 1], NULL, 10));
    return 0;
}
