/* recording.c - records the input of the clock during a run, and replays it to other
 * clocks.
 *
 * The record consists of decoded instructions and their effects. Each executed
 * instruction is recorded as a word, | 16 flags | 16 touches | 32 instruction |,
 * followed by the words of its effect in the order of the flags.
 */
#include "vm/time/recording.h"
#include "vm/error.h"
#include "vm/time/clock.h"
#include "vm/time/model.h"
#include "vm/time/projection.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    HAS_ELEMENTS = 1,
    HAS_TARGET = 2,
    HAS_SWAPPED = 4,
    HAS_INDICES = 8,
    HAS_IDLE = 16,
    HAS_RECURRENT = 32
};
enum { FLAG_SHIFT = 48, TOUCH_SHIFT = 32, FINDERS = 1 << 14 };

/* A recorded instruction and, for a linked pair, its members. */
struct kept {
    struct decoded decoded;
    struct decoded pair[2];
};

struct c205_recording {
    size_t kept_count, kept_room;
    struct kept **kept;
    size_t word_count, word_room;
    uint64_t *words;
    size_t regions;
    bool no_memory;
    uint32_t finder[FINDERS]; /* direct-mapped cache from addresses to 1 + index of
                                 kept */
};

c205_recording *c205_recording_new(c205_error *error)
{
    c205_recording *recording = calloc(1, sizeof *recording);
    if (!recording)
        error_set(error, "out of memory for a recording");
    return recording;
}

void c205_recording_free(c205_recording *recording)
{
    if (!recording)
        return;
    for (size_t i = 0; i < recording->kept_count; i++)
        free(recording->kept[i]);
    free(recording->kept);
    free(recording->words);
    free(recording);
}

/* ---- Recording ----------------------------------------------------------- */

/* Doubles the size of an array. Returns NULL if the host is out of memory. */
static void *grown(void *items, size_t *room, size_t size)
{
    size_t more = *room ? 2 * *room : 1024;
    void *larger = realloc(items, more * size);
    if (larger)
        *room = more;
    return larger;
}

static void add_word(c205_recording *recording, uint64_t word)
{
    if (recording->no_memory)
        return;
    if (recording->word_count == recording->word_room) {
        uint64_t *words = grown(recording->words, &recording->word_room, sizeof *words);
        if (!words) {
            recording->no_memory = true;
            return;
        }
        recording->words = words;
    }
    recording->words[recording->word_count++] = word;
}

static bool grow_instructions(c205_recording *recording)
{
    if (recording->kept_count < recording->kept_room)
        return true;
    struct kept **kept = grown(recording->kept, &recording->kept_room, sizeof *kept);
    if (kept)
        recording->kept = kept;
    return kept;
}

/* Stores an instruction. Returns its number in the recording, or 0 if the host is out
 * of memory. */
static uint32_t store_instruction(c205_recording *recording,
                                  const struct decoded *decoded)
{
    struct kept *kept = malloc(sizeof *kept);
    if (!kept || !grow_instructions(recording)) {
        free(kept);
        recording->no_memory = true;
        return 0;
    }
    kept->decoded = *decoded;
    for (size_t i = 0; i < 2; i++)
        if (decoded->linked[i]) {
            kept->pair[i] = *decoded->linked[i];
            kept->decoded.linked[i] = &kept->pair[i];
        }
    recording->kept[recording->kept_count++] = kept;
    return (uint32_t)recording->kept_count;
}

static uint32_t instruction_number(c205_recording *recording,
                                   const struct decoded *decoded)
{
    uint32_t *found = &recording->finder[decoded->pc / INSTRUCTION_STEP % FINDERS];
    if (*found) {
        const struct decoded *kept = &recording->kept[*found - 1]->decoded;
        if (kept->pc == decoded->pc && kept->version == decoded->version)
            return *found;
    }
    return *found = store_instruction(recording, decoded);
}

static unsigned flags_of(const struct effect *effect)
{
    return (effect->elements ? HAS_ELEMENTS : 0u) | (effect->idle ? HAS_IDLE : 0u)
           | (effect->recurrent ? HAS_RECURRENT : 0u)
           | (effect->taken ? HAS_TARGET : 0u) | (effect->swapped ? HAS_SWAPPED : 0u)
           | (effect->indices ? HAS_INDICES : 0u);
}

static void add_indices(c205_recording *recording, const struct effect *effect)
{
    add_word(recording, effect->index_count);
    add_word(recording, effect->table);
    add_word(recording, effect->table_step);
    for (size_t i = 0; i < effect->index_count; i++)
        add_word(recording, effect->indices[i]);
}

static void add_effect(c205_recording *recording, const struct effect *effect)
{
    for (unsigned i = 0; i < effect->touch_count; i++) {
        add_word(recording, effect->touch[i].address);
        add_word(recording, effect->touch[i].bits);
    }
    if (effect->elements)
        add_word(recording, effect->elements);
    if (effect->idle)
        add_word(recording, effect->idle);
    if (effect->recurrent)
        add_word(recording, effect->recurrent);
    if (effect->taken)
        add_word(recording, effect->target);
    if (effect->swapped) {
        add_word(recording, effect->swapped);
        add_word(recording, effect->saved);
    }
    if (effect->indices)
        add_indices(recording, effect);
}

