/* gather.c - executes gather and scatter, which copy between a vector and the elements
 * of a table that an index list or a constant distance selects.
 */
#include "vm/direct.h"
#include "vm/number/host.h"
#include "vm/vector.h"

/* A gather or scatter instruction. A is the index list, or the distance between
 * indices. Indices count elements from the start of a table. Gather moves elements from
 * the table to the result C, scatter moves them from the source B to the table. */
struct transfer {
    struct stream stream;
    bool gather, periodic;
    c205_word period;    /* modulo 2^48, like addresses */
    struct vector table; /* its length is unknown */
    c205_word *indices;  /* the permitted indices, packed */
    size_t count;        /* number of permitted indices */
    size_t used;         /* number of indices used before this turn */
};

static uint64_t table_address(const struct transfer *transfer, c205_word index)
{
    return (transfer->table.address + index * transfer->table.width) & ADDRESS_MASK;
}

/* ---- The index list ----------------------------------------------------- */

/* Returns n indices from position first. If a constant distance replaces the index
 * list, the index at position i is i x distance. */
static const c205_word *read_indices(struct transfer *transfer, size_t first, size_t n)
{
    struct source *a = &transfer->stream.a;
    if (!transfer->periodic)
        return source_read(a, first, n);
    for (size_t i = 0; i < n; i++)
        a->space[i] = (first + i) * transfer->period;
    return a->space;
}

/* Collects the permitted indices. Indices that were used before an interruption come
 * from the saved copy, because the list may have been overwritten since. */
static void collect_indices(struct transfer *transfer)
{
    struct stream *stream = &transfer->stream;
    uint64_t permitted[CHUNK_WORDS];
    transfer->used = min_size(stream->machine->resume.kept, stream->turn.first);
    transfer->count = transfer->used;
    for (size_t first = stream->turn.first, n; first < stream->n; first += n) {
        n = min_size(stream->n - first, CHUNK);
        control_read(&stream->control, first, n, permitted);
        transfer->count += compress_words(transfer->indices + transfer->count,
                                          read_indices(transfer, first, n), permitted,
                                          n);
    }
}

/* The memory from the lowest element of the list to the end of the highest element. */
struct extent {
    uint64_t low, end;
};

static struct extent extent_of(const struct transfer *transfer)
{
    struct extent extent = { ADDRESS_MASK, 0 };
    for (size_t i = transfer->used; i < transfer->count; i++) {
        uint64_t address = table_address(transfer, transfer->indices[i]);
        extent.low = address < extent.low ? address : extent.low;
        address += transfer->table.width;
        extent.end = address > extent.end ? address : extent.end;
    }
    return extent;
}

static bool is_within(const struct vector *vector, struct extent extent)
{
    return vector->length > 0 && vector->address < extent.end
           && extent.low < vector_at(vector, vector->length);
}

/* Returns true if a store may change an unread operand. */
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
    for (size_t i = transfer->used; i < transfer->count && trap == C205_TRAP_NONE;
         i++) {
        uint64_t address = table_address(transfer, transfer->indices[i]);
        if (address >> PAGE_SHIFT != checked)
            trap = memory_check(&machine->memory, address, transfer->table.width,
                                !transfer->gather, &machine->fault);
        checked = address >> PAGE_SHIFT;
    }
    return trap;
}

static c205_trap load_element(const struct memory *memory, uint64_t address,
                              unsigned width, c205_word *word)
{
    return width == HALF_BITS ? memory_load_half(memory, address, word)
                              : memory_load(memory, address, word);
}

static c205_trap store_element(struct memory *memory, uint64_t address, unsigned width,
                               c205_word word)
{
    return width == HALF_BITS ? memory_store_half(memory, address, word)
                              : memory_store(memory, address, word);
}

/* ---- Whole chunks ------------------------------------------------------- */

