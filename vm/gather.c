/* gather.c - gather and scatter: elements by the addresses of an index list.
 */
#include "vector.h"

/* A is the index list; its elements count words from a base on.  Gather
 * moves from there to the result C, scatter from the source B to there. */
struct transfer {
    struct stream stream;
    bool gather;
    uint64_t base;
    c205_word *indices; /* those permitted, one behind the other */
    size_t count;       /* how many */
};

static uint64_t table_address(const struct transfer *transfer,
                              c205_word index)
{
    return (transfer->base + index * WORD_BITS) & ADDRESS_MASK;
}

/* ---- The index list ----------------------------------------------------- */

static void collect_indices(struct transfer *transfer)
{
    struct stream *stream = &transfer->stream;
    uint64_t permitted[CHUNK_WORDS];
    transfer->count = 0;
    for (size_t first = 0, n; first < stream->n; first += n) {
        n = stream_next(stream, first);
        control_read(&stream->control, first, n, permitted);
        transfer->count += compress_words(
            transfer->indices + transfer->count,
            source_read(&stream->a, first, n), permitted, n);
    }
}

/* From the lowest to the highest word that the list names. */
struct extent {
    uint64_t low, high;
};

static struct extent extent_of(const struct transfer *transfer)
{
    struct extent extent = { ADDRESS_MASK, 0 };
    for (size_t i = 0; i < transfer->count; i++) {
        uint64_t address = table_address(transfer, transfer->indices[i]);
        extent.low = address < extent.low ? address : extent.low;
        extent.high = address > extent.high ? address : extent.high;
    }
    return extent;
}

static bool is_within(const struct vector *vector, struct extent extent)
{
    return vector->length > 0 && vector->address < extent.high + WORD_BITS
           && extent.low < vector_at(vector, vector->length);
}

/* Does what is stored change what is read? */
static bool is_entangled(struct transfer *transfer)
{
    const struct stream *stream = &transfer->stream;
    const struct vector *a = &stream->a.vector, *c = &stream->result;
    const struct vector *z = &stream->control.vector;
    struct extent extent = extent_of(transfer);
    if (!transfer->gather)
        return is_within(a, extent) || is_within(z, extent)
               || is_within(&stream->b.vector, extent);
    return is_within(c, extent) || operands_overlap(z, c)
           || (operands_overlap(a, c) && c->address > a->address);
}

static c205_trap check_table(struct transfer *transfer)
{
    struct c205 *machine = transfer->stream.machine;
    c205_trap trap = C205_TRAP_NONE;
    uint64_t checked = UINT64_MAX;
    for (size_t i = 0; i < transfer->count && trap == C205_TRAP_NONE; i++) {
        uint64_t address = table_address(transfer, transfer->indices[i]);
        if (address >> PAGE_SHIFT != checked)
            trap = memory_check(&machine->memory, address, WORD_BITS,
                                !transfer->gather, &machine->fault);
        checked = address >> PAGE_SHIFT;
    }
    return trap;
}

/* ---- Whole chunks ------------------------------------------------------- */

static void gather_chunk(struct transfer *transfer, size_t first, size_t n,
                         const uint64_t *permitted,
                         const c205_word **next_index)
{
    struct stream *stream = &transfer->stream;
    struct memory *memory = &stream->machine->memory;
    c205_word words[CHUNK];
    for (size_t i = 0; i < n; i++) {
        words[i] = 0;
        if (bit_at(permitted, i))
            memory_load(memory, table_address(transfer, *(*next_index)++),
                        &words[i]);
    }
    result_store(stream->machine, &stream->result, &stream->control, first,
                 words, n);
}

static void scatter_chunk(struct transfer *transfer, size_t first, size_t n,
                          const uint64_t *permitted,
                          const c205_word **next_index)
{
    struct stream *stream = &transfer->stream;
    struct memory *memory = &stream->machine->memory;
    const c205_word *b = source_read(&stream->b, first, n);
    for (size_t i = 0; i < n; i++)
        if (bit_at(permitted, i))
            memory_store(memory, table_address(transfer, *(*next_index)++),
                         b[i]);
}

static c205_trap transfer_chunks(struct transfer *transfer)
{
    struct stream *stream = &transfer->stream;
    const c205_word *next_index = transfer->indices;
    uint64_t permitted[CHUNK_WORDS];
    c205_trap trap = check_table(transfer);
    if (trap != C205_TRAP_NONE)
        return trap;
    for (size_t first = 0, n; first < stream->n; first += n) {
        n = stream_next(stream, first);
        control_read(&stream->control, first, n, permitted);
        (transfer->gather ? gather_chunk : scatter_chunk)(
            transfer, first, n, permitted, &next_index);
    }
    return C205_TRAP_NONE;
}

