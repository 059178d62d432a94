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
    solid_words(words, " point_at <%.6g, %.6g, %.6g>", position[0] + size * way[0],
                position[1] + size * way[1], position[2] + size * way[2]);
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

/* On whole numbers, or anyhow. */
static void say_axis(uint64_t *state, double size, char words[SOLID_WORDS])
{
    double axis[3] = { 0, 0, 0 };
    if (one_in(state, 2))
        axis[below(state, 3)] = 2;
    else
        for (int i = 0; i < 3; i++)
            axis[i] = size * between(state, -.6, .6);
    solid_words(words, "<%.5g, %.5g, %.5g>", axis[0], axis[1], axis[2]);
}

static void spread(uint64_t *state, double size, char words[SOLID_WORDS])
{
    char one[SOLID_WORDS], other[SOLID_WORDS];
    say_axis(state, size, one);
    say_axis(state, size, other);
    size_t across = 1 + below(state, 4), down = 1 + below(state, 3);
    bool circular = across > 1 && down > 1 && one_in(state, 3);
    solid_words(words, " area_light %.60s, %.60s, %zu, %zu%s", one, other, across, down,
                circular ? " circular" : "");
}

void beam_words(uint64_t state, const double position[3], double size,
                char words[SOLID_WORDS])
{
    char at[SOLID_WORDS], fading[SOLID_WORDS];
    state = stream_beside(state, 5, 1);
    words[0] = '\0';
    if (one_in(&state, 2)) {
        if (one_in(&state, 4))
            spread(&state, size, words);
        return;
    }
    aim(&state, position, size, at);
    fade(&state, size, fading);
    double tightness = one_in(&state, 2) ? 0 : between(&state, -1, 20);
    double full = between(&state, -.1, 1.1);
    switch (below(&state, 4)) {
    case 0:
        spread(&state, size, at);
        solid_words(words, "%.99s%.150s", fading, one_in(&state, 2) ? at : "");
        break;
    case 1: solid_words(words, " parallel%.99s%.99s", at, fading); break;
    case 2:
        solid_words(words,
                    " spotlight%.99s radius %.4g falloff %.4g tightness "
                    "%.3g%.99s",
                    at, 60 * full, between(&state, 5, 100), tightness, fading);
        break;
    default:
        solid_words(words,
                    " cylinder%.99s radius %.4g falloff %.4g tightness "
                    "%.3g%.99s",
                    at, size * full, size * between(&state, .1, 1), tightness, fading);
        break;
    }
}