static void gather_chunk(struct transfer *transfer, size_t first, size_t n,
                         const uint64_t *permitted, const c205_word **next_index)
{
    struct stream *stream = &transfer->stream;
    struct memory *memory = &stream->machine->memory;
    c205_word words[CHUNK];
    for (size_t i = 0; i < n; i++) {
        words[i] = 0;
        if (bit_at(permitted, i))
            load_element(memory, table_address(transfer, *(*next_index)++),
                         stream->result.width, &words[i]);
    }
    result_store(stream->machine, &stream->result, &stream->control, first, words, n);
}

static void scatter_chunk(struct transfer *transfer, size_t first, size_t n,
                          const uint64_t *permitted, const c205_word **next_index)
{
    struct stream *stream = &transfer->stream;
    struct memory *memory = &stream->machine->memory;
    const c205_word *b = source_read(&stream->b, first, n);
    for (size_t i = 0; i < n; i++)
        if (bit_at(permitted, i))
            store_element(memory, table_address(transfer, *(*next_index)++),
                          transfer->table.width, b[i]);
}

static c205_trap transfer_chunks(struct transfer *transfer)
{
    struct stream *stream = &transfer->stream;
    const c205_word *next_index = transfer->indices + transfer->used;
    uint64_t permitted[CHUNK_WORDS];
    c205_trap trap = check_table(transfer);
    if (trap != C205_TRAP_NONE)
        return trap;
    for (size_t first = stream->turn.first, n; first < stream->turn.end; first += n) {
        n = stream_next(stream, first);
        control_read(&stream->control, first, n, permitted);
        (transfer->gather ? gather_chunk : scatter_chunk)(transfer, first, n, permitted,
                                                          &next_index);
    }
    transfer->count = (size_t)(next_index - transfer->indices);
    return stream_end(stream);
}

/* ---- One element at a time ---------------------------------------------- */

/* The words that a scatter has overwritten. They are restored if a later element traps
 * or belongs to a later turn. */
struct undo {
    c205_word *old;
    c205_word *address;
};

static c205_trap transfer_one(struct transfer *transfer, size_t i,
                              const struct undo *undo)
{
    struct stream *stream = &transfer->stream;
    struct c205 *machine = stream->machine;
    c205_word index = *read_indices(transfer, i, 1), word;
    uint64_t table = table_address(transfer, index), to = table;
    unsigned width = transfer->table.width;
    c205_trap trap = C205_TRAP_NONE;
    if (transfer->gather) {
        to = vector_at(&stream->result, i);
        trap = load_element(&machine->memory, table, width, &word);
    } else {
        word = *source_read(&stream->b, i, 1);
    }
    if (trap == C205_TRAP_NONE)
        trap = load_element(&machine->memory, to, width, &undo->old[transfer->count]);
    if (trap == C205_TRAP_NONE)
        trap = store_element(&machine->memory, to, width, word);
    if (trap != C205_TRAP_NONE)
        return machine_fault(machine, trap, table);
    undo->address[transfer->count] = to;
    transfer->indices[transfer->count++] = index;
    return C205_TRAP_NONE;
}

static void put_back(struct transfer *transfer, const struct undo *undo, size_t count)
{
    struct memory *memory = &transfer->stream.machine->memory;
    for (; transfer->count > count; transfer->count--)
        store_element(memory, undo->address[transfer->count - 1], transfer->table.width,
                      undo->old[transfer->count - 1]);
}

/* Transfers all elements, including those of later turns, so a trap of any element
 * occurs before the instruction has an effect. Then restores the elements of later
 * turns or, after a trap, all elements. */
