/* object.c - looks up lines, segments, regions, symbols and register names of a
 * program. */
#include "asm/object/object.h"

#include <stdlib.h>
#include <string.h>

enum { HALF_BITS = 32 };

const char *asm_contents_name(enum asm_contents contents)
{
    static const char *const names[] = {
        [ASM_NOTHING] = "",    [ASM_CODE] = "code",
        [ASM_WORDS] = "words", [ASM_HALF_WORDS] = "half words",
        [ASM_BITS] = "bits",   [ASM_BYTES] = "bytes",
    };
    return names[contents];
}

const char *asm_form_name(enum asm_form form)
{
    return form == ASM_SCALAR_FORM ? "scalar" : form == ASM_VECTOR_FORM ? "vector" : "";
}

const struct asm_line *object_line(const struct object *object, uint64_t address)
{
    const struct asm_line *lines = object->lines;
    size_t low = 0, high = object->line_count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (lines[middle].address <= address)
            low = middle + 1;
        else
            high = middle;
    }
    return low > 0
                   && address - lines[low - 1].address
                          < HALF_BITS * lines[low - 1].halves
               ? &lines[low - 1]
               : NULL;
}

static bool segment_contains(const c205_segment *segment, uint64_t address)
{
    return segment->words && address >= segment->address
           && address - segment->address < 64 * (uint64_t)segment->length;
}

const c205_segment *object_segment(const struct object *object, uint64_t address)
{
    const c205_segment *segments = object->program.segments;
    for (size_t i = 0; i < object->program.segment_count; i++)
        if (segment_contains(&segments[i], address))
            return &segments[i];
    return NULL;
}

bool object_is_code(const struct object *object, const c205_segment *segment)
{
    const c205_program *program = &object->program;
    bool code = segment_contains(segment, program->entry);
    for (size_t i = 0; !code && i < program->region_count; i++)
        code = segment_contains(segment, program->regions[i].begin);
    return code;
}

const char *object_region(const struct object *object, uint64_t address)
{
    const c205_region *regions = object->program.regions;
    for (size_t i = 0; i < object->program.region_count; i++)
        if (address >= regions[i].begin && address < regions[i].end)
            return regions[i].name;
    return "";
}

const c205_region *object_region_named(const struct object *object, const char *name)
{
    const c205_region *regions = object->program.regions;
    for (size_t i = 0; i < object->program.region_count; i++)
        if (strcmp(regions[i].name, name) == 0)
            return &regions[i];
    return NULL;
}

bool asm_place_is(const struct asm_place *place, const char *file, size_t number)
{
    return place->number == number && strcmp(place->file, file) == 0;
}

bool asm_line_is_called(const struct asm_line *line)
{
    return !asm_place_is(&line->call, line->file, line->number);
}

struct position asm_line_position(const struct asm_line *line)
{
    const struct asm_place *place = &line->reported;
    const char *source = asm_place_is(place, line->file, line->number) ? line->source
                                                                       : place->source;
    const struct position position = { place->file, place->number,
                                       strspn(source, " \t") + 1, source,
                                       strlen(source) };
    return position;
}

static int compare_name(const void *name, const void *symbol)
{
    return strcmp(name, ((const struct asm_symbol *)symbol)->name);
}

const struct asm_symbol *object_symbol(const struct object *object, const char *name)
{
    if (object->symbol_count == 0)
        return NULL;
    return bsearch(name, object->symbols, object->symbol_count, sizeof *object->symbols,
                   compare_name);
}

const char *object_label(const struct object *object, uint64_t address)
{
    for (size_t i = 0; i < object->symbol_count; i++)
        if (object->symbols[i].is_label
            && (uint64_t)object->symbols[i].value == address)
            return object->symbols[i].name;
    return "";
}

const char *object_register_name(const struct object *object, unsigned number,
                                 bool half)
{
    for (size_t i = object->register_count; i-- > 0;)
        if (object->registers[i].half == half && object->registers[i].number == number)
            return object->registers[i].name;
    return "";
}

const char *object_mentioned_name(const struct object *object, uint64_t address,
                                  unsigned number, bool half)
{
    size_t low = 0, high = object->mention_count;
    while (low < high) {
        size_t middle = (low + high) / 2;
        if (object->mentions[middle].address < address)
            low = middle + 1;
        else
            high = middle;
    }
    for (; low < object->mention_count && object->mentions[low].address == address;
         low++) {
        const struct asm_register *named = &object
                                                ->registers[object->mentions[low].name];
        if (named->half == half && named->number == number)
            return named->name;
    }
    return "";
}
