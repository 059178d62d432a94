/* disassemble.c - writes a program as text of the assembler. */
#include "asm/object/disassemble.h"

#include "base/array.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "asm/object/instruction_text.h"
#include "asm/object/syntax.h"

enum { WORD_BITS = 64, HALF_BITS = 32, WORDS_A_LINE = 4 };

static const char indent[] = "        ";

unsigned disassemble_one(c205_word word, uint64_t address,
                         char text[DISASSEMBLE_TEXT_SIZE])
{
    static const struct labels none;
    struct text_line line = { "", 0 };
    struct sink sink = text_line_sink(&line);
    unsigned halves = instruction_write(word, address, 2, &none, &sink);
    memcpy(text, line.text, line.length + 1);
    return halves;
}

struct addresses {
    uint64_t *items;
    size_t count;
};

struct disassembler {
    const struct object *object;
    const c205_program *program;
    const struct sink *sink;
    const c205_region *region;   /* region at the current address, or NULL */
    struct addresses boundaries; /* addresses where instructions start */
    struct addresses targets;    /* addresses that instructions refer to */
    struct labels labels;        /* targets that are boundaries, and symbols whose names
                                    can be written */
    bool failed;
};

/* ---- Addresses ---- */

static void add_address(struct disassembler *disassembler, struct addresses *addresses,
                        uint64_t address)
{
    if (!array_add(&addresses->items, &addresses->count, &address, sizeof address))
        disassembler->failed = true;
}

static int compare_addresses(const void *a, const void *b)
{
    uint64_t first = *(const uint64_t *)a, second = *(const uint64_t *)b;
    return (first > second) - (first < second);
}

static void sort(struct addresses *addresses)
{
    if (addresses->count > 0)
        qsort(addresses->items, addresses->count, sizeof *addresses->items,
              compare_addresses);
}

static bool addresses_hold(const struct addresses *addresses, uint64_t address)
{
    return addresses->count > 0
           && bsearch(&address, addresses->items, addresses->count, sizeof address,
                      compare_addresses);
}

/* ---- Code ---- */

static uint64_t end_of(const c205_segment *segment)
{
    return segment->address + WORD_BITS * (uint64_t)segment->length;
}

static bool lies_in(uint64_t address, const c205_segment *segment)
{
    return address >= segment->address && address < end_of(segment);
}

/* Returns the next address at which an instruction must begin: the entry, a bound of a
 * region, or the end of the segment. */
static uint64_t next_stop(const c205_program *program, const c205_segment *segment,
                          uint64_t address)
{
    uint64_t stop = end_of(segment);
    if (program->entry > address && program->entry < stop)
        stop = program->entry;
    for (size_t i = 0; i < program->region_count; i++) {
        const c205_region *region = &program->regions[i];
        if (region->begin > address && region->begin < stop)
            stop = region->begin;
        if (region->end > address && region->end < stop)
            stop = region->end;
    }
    return stop;
}

static c205_word word_at(const c205_segment *segment, uint64_t address)
{
    uint64_t offset = address - segment->address;
    size_t index = (size_t)(offset / WORD_BITS);
    c205_word word = segment->words[index];
    if (offset % WORD_BITS == 0)
        return word;
    word <<= HALF_BITS;
    if (index + 1 < segment->length)
        word |= segment->words[index + 1] >> HALF_BITS;
    return word;
}

typedef void visit(struct disassembler *, const c205_segment *, uint64_t address,
                   unsigned halves, const char *text);

/* Calls the visitor for every instruction of a segment, with its address, length and
 * text. */
static void walk(struct disassembler *disassembler, const c205_segment *segment,
                 visit *visitor)
{
    uint64_t address = segment->address;
    while (address < end_of(segment) && !disassembler->failed) {
        struct text_line line = { "", 0 };
        struct sink sink = text_line_sink(&line);
        uint64_t stop = next_stop(disassembler->program, segment, address);
        unsigned halves = instruction_write(word_at(segment, address), address,
                                            stop - address < WORD_BITS ? 1 : 2,
                                            &disassembler->labels, &sink);
        visitor(disassembler, segment, address, halves, line.text);
        address += halves * HALF_BITS;
    }
}

static void note(struct disassembler *disassembler, const c205_segment *segment,
                 uint64_t address, unsigned halves, const char *text)
{
    uint64_t target;
    (void)halves;
    (void)text;
    add_address(disassembler, &disassembler->boundaries, address);
    if (instruction_address(word_at(segment, address), address, &target))
        add_address(disassembler, &disassembler->targets, target);
}