static c205_trap transfer_one_by_one(struct transfer *transfer)
{
    struct stream *stream = &transfer->stream;
    struct c205 *machine = stream->machine;
    struct undo undo = { machine_scratch(machine, SCRATCH_OLD_WORDS),
                         machine_scratch(machine, SCRATCH_ADDRESSES) };
    c205_trap trap = C205_TRAP_NONE;
    if (!undo.old || !undo.address)
        return C205_TRAP_NO_MEMORY;
    size_t done = transfer->count = transfer->used;
    for (size_t i = stream->turn.first; i < stream->n && trap == C205_TRAP_NONE; i++) {
        uint64_t permitted;
        control_read(&stream->control, i, 1, &permitted);
        if (permitted)
            trap = transfer_one(transfer, i, &undo);
        if (i < stream->turn.end)
            done = transfer->count;
    }
    bool all = trap == C205_TRAP_NONE;
    put_back(transfer, &undo, all ? done : transfer->used);
    return all ? stream_end(stream) : trap;
}

static struct vector describe_table(const struct c205 *machine,
                                    const struct decoded *decoded, unsigned operand,
                                    uint16_t slot)
{
    struct vector table = { machine->slot[slot] & ADDRESS_MASK, 0,
                            decoded->width[operand] };
    return table;
}

/* ---- Operands in pages of the host -------------------------------------- */

/* The table elements that a list refers to. All numbers are counts of words. */
struct table_place {
    uint64_t base;             /* start of the table, from address 0 */
    uint64_t low, high;        /* the lowest and the highest element */
    struct page *page;         /* the page of all elements; NULL: there are several
                                  pages */
    struct page *const *pages; /* all pages of a directory, if there are several */
};

#define FIND_ENDS_PARAMETERS \
    (struct table_place * table, const c205_word *indices, size_t n)
LANEWISE void find_ends_span FIND_ENDS_PARAMETERS
{
    int64_t low = INT64_MAX, high = 0; /* vector units compare signed integers */
    for (size_t i = 0; i < n; i++) {
        uint64_t sum = table->base + indices[i];
        int64_t word = (int64_t)(sum & (ADDRESS_SPACE_WORDS - 1));
        low = word < low ? word : low;
        high = word > high ? word : high;
    }
    table->low = (uint64_t)low;
    table->high = (uint64_t)high;
}
static void find_ends FIND_ENDS_PARAMETERS;
VERSIONS(find_ends, find_ends_span, FIND_ENDS_PARAMETERS, (table, indices, n))

static inline struct page *page_of(const struct table_place *table, uint64_t word)
{
    return table->pages[word / C205_PAGE_WORDS % DIRECTORY_PAGES];
}

static inline bool has_page(const struct table_place *table, uint64_t word)
{
    const struct page *page = page_of(table, word);
    return page && !memory_is_untouched(page);
}

/* Returns true if all pages of the range are mapped and allocated, or at least the
 * pages that the list refers to. */
static bool has_pages(const struct table_place *table, const c205_word *indices,
                      size_t n)
{
    uint64_t page = table->low / C205_PAGE_WORDS;
    uint64_t last = table->high / C205_PAGE_WORDS;
    bool there = last - page < n;
    for (; there && page <= last; page++)
        there = has_page(table, page * C205_PAGE_WORDS);
    if (there)
        return true;
    for (size_t i = 0; i < n; i++)
        if (!has_page(table, table->base + indices[i]))
            return false;
    return true;
}

/* Finds the table elements that a list refers to. Returns false if a page is missing or
 * the elements are too far apart. */
static bool find_table(struct table_place *table, const struct c205 *machine,
                       c205_word descriptor, const c205_word *indices, size_t n)
{
    table->base = LOW(descriptor) / WORD_BITS;
    find_ends(table, indices, n);
    uint64_t low = table->low * WORD_BITS, high = table->high * WORD_BITS;
    table->page = NULL;
    table->pages = machine->memory.directory[low >> DIRECTORY_SHIFT];
    if (descriptor % WORD_BITS != 0
        || low >> DIRECTORY_SHIFT != high >> DIRECTORY_SHIFT)
        return false;
    if (low >> PAGE_SHIFT != high >> PAGE_SHIFT)
        return table->pages && has_pages(table, indices, n);
    table->page = memory_page(&machine->memory, low);
    return table->page;
}

