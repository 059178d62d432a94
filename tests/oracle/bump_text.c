#include "tests/oracle/bump_text.h"

#include "tests/oracle/chance.h"

void bump_words(uint64_t state, size_t in, char look[SOLID_WORDS])
{
    static const char *const bumps[] = {
        "gradient x, 2 triangle_wave",
        "onion 3 sine_wave",
        "checker 1",
        "radial 4 frequency 5",
        "hexagon normal { onion 2 scale .3 } normal { planar 3 } "
        "normal { leopard 2 scale .1 }",
        "boxed normal_map { [.2 spherical 5] [.6 gradient y, 9] }",
        "quilted 2 control0 .3",
    };
    char bare[SOLID_WORDS];
    state = stream_beside(state, 7, 3);
    if (!one_in(&state, in))
        return;
    solid_words(bare, "%.*s", SOLID_WORDS - 1, look);
    solid_words(look, "%.150snormal { %.110s scale .7 } ", bare,
                bumps[below(&state, sizeof bumps / sizeof *bumps)]);
}