static bool is_name(const char *text)
{
    if (!is_name_start(*text))
        return false;
    while (is_name_part(*text))
        text++;
    return *text == '\0';
}

static void open_region(struct disassembler *disassembler, const c205_region *region)
{
    const struct sink *sink = disassembler->sink;
    const char *at = region->name;
    if (is_name(at)) {
        sink_print(sink, "%s.kernel %s\n", indent, at);
    } else {
        sink_print(sink, "%s.kernel \"", indent);
        for (; *at; at++)
            sink_print(sink, *at == '"' || *at == '\\' ? "\\%c" : "%c", *at);
        sink_put(sink, "\"\n");
    }
    disassembler->region = region;
}

/* Writes the directives that end and start regions at an address. A region that
 * overlaps another or leaves its segment cannot be written and is omitted. */
static void turn_region(struct disassembler *disassembler, const c205_segment *segment,
                        uint64_t address)
{
    const c205_program *program = disassembler->program;
    if (disassembler->region && disassembler->region->end == address) {
        sink_print(disassembler->sink, "%s.endkernel\n", indent);
        disassembler->region = NULL;
    }
    for (size_t i = 0; i < program->region_count && !disassembler->region; i++) {
        const c205_region *region = &program->regions[i];
        if (region->begin == address && address < end_of(segment)
            && region->end > address && region->end <= end_of(segment) && *region->name)
            open_region(disassembler, region);
    }
}

static void put_label(const struct disassembler *disassembler, uint64_t address)
{
    if (!label_at(&disassembler->labels, address))
        return;
    label_write(&disassembler->labels, address, disassembler->sink);
    sink_put(disassembler->sink, ":\n");
}

static void show_line(struct disassembler *disassembler, const c205_segment *segment,
                      uint64_t address, unsigned halves, const char *text)
{
    (void)halves;
    turn_region(disassembler, segment, address);
    put_label(disassembler, address);
    sink_print(disassembler->sink, "%s%s\n", indent, text);
}

/* ---- Data ---- */

static size_t count_zeros(const c205_word *words, size_t count)
{
    size_t i = 0;
    while (i < count && words[i] == 0)
        i++;
    return i;
}

static size_t put_data_line(const struct sink *sink, const c205_word *words,
                            size_t count)
{
    char text[C205_TEXT_SIZE];
    size_t i;
    for (i = 0; i < count && i < WORDS_A_LINE; i++) {
        if (i > 0 && count_zeros(words + i, count - i) >= WORDS_A_LINE)
            break;
        c205_to_hex(words[i], text);
        sink_print(sink, i ? ", X'%s'" : "        .word X'%s'", text);
    }
    sink_put(sink, "\n");
    return i;
}

/* Returns the number of words from an address to the next label, at most `most`. */
static size_t words_together(const struct disassembler *disassembler, uint64_t address,
                             size_t most)
{
    const struct labels *labels = &disassembler->labels;
    size_t low = 0, high = labels->count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (labels->items[middle].address <= address)
            low = middle + 1;
        else
            high = middle;
    }
    if (low < labels->count
        && (labels->items[low].address - address) / WORD_BITS < most)
        most = (size_t)((labels->items[low].address - address) / WORD_BITS);
    return most;
}

static void show_data(const struct disassembler *disassembler,
                      const c205_segment *segment)
{
    const struct sink *sink = disassembler->sink;
    const c205_word *words = segment->words;
    size_t i = 0, zeros, count;
    while (i < segment->length) {
        uint64_t address = segment->address + WORD_BITS * (uint64_t)i;
        put_label(disassembler, address);
        count = words_together(disassembler, address, segment->length - i);
        zeros = words ? count_zeros(words + i, count) : count;
        if (words && zeros < WORDS_A_LINE) {
            i += put_data_line(sink, words + i, count);
        } else {
            sink_print(sink, "%s.space %zu\n", indent, zeros);
            i += zeros;
        }
    }
}

/* ---- The program ---- */

static void add_label(struct disassembler *disassembler, uint64_t address,
                      const char *name)
{
    struct label label = { .address = address, .name = name };
    if (!array_add(&disassembler->labels.items, &disassembler->labels.count, &label,
                   sizeof label))
        disassembler->failed = true;
}