static bool meets_table(const struct table_place *table, const c205_word *words,
                        size_t n)
{
    const c205_word *low = table->page->word + table->low % C205_PAGE_WORDS;
    return direct_meets(words, n * sizeof *words, low,
                        (size_t)(table->high - table->low + 1) * sizeof *low);
}

static inline size_t place_in(const struct table_place *table, c205_word index)
{
    return (table->base + index) % C205_PAGE_WORDS;
}

static void record_indices(struct c205 *machine, const c205_word *indices, size_t n,
                           c205_word table)
{
    struct effect *effect = &machine->effect;
    effect->elements = effect->index_count = n;
    effect->indices = indices;
    effect->table = LOW(table);
    effect->table_step = WORD_BITS;
}

static void gather_words(c205_word *c, const struct table_place *table,
                         const c205_word *indices, size_t n)
{
    const struct page *page = table->page;
    if (page) {
        for (size_t i = 0; i < n; i++)
            c[i] = page->word[place_in(table, indices[i])];
        return;
    }
    for (size_t i = 0; i < n; i++) {
        const struct page *from = page_of(table, table->base + indices[i]);
        c[i] = from->word[place_in(table, indices[i])];
    }
}

/* Executes a gather in the host's memory. Returns false, without effect, if the
 * operands are not simple (direct.h). The clock reads the list after the execution, so
 * the result must not overlap the list. The result may overlap the table, because the
 * elements are moved in order. */
static bool gather_directly(struct c205 *machine, const struct decoded *decoded)
{
    c205_word list = machine->slot[decoded->a];
    c205_word to = machine->slot[decoded->fields.c];
    size_t n = min_size(direct_length(list), direct_length(to));
    uint64_t bits = (uint64_t)n * WORD_BITS;
    struct table_place table;
    if (!decoded->plain || decoded->z || !direct_turn(machine, n))
        return false;
    const c205_word *indices = direct_read(machine, list, n);
    c205_word *c = direct_write(machine, to, n);
    if (!indices || !c || direct_meets(c, n * sizeof *c, indices, n * sizeof *c)
        || !find_table(&table, machine, machine->slot[decoded->b], indices, n))
        return false;
    gather_words(c, &table, indices, n);
    machine_touch(machine, LOW(list), bits);
    machine_touch_result(machine, LOW(to), bits);
    record_indices(machine, indices, n, machine->slot[decoded->b]);
    return true;
}

static bool scatter_directly(struct c205 *machine, const struct decoded *decoded)
{
    c205_word list = machine->slot[decoded->a];
    c205_word from = machine->slot[decoded->b];
    size_t n = direct_length(list);
    uint64_t bits = (uint64_t)n * WORD_BITS;
    struct table_place table;
    if (!decoded->plain || decoded->z || !direct_turn(machine, n)
        || decoded->fields.g & C205_G_BROADCAST_B)
        return false;
    const c205_word *indices = direct_read(machine, list, n);
    const c205_word *b = direct_read(machine, from, n);
    if (!indices || !b
        || !find_table(&table, machine, machine->slot[decoded->c], indices, n)
        || !table.page || !table.page->writable || table.page->holds_code
        || meets_table(&table, indices, n))
        return false;
    for (size_t i = 0; i < n; i++)
        table.page->word[place_in(&table, indices[i])] = b[i];
    machine_touch(machine, LOW(list), bits);
    machine_touch(machine, LOW(from), bits);
    record_indices(machine, indices, n, machine->slot[decoded->c]);
    return true;
}

/* ---- The instructions --------------------------------------------------- */

