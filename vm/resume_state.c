/* resume_state.c - saves an interrupted instruction and serializes its progress. */
#include "vm/resume_state.h"

#include "vm/memory.h"
#include "vm/serializer.h"

/* The largest number of comparisons of a search. */
#define MAX_COMPARED ((size_t)C205_MAX_LENGTH * C205_MAX_LENGTH)

/* ---- The instruction itself --------------------------------------------- */

static void keep_instruction(struct resume_state *resume, const struct decoded *decoded)
{
    c205_word word = c205_encode(decoded->insn, &decoded->fields);
    unsigned halves = c205_format_halves(decoded->insn->format);
    resume->half[resume->halves++] = (uint32_t)(word >> HALF_BITS);
    if (halves == 2)
        resume->half[resume->halves++] = (uint32_t)word;
}

/* Saves the instruction. decoded is already the saved instruction if it was interrupted
 * before. */
void resume_interrupt(struct resume_state *resume, const struct decoded *decoded)
{
    resume->interrupted = true;
    resume->halves = 0;
    keep_instruction(resume, decoded);
    for (size_t i = 0; i < 2 && decoded->linked[i]; i++)
        keep_instruction(resume, decoded->linked[i]);
}

bool resume_holds(const struct resume_state *resume, uint64_t pc, uint64_t address,
                  c205_word *half)
{
    uint64_t i = ((address - pc) & ADDRESS_MASK) / HALF_BITS;
    if (!resume->interrupted || i >= resume->halves)
        return false;
    *half = resume->half[i];
    return true;
}

/* ---- Serialization ------------------------------------------------------ */

static void walk_instruction(struct resume_state *resume, struct serializer *serializer)
{
    size_t halves = resume->halves;
    serializer_size(serializer, &halves, PACKAGE_HALVES);
    resume->halves = (unsigned)halves;
    for (size_t i = 0; i < halves; i++) {
        uint64_t half = resume->half[i];
        serializer_word(serializer, &half);
        serializer_require(serializer, half <= UINT32_MAX,
                           "the interrupted instruction is damaged");
        resume->half[i] = (uint32_t)half;
    }
}

static void walk_flag(bool *flag, struct serializer *serializer)
{
    size_t size = *flag;
    serializer_size(serializer, &size, 1);
    *flag = size == 1;
}

/* Serializes the state. Reading accepts all numbers within these limits, because with
 * any of them the instruction accesses only memory that it has claimed. */
void resume_walk(struct resume_state *resume, struct serializer *serializer)
{
    walk_flag(&resume->interrupted, serializer);
    if (!resume->interrupted)
        return;
    walk_instruction(resume, serializer);
    walk_flag(&resume->found, serializer);
    serializer_size(serializer, &resume->first, C205_MAX_LENGTH);
    for (size_t i = 0; i < 2; i++)
        serializer_size(serializer, &resume->count[i], MAX_COMPARED);
    serializer_word(serializer, &resume->word);
    serializer_word(serializer, &resume->lower);
    serializer_word(serializer, &resume->flags);
    serializer_size(serializer, &resume->kept, C205_MAX_LENGTH);
}