/* Sorts by address. At the same address, a label with a name comes first. */
static int compare_labels(const void *a, const void *b)
{
    const struct label *first = a, *second = b;
    if (first->address != second->address)
        return first->address < second->address ? -1 : 1;
    if (!first->name || !second->name)
        return (first->name == NULL) - (second->name == NULL);
    return strcmp(first->name, second->name);
}

/* Sorts the labels and removes all but one label at each address. */
static void sort_labels(struct labels *labels)
{
    size_t count = 0;
    if (labels->count > 0)
        qsort(labels->items, labels->count, sizeof *labels->items, compare_labels);
    for (size_t i = 0; i < labels->count; i++)
        if (count == 0 || labels->items[i].address != labels->items[count - 1].address)
            labels->items[count++] = labels->items[i];
    labels->count = count;
}

/* Returns true if the disassembly has a line at the address, so the line can have a
 * label. */
static bool can_be_labelled(const struct disassembler *disassembler, uint64_t address)
{
    const c205_program *program = disassembler->program;
    for (size_t i = 0; i < program->segment_count; i++)
        if (lies_in(address, &program->segments[i]))
            return object_is_code(disassembler->object, &program->segments[i])
                       ? addresses_hold(&disassembler->boundaries, address)
                       : address % WORD_BITS == 0;
    return false;
}

/* Returns true if the name of a symbol can be written as a label. An object file may
 * contain any text as a name, and duplicates. Names of the form L400000 are reserved
 * for generated labels. Duplicates are adjacent, because symbols are sorted by name. */
static bool has_own_name(const struct disassembler *disassembler, size_t i)
{
    enum { LONGEST = 40 };
    const struct asm_symbol *symbol = &disassembler->object->symbols[i];
    size_t length = strlen(symbol->name);
    return symbol->is_label && is_name(symbol->name) && length <= LONGEST
           && !(*symbol->name == 'L'
                && strspn(symbol->name + 1, "0123456789ABCDEF") == length - 1)
           && !is_register_name(symbol->name, length)
           && (i == 0 || strcmp(symbol->name, symbol[-1].name) != 0)
           && can_be_labelled(disassembler, (uint64_t)symbol->value);
}

static void collect(struct disassembler *disassembler)
{
    const c205_program *program = disassembler->program;
    for (size_t i = 0; i < program->segment_count; i++)
        if (object_is_code(disassembler->object, &program->segments[i]))
            walk(disassembler, &program->segments[i], note);
    add_address(disassembler, &disassembler->targets, program->entry);
    sort(&disassembler->boundaries);
    for (size_t i = 0; i < disassembler->targets.count; i++)
        if (addresses_hold(&disassembler->boundaries, disassembler->targets.items[i]))
            add_label(disassembler, disassembler->targets.items[i], NULL);
    for (size_t i = 0; i < disassembler->object->symbol_count; i++)
        if (has_own_name(disassembler, i))
            add_label(disassembler, (uint64_t)disassembler->object->symbols[i].value,
                      disassembler->object->symbols[i].name);
    sort_labels(&disassembler->labels);
}

static void show_segment(struct disassembler *disassembler, const c205_segment *segment)
{
    bool code = object_is_code(disassembler->object, segment);
    sink_print(disassembler->sink, "%s%s\n%s.org 0x%" PRIX64 "\n", indent,
               code ? ".code" : ".data", indent, segment->address);
    if (code)
        walk(disassembler, segment, show_line);
    else
        show_data(disassembler, segment);
    turn_region(disassembler, segment, end_of(segment));
}

bool disassemble(const struct object *object, const struct sink *sink)
{
    static const struct disassembler empty;
    struct disassembler disassembler = empty;
    disassembler.object = object;
    disassembler.program = &object->program;
    disassembler.sink = sink;
    collect(&disassembler);
    sink_print(sink, "%s.entry ", indent);
    label_write(&disassembler.labels, object->program.entry, sink);
    sink_put(sink, "\n");
    if (object->program.warm)
        sink_print(sink, "%s.warm\n", indent);
    for (size_t i = 0; i < object->program.segment_count; i++)
        if (object->program.segments[i].length > 0)
            show_segment(&disassembler, &object->program.segments[i]);
    free(disassembler.boundaries.items);
    free(disassembler.targets.items);
    free(disassembler.labels.items);
    return !disassembler.failed;
}