static c205_trap run_transfer(struct transfer *transfer)
{
    struct stream *stream = &transfer->stream;
    struct c205 *machine = stream->machine;
    transfer->indices = machine_scratch(machine, SCRATCH_KEPT);
    if (!transfer->indices)
        return C205_TRAP_NO_MEMORY;
    if (stream->n > 0 && transfer->table.address % transfer->table.width)
        return machine_fault(machine, C205_TRAP_MISALIGNED_OPERAND,
                             transfer->table.address);
    stream->chunk = CHUNK;
    collect_indices(transfer);
    c205_trap trap = is_entangled(transfer) ? transfer_one_by_one(transfer)
                                            : transfer_chunks(transfer);
    if (trap == C205_TRAP_CLOCK_LIMIT)
        machine->resume.kept = transfer->count;
    machine->effect.indices = transfer->indices;
    machine->effect.index_count = transfer->count;
    machine->effect.table = transfer->table.address;
    machine->effect.table_step = transfer->table.width;
    return trap;
}

static c205_trap execute_gather(struct transfer *transfer)
{
    c205_trap trap = stream_claim(&transfer->stream);
    return trap == C205_TRAP_NONE ? run_transfer(transfer) : trap;
}

static c205_trap execute_scatter(struct transfer *transfer)
{
    c205_trap trap = stream_claim_sources(&transfer->stream);
    return trap == C205_TRAP_NONE ? run_transfer(transfer) : trap;
}

/* Evaluates the descriptors of the operands of a gather, in which B is a table and not
 * a stream. */
static c205_trap describe_gather(struct transfer *transfer, struct c205 *machine,
                                 const struct decoded *decoded)
{
    struct stream *stream = &transfer->stream;
    c205_trap trap = stream_describe(stream, machine, decoded);
    stream->b.vector.length = 0;
    transfer->gather = true;
    transfer->periodic = false;
    transfer->table = describe_table(machine, decoded, OPERAND_B, decoded->b);
    return trap;
}

static c205_trap describe_scatter(struct transfer *transfer, struct c205 *machine,
                                  const struct decoded *decoded)
{
    c205_trap trap = stream_describe_sources(&transfer->stream, machine, decoded);
    transfer->gather = transfer->periodic = false;
    transfer->table = describe_table(machine, decoded, OPERAND_C, decoded->c);
    return trap;
}

/* Reads the distance between indices from register A, for an instruction without an
 * index list. */
static void take_period(struct transfer *transfer, const struct decoded *decoded)
{
    struct stream *stream = &transfer->stream;
    transfer->periodic = true;
    transfer->period = stream->machine->slot[decoded->a];
    stream->a.vector.length = 0;
}

c205_trap execute_vector_gather(struct c205 *machine, const struct decoded *decoded)
{
    struct transfer transfer;
    struct stream *stream = &transfer.stream;
    if (gather_directly(machine, decoded))
        return C205_TRAP_NONE;
    c205_trap trap = describe_gather(&transfer, machine, decoded);
    if (trap != C205_TRAP_NONE)
        return trap;
    if (stream->n > stream->a.vector.length)
        stream->n = stream->a.vector.length;
    return execute_gather(&transfer);
}

c205_trap execute_vector_gather_periodic(struct c205 *machine,
                                         const struct decoded *decoded)
{
    struct transfer transfer;
    c205_trap trap = describe_gather(&transfer, machine, decoded);
    if (trap != C205_TRAP_NONE)
        return trap;
    take_period(&transfer, decoded);
    return execute_gather(&transfer);
}

c205_trap execute_vector_scatter(struct c205 *machine, const struct decoded *decoded)
{
    struct transfer transfer;
    if (scatter_directly(machine, decoded))
        return C205_TRAP_NONE;
    c205_trap trap = describe_scatter(&transfer, machine, decoded);
    return trap == C205_TRAP_NONE ? execute_scatter(&transfer) : trap;
}

c205_trap execute_vector_scatter_periodic(struct c205 *machine,
                                          const struct decoded *decoded)
{
    struct transfer transfer;
    c205_trap trap = describe_scatter(&transfer, machine, decoded);
    if (trap != C205_TRAP_NONE)
        return trap;
    take_period(&transfer, decoded);
    transfer.stream.n = transfer.stream.b.vector.length;
    return execute_scatter(&transfer);
}
