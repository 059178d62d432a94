/* vector_use.c - counts vector elements by observing instructions. */
#include "rt/trace/vector_use.h"

#include <stdlib.h>
#include <string.h>

#include "vm/error.h"

enum { CONTROL_WORDS = 65536 / 64 + 1 };

static unsigned ones(c205_word word)
{
    unsigned count = 0;
    for (; word != 0; word &= word - 1)
        count++;
    return count;
}

/* Returns the bits first .. last - 1 of a word, where bit 0 is the highest bit. */
static c205_word bits_between(c205_word word, uint64_t first, uint64_t last)
{
    if (first > 0)
        word &= UINT64_MAX >> first;
    if (last < 64)
        word &= ~(UINT64_MAX >> last);
    return word;
}

/* Returns the number of ones among the `count` bits from an address on, or 0 if the
 * memory is not mapped. */
static uint64_t count_ones(const c205 *machine, uint64_t address, uint64_t count)
{
    c205_word words[CONTROL_WORDS];
    uint64_t begin = address % 64, end = begin + count, sum = 0;
    size_t length = (size_t)((end + 63) / 64);
    if (length > CONTROL_WORDS || !c205_read(machine, address - begin, words, length))
        return 0;
    for (size_t i = 0; i < length; i++) {
        uint64_t first = i == 0 ? begin : 0;
        uint64_t left = end - 64 * i;
        sum += ones(bits_between(words[i], first, left < 64 ? left : 64));
    }
    return sum;
}

static void count_controlled(struct vector_use *use, const c205 *machine,
                             const c205_event *event)
{
    const c205_fields *fields = &event->fields;
    uint64_t address = c205_register(machine, fields->z) & UINT64_C(0xFFFFFFFFFFFF);
    uint64_t count;
    if (fields->g & C205_G_OFFSET)
        address += c205_register(machine, fields->c + 1u);
    count = count_ones(machine, address, event->elements);
    use->controlled += event->elements;
    use->wanted += fields->g & C205_G_ZEROS ? event->elements - count : count;
}

static void listen(void *use, const c205 *machine, const c205_event *event)
{
    struct vector_use *sum = use;
    if (event->kind != C205_EVENT_INSTRUCTION
        || !c205_timing_is_vector(event->insn->timing) || event->elements == 0)
        return;
    sum->instructions++;
    sum->elements += event->elements;
    if (event->fields.z != 0 && strchr(event->insn->operands, 'z'))
        count_controlled(sum, machine, event);
}

static void *begin_use(void *context, const struct object *program, c205_error *error)
{
    struct vector_use *use = calloc(1, sizeof *use);
    (void)context;
    (void)program;
    if (!use)
        error_set(error, "out of memory");
    return use;
}

static void merge(void *context, const void *band)
{
    const struct vector_use *use = band;
    struct vector_use *sum = context;
    sum->instructions += use->instructions;
    sum->elements += use->elements;
    sum->controlled += use->controlled;
    sum->wanted += use->wanted;
}

struct observer vector_use_observer(struct vector_use *sum)
{
    return (struct observer){ begin_use, listen, merge, free, sum };
}
