/* listing.c - prints source lines with their words in hex. */
#include "asm/view/listing.h"

#include <inttypes.h>

/* Prints a half word in hex. Returns false if it is in no segment, because zeros are
 * not stored. */
static bool put_half(const struct object *object, uint64_t address,
                     const struct sink *sink)
{
    const c205_segment *segment = object_segment(object, address);
    uint64_t offset;
    c205_word word;
    if (!segment)
        return false;
    offset = address - segment->address;
    word = segment->words[offset / 64];
    sink_print(sink, "%08" PRIX32, (uint32_t)(offset % 64 ? word : word >> 32));
    return true;
}

/* Prints the words of a source line, two half words in a row. The source is in the
 * first row. */
static void put_line(const struct object *object, const struct asm_line *line,
                     const struct sink *sink)
{
    uint64_t at = 0;
    do {
        uint64_t address = line->address + 32 * at;
        bool shown;
        sink_print(sink, "%12" PRIX64 "  ", address);
        shown = put_half(object, address, sink);
        if (!shown)
            sink_put(sink, "...             ");
        else if (at + 1 == line->halves || !put_half(object, address + 32, sink))
            sink_put(sink, "        ");
        if (at == 0)
            sink_print(sink, "  %5zu  %s", line->number, line->source);
        sink_put(sink, "\n");
        at = shown ? at + 2 : line->halves;
    } while (at < line->halves);
}

void listing(const struct object *object, const struct sink *sink)
{
    const char *file = "";
    for (size_t i = 0; i < object->line_count; i++) {
        const struct asm_line *line = &object->lines[i];
        const char *a = file, *b = line->file;
        while (*a && *a == *b)
            a++, b++;
        if (*a != *b)
            sink_print(sink, "%s\n", line->file);
        file = line->file;
        put_line(object, line, sink);
    }
}
