#include "tests/oracle/beam_text.h"

#include "tests/oracle/chance.h"

static void aim(uint64_t *state, const double position[3], double size,
                char words[SOLID_WORDS])
{
    double way[3] = { 0, -1, 0 };
    if (one_in(state, 4)) { /* along an axis */
        size_t axis = below(state, 3);
        way[1] = 0;
        way[axis] = one_in(state, 2) ? 1 : -1;
    } else {
        way[0] = between(state, -.8, .8);
        way[2] = between(state, -.5, .8);
    }
    solid_words(words, " point_at <%.6g, %.6g, %.6g>",
                position[0] + size * way[0], position[1] + size * way[1],
                position[2] + size * way[2]);
}

static void fade(uint64_t *state, double size, char words[SOLID_WORDS])
{
    words[0] = '\0';
    if (one_in(state, 2))
        return;
    solid_words(words, " fade_distance %.5g fade_power %.3g",
                size * of_any_size(state, .1, 10),
                one_in(state, 2) ? 2 : between(state, .2, 9));
}

void beam_words(uint64_t state, const double position[3], double size,
                char words[SOLID_WORDS])
{
    char at[SOLID_WORDS], fading[SOLID_WORDS];
    state = state * 5 + 1;
    for (int i = 0; i < 8; i++)
        xorshift(&state);
    words[0] = '\0';
    if (one_in(&state, 2))
        return;
    aim(&state, position, size, at);
    fade(&state, size, fading);
    double tightness = one_in(&state, 2) ? 0 : between(&state, -1, 20);
    double full = between(&state, -.1, 1.1);
    switch (below(&state, 4)) {
    case 0: solid_words(words, "%.99s", fading); break;
    case 1: solid_words(words, " parallel%.99s%.99s", at, fading); break;
    case 2:
        solid_words(words,
                    " spotlight%.99s radius %.4g falloff %.4g tightness "
                    "%.3g%.99s",
                    at, 60 * full, between(&state, 5, 100), tightness,
                    fading);
        break;
    default:
        solid_words(words,
                    " cylinder%.99s radius %.4g falloff %.4g tightness "
                    "%.3g%.99s",
                    at, size * full, size * between(&state, .1, 1), tightness,
                    fading);
        break;
    }
}