void recording_add(c205_recording *recording, const struct decoded *decoded,
                   const struct effect *effect, size_t region)
{
    uint32_t number = instruction_number(recording, decoded);
    add_word(recording, (uint64_t)flags_of(effect) << FLAG_SHIFT
                            | (uint64_t)effect->touch_count << TOUCH_SHIFT | number);
    add_effect(recording, effect);
    if (recording->regions <= region)
        recording->regions = region + 1;
}

/* ---- Playback ----------------------------------------------------------- */

/* Reads an effect from the words after an instruction. Returns the address of the next
 * instruction. */
static const uint64_t *read_effect(const uint64_t *at, uint64_t head,
                                   struct effect *effect)
{
    unsigned flags = (unsigned)(head >> FLAG_SHIFT);
    effect->touch_count = (unsigned)(head >> TOUCH_SHIFT & 0xFFFF);
    for (unsigned i = 0; i < effect->touch_count; i++) {
        effect->touch[i].address = *at++;
        effect->touch[i].bits = *at++;
    }
    effect->elements = flags & HAS_ELEMENTS ? (size_t)*at++ : 0;
    effect->idle = flags & HAS_IDLE ? (size_t)*at++ : 0;
    effect->recurrent = flags & HAS_RECURRENT ? (size_t)*at++ : 0;
    effect->taken = flags & HAS_TARGET;
    effect->target = effect->taken ? *at++ : 0;
    effect->swapped = flags & HAS_SWAPPED ? (size_t)*at++ : 0;
    effect->saved = flags & HAS_SWAPPED ? (size_t)*at++ : 0;
    effect->indices = NULL;
    if (flags & HAS_INDICES) {
        effect->index_count = (size_t)*at++;
        effect->table = *at++;
        effect->table_step = (unsigned)*at++;
        effect->indices = at;
        at += effect->index_count;
    }
    return at;
}

/* The target of a playback. One of the two pointers is not NULL. */
struct player {
    struct clock *clock;
    c205_projection *projection;
};

static void play(const c205_recording *recording, const struct player *player)
{
    const uint64_t *at = recording->words;
    const uint64_t *end = at + recording->word_count;
    struct effect effect;
    memset(&effect, 0, sizeof effect);
    while (at < end) {
        uint64_t head = *at;
        const struct decoded *decoded = &recording->kept[(uint32_t)head - 1]->decoded;
        at = read_effect(at + 1, head, &effect);
        if (player->clock)
            clock_charge(player->clock, decoded, &effect);
        else
            projection_charge(player->projection, decoded, &effect);
    }
    if (player->clock)
        clock_drain(player->clock);
}

static double recorded_clocks(const c205_account *account)
{
    uint64_t clocks = 0;
    for (int cause = 0; cause < C205_CAUSES; cause++)
        clocks += account->clocks[cause];
    return (double)clocks;
}

static bool retime_machine(const c205_recording *recording, const c205_model *model,
                           double *clocks, size_t regions, c205_error *error)
{
    struct player player = { clock_new(model, error), NULL };
    const char **names = malloc((recording->regions + 1) * sizeof *names);
    bool good = player.clock && names;
    if (player.clock && !names)
        error_set(error, "out of memory while a recording is played");
    for (size_t i = 0; good && i <= recording->regions; i++)
        names[i] = "";
    good = good
           && clock_set_regions(player.clock, names, recording->regions + 1, error);
    if (good)
        play(recording, &player);
    for (size_t i = 0; good && i < regions; i++)
        clocks[i] = i < recording->regions
                        ? recorded_clocks(clock_account(player.clock, i))
                        : 0;
    free(names);
    clock_free(player.clock);
    return good;
}

static bool retime_projection(const c205_recording *recording, const c205_model *model,
                              double *clocks, size_t regions, c205_error *error)
{
    struct player player = { NULL, c205_projection_new(model, error) };
    if (!player.projection)
        return false;
    play(recording, &player);
    for (size_t i = 0; i < regions; i++)
        clocks[i] = projection_strangers(player.projection, i)
                        ? NAN
                        : (double)c205_projected_clocks(player.projection, i);
    bool good = projection_complete(player.projection, error);
    c205_projection_free(player.projection);
    return good;
}

bool c205_retime(const c205_recording *recording, const c205_model *model,
                 const c205_setting *settings, size_t count, unsigned ticks,
                 double *clocks, size_t regions, c205_error *error)
{
    c205_model *changed = model_in_ticks(model, settings, count, ticks, error);
    bool good = changed;
    if (good && recording->no_memory) {
        error_set(error, "out of memory while the run is recorded");
        good = false;
    }
    if (good && c205_model_is_projection(model))
        good = retime_projection(recording, changed, clocks, regions, error);
    else if (good)
        good = retime_machine(recording, changed, clocks, regions, error);
    for (size_t i = 0; good && i < regions; i++)
        clocks[i] /= ticks;
    c205_model_free(changed);
    return good;
}