/* ---- One element after another ------------------------------------------ */

/* What was overwritten, to be put back if a later element traps. */
struct undo {
    c205_word *old;
    c205_word *address;
};

static c205_trap transfer_one(struct transfer *transfer, size_t i,
                              const struct undo *undo)
{
    struct stream *stream = &transfer->stream;
    struct c205 *machine = stream->machine;
    c205_word index = *source_read(&stream->a, i, 1), word;
    uint64_t table = table_address(transfer, index), to = table;
    c205_trap trap = C205_TRAP_NONE;
    if (transfer->gather) {
        to = vector_at(&stream->result, i);
        trap = memory_load(&machine->memory, table, &word);
    } else {
        word = *source_read(&stream->b, i, 1);
    }
    if (trap == C205_TRAP_NONE)
        trap = memory_load(&machine->memory, to,
                           &undo->old[transfer->count]);
    if (trap == C205_TRAP_NONE)
        trap = memory_store(&machine->memory, to, word);
    if (trap != C205_TRAP_NONE)
        return machine_fault(machine, trap, table);
    undo->address[transfer->count] = to;
    transfer->indices[transfer->count++] = index;
    return C205_TRAP_NONE;
}

static c205_trap transfer_one_by_one(struct transfer *transfer)
{
    struct stream *stream = &transfer->stream;
    struct c205 *machine = stream->machine;
    struct undo undo = { machine_scratch(machine, SCRATCH_OLD_WORDS),
                         machine_scratch(machine, SCRATCH_ADDRESSES) };
    c205_trap trap = C205_TRAP_NONE;
    if (!undo.old || !undo.address)
        return C205_TRAP_NO_MEMORY;
    transfer->count = 0;
    for (size_t i = 0; i < stream->n && trap == C205_TRAP_NONE; i++) {
        uint64_t permitted;
        control_read(&stream->control, i, 1, &permitted);
        if (permitted)
            trap = transfer_one(transfer, i, &undo);
    }
    while (trap != C205_TRAP_NONE && transfer->count-- > 0)
        memory_store(&machine->memory, undo.address[transfer->count],
                     undo.old[transfer->count]);
    return trap;
}

/* ---- The instructions --------------------------------------------------- */

static c205_trap run_transfer(struct transfer *transfer)
{
    struct stream *stream = &transfer->stream;
    struct c205 *machine = stream->machine;
    transfer->base &= ADDRESS_MASK;
    transfer->indices = machine_scratch(machine, SCRATCH_INDICES);
    if (!transfer->indices)
        return C205_TRAP_NO_MEMORY;
    if (stream->n > 0 && transfer->base % WORD_BITS)
        return machine_fault(machine, C205_TRAP_MISALIGNED_OPERAND,
                             transfer->base);
    stream->chunk = CHUNK;
    collect_indices(transfer);
    c205_trap trap = is_entangled(transfer) ? transfer_one_by_one(transfer)
                                            : transfer_chunks(transfer);
    machine->effect.indices = transfer->indices;
    machine->effect.index_count = transfer->count;
    machine->effect.base = transfer->base;
    return trap;
}

c205_trap execute_vector_gather(struct c205 *machine,
                                const struct decoded *decoded)
{
    struct transfer transfer;
    struct stream *stream = &transfer.stream;
    c205_trap trap = stream_describe(stream, machine, decoded, WORD_BITS);
    if (trap != C205_TRAP_NONE)
        return trap;
    if (stream->n > stream->a.vector.length)
        stream->n = stream->a.vector.length;
    stream->b.vector.length = 0; /* B is no stream but the table */
    transfer.gather = true;
    transfer.base = machine->slot[decoded->b];
    trap = stream_claim(stream);
    return trap == C205_TRAP_NONE ? run_transfer(&transfer) : trap;
}

c205_trap execute_vector_scatter(struct c205 *machine,
                                 const struct decoded *decoded)
{
    struct transfer transfer;
    struct stream *stream = &transfer.stream;
    c205_trap trap = stream_describe_sources(stream, machine, decoded);
    if (trap != C205_TRAP_NONE)
        return trap;
    transfer.gather = false;
    transfer.base = machine->slot[decoded->c];
    trap = stream_claim_sources(stream);
    return trap == C205_TRAP_NONE ? run_transfer(&transfer) : trap;
}
