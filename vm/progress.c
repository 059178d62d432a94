#include "vm/progress.h"

#include "vm/memory.h"
#include "vm/serializer.h"

/* The longest search makes so many comparisons. */
#define MAX_COMPARED ((size_t)C205_MAX_LENGTH * C205_MAX_LENGTH)

/* ---- The instruction itself --------------------------------------------- */

static void keep_instruction(struct package *progress, const struct decoded *decoded)
{
    c205_word word = c205_encode(decoded->insn, &decoded->fields);
    unsigned halves = c205_format_halves(decoded->insn->format);
    progress->half[progress->halves++] = (uint32_t)(word >> HALF_BITS);
    if (halves == 2)
        progress->half[progress->halves++] = (uint32_t)word;
}

/* Of one that was interrupted before, that is what was kept then. */
void progress_interrupt(struct package *progress, const struct decoded *decoded)
{
    progress->interrupted = true;
    progress->halves = 0;
    keep_instruction(progress, decoded);
    for (size_t i = 0; i < 2 && decoded->linked[i]; i++)
        keep_instruction(progress, decoded->linked[i]);
}

bool progress_holds(const struct package *progress, uint64_t pc, uint64_t address,
                    c205_word *half)
{
    uint64_t i = ((address - pc) & ADDRESS_MASK) / HALF_BITS;
    if (!progress->interrupted || i >= progress->halves)
        return false;
    *half = progress->half[i];
    return true;
}

/* ---- On a tape ---------------------------------------------------------- */

static void walk_instruction(struct package *progress, struct serializer *serializer)
{
    size_t halves = progress->halves;
    serializer_size(serializer, &halves, PACKAGE_HALVES);
    progress->halves = (unsigned)halves;
    for (size_t i = 0; i < halves; i++) {
        uint64_t half = progress->half[i];
        serializer_word(serializer, &half);
        serializer_require(serializer, half <= UINT32_MAX,
                           "the interrupted instruction is damaged");
        progress->half[i] = (uint32_t)half;
    }
}

static void walk_flag(bool *flag, struct serializer *serializer)
{
    size_t size = *flag;
    serializer_size(serializer, &size, 1);
    *flag = size == 1;
}

/* Whatever numbers a tape holds, the loops stay within what is claimed. */
void progress_walk(struct package *progress, struct serializer *serializer)
{
    walk_flag(&progress->interrupted, serializer);
    if (!progress->interrupted)
        return;
    walk_instruction(progress, serializer);
    walk_flag(&progress->found, serializer);
    serializer_size(serializer, &progress->first, C205_MAX_LENGTH);
    for (size_t i = 0; i < 2; i++)
        serializer_size(serializer, &progress->count[i], MAX_COMPARED);
    serializer_word(serializer, &progress->word);
    serializer_word(serializer, &progress->lower);
    serializer_word(serializer, &progress->flags);
    serializer_size(serializer, &progress->kept, C205_MAX_LENGTH);
}
