/* place.c - parses places of a program: labels, source lines, addresses, names. */
#include <ctype.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "asm/debug/debug_internal.h"
#include "asm/view/operand_view.h"

/* ---- Source lines --------------------------------------------------------- */

/* Returns true if the path of a file ends in "/" and the name. */
static bool ends_with(const char *file, const char *name)
{
    size_t length = strlen(file), ending = strlen(name);
    return ending < length && file[length - ending - 1] == '/'
           && strcmp(file + length - ending, name) == 0;
}

static bool is_whole(const char *file, const char *name)
{
    return strcmp(file, name) == 0;
}

static const char *find_file(const struct object *object, const char *name,
                             bool (*is_file)(const char *, const char *))
{
    for (size_t i = 0; i < object->line_count; i++) {
        const struct asm_line *line = &object->lines[i];
        if (is_file(line->file, name))
            return line->file;
        if (is_file(line->shown.file, name))
            return line->shown.file;
        if (is_file(line->call.file, name))
            return line->call.file;
    }
    return NULL;
}

/* The result of find_line: a source line that has code or calls a macro with code. */
struct line_place {
    const char *file; /* name in the object */
    size_t number;
    uint64_t address; /* address of its first code */
    size_t wanted;    /* line number in the command */
};

static void consider(struct line_place *found, const char *file, size_t number,
                     size_t least, const char *name, uint64_t address)
{
    if (number < least || strcmp(file, name) != 0
        || (found->file && number >= found->number))
        return;
    found->file = file;
    found->number = number;
    found->address = address;
}

/* Finds a line, or the next line that has code or calls a macro with code. */
static bool find_line(struct debugger *debugger, const char *name, size_t number,
                      struct line_place *found)
{
    const struct object *object = debugger->setup.object;
    const char *file = find_file(object, name, is_whole);
    *found = (struct line_place){ .wanted = number };
    if (number == 0)
        return debug_fault(debugger, "lines are counted from 1");
    if (!file)
        file = find_file(object, name, ends_with);
    for (size_t i = 0; file && i < object->line_count; i++) {
        const struct asm_line *line = &object->lines[i];
        if (!line->is_code)
            continue;
        consider(found, line->file, line->number, number, file, line->address);
        consider(found, line->shown.file, line->shown.number, number, file,
                 line->address);
        consider(found, line->call.file, line->call.number, number, file,
                 line->address);
    }
    return found->file
           || debug_fault(
               debugger,
               object->line_count == 0
                   ? "the source lines of %.100s are not known: debug its text"
                   : "%.100s has no code at line %zu or after it",
               name, number);
}

bool place_begins(const struct debugger *debugger, const char *file, size_t number,
                  uint64_t address)
{
    const struct object *object = debugger->setup.object;
    const struct asm_line *line = object_line(object, address);
    if (!line || line->address != address || !line->is_code)
        return false;
    if (line->number == number && strcmp(line->file, file) == 0)
        return true;
    if (asm_place_is(&line->call, file, number))
        return line->call.begins;
    return asm_place_is(&line->shown, file, number) && line->shown.begins;
}

/* Parses NAME:LINE, or LINE of the program's file. Returns false if the text is another
 * kind of place. Otherwise, *good is true if the program has the line;
 * if not, the error has been reported. */
static bool read_line(struct debugger *debugger, struct text_cursor *cursor,
                      struct line_place *found, bool *good)
{
    const char *at = cursor->at, *colon = at;
    char name[MAX_TEXT];
    size_t length;
    if (*at == '-') {
        *good = debug_fault(debugger,
                            "a place cannot begin with '-': lines are counted from 1");
        return true;
    }

    while (*colon && !isspace((unsigned char)*colon) && *colon != ':')
        colon++;
    length = (size_t)(colon - at);
    if (isdigit((unsigned char)*at) && *colon != ':'
        && !isalpha((unsigned char)at[1])) {
        *good = find_line(debugger, debugger->setup.name,
                          strtoul(at, (char **)&cursor->at, 10), found);
        return true;
    }
    if (*colon != ':' || !isdigit((unsigned char)colon[1]) || length >= sizeof name)
        return false;
    memcpy(name, at, length);
    name[length] = '\0';
    *good = find_line(debugger, name, strtoul(colon + 1, (char **)&cursor->at, 10),
                      found);
    return true;
}

/* ---- Places --------------------------------------------------------------- */

bool place_address(struct debugger *debugger, struct text_cursor *cursor,
                   uint64_t *address)
{
    struct line_place found = { .file = NULL };
    bool good;
    if (text_cursor_sign(cursor, "*") || !read_line(debugger, cursor, &found, &good))
        return debug_address(debugger, cursor, address);
    *address = found.address;
    return good;
}

static size_t take_name(struct text_cursor *cursor, char name[MAX_TEXT])
{
    size_t length = 0;
    text_cursor_skip(cursor);
    while (cursor->at[length] && !isspace((unsigned char)cursor->at[length])
           && length + 1 < MAX_TEXT) {
        name[length] = cursor->at[length];
        length++;
    }
    name[length] = '\0';
    cursor->at += length;
    return length;
}

/* Returns true if an instruction of the program's text begins at an address. */
static bool begins_line(const struct debugger *debugger, uint64_t address)
{
    const struct asm_line *line = object_line(debugger->setup.object, address);
    return line && line->is_code && line->address == address;
}

/* Returns true if an instruction begins at the address. Without source lines, the code
 * segment is decoded from its first word up to the address. */
static bool begins_decoded(const struct debugger *debugger, uint64_t address)
{
    const struct object *object = debugger->setup.object;
    const c205_segment *segment = object_segment(object, address);
    struct instruction_view view = { .insn = NULL };
    uint64_t at;
    if (!segment || !object_is_code(object, segment))
        return false;
    for (at = segment->address; at <= address; at += 32 * (uint64_t)view.halves) {
        view_decode(&view, machine_of(debugger), at);
        if (at == address)
            return view.insn;
    }
    return false;
}

static bool begins_code(const struct debugger *debugger, uint64_t address)
{
    return debugger->setup.object->line_count > 0 ? begins_line(debugger, address)
                                                  : begins_decoded(debugger, address);
}

/* Returns the address of the LINKV if the instruction at the address belongs to a
 * linked pair, otherwise the address itself. The LINKV is one to three half words
 * before the instruction. Code cannot be decoded backward, because instructions have
 * different lengths, so each of these addresses is tried; a source line must also begin
 * there. */
uint64_t place_of(const struct debugger *debugger, uint64_t address)
{
    struct instruction_view view;
    for (uint64_t back = 32; back <= 96; back += 32) {
        uint64_t end = address - back;
        if (back > address)
            break;
        view_decode(&view, machine_of(debugger), end);
        if (!view.insn || view.insn->timing != C205_TIMING_vlink
            || !begins_line(debugger, end))
            continue;
        end += 32 * (uint64_t)view.halves;
        if (end == address)
            return address - back;
        view_decode(&view, machine_of(debugger), end);
        if (view.insn && end + 32 * (uint64_t)view.halves == address)
            return address - back;
    }
    return address;
}

/* Sets the address and the source line of a breakpoint. If a LINKV links the
 * instruction, the breakpoint is at the LINKV. */
static void be_at(const struct debugger *debugger, uint64_t address,
                  struct breakpoint *stop)
{
    const struct asm_line *line;
    stop->kind = BREAK_ADDRESS;
    stop->address = place_of(debugger, address);
    line = object_line(debugger->setup.object, stop->address);
    stop->file = line ? line->file : NULL;
    stop->line = line ? line->number : 0;
}

static void be_at_line(const struct debugger *debugger, const struct line_place *found,
                       struct breakpoint *stop)
{
    be_at(debugger, found->address, stop);
    if (stop->address != found->address)
        return;
    stop->kind = BREAK_LINE;
    stop->file = found->file;
    stop->line = found->number;
}

bool place_line(struct debugger *debugger, const char *file, size_t number,
                struct breakpoint *stop)
{
    struct line_place found;
    if (!find_line(debugger, file, number, &found))
        return false;
    snprintf(stop->text, sizeof stop->text, "%s:%zu", found.file, found.number);
    be_at_line(debugger, &found, stop);
    return true;
}

bool place_code(struct debugger *debugger, struct text_cursor *cursor,
                uint64_t *address)
{
    return place_address(debugger, cursor, address)
           && (begins_code(debugger, *address)
               || debug_fault(debugger, "no instruction begins at %" PRIX64, *address));
}

/* Reads a source line or an address and sets the breakpoint there. Sets *moved to true
 * if the breakpoint is at a later line or at another instruction than the text
 * names. */
static bool read_address(struct debugger *debugger, struct text_cursor *cursor,
                         struct breakpoint *stop, bool *moved)
{
    struct line_place found = { .file = NULL };
    uint64_t address;
    bool good;
    text_cursor_skip(cursor);
    if (*cursor->at != '*' && read_line(debugger, cursor, &found, &good)) {
        if (good)
            be_at_line(debugger, &found, stop);
        *moved = stop->line != found.wanted;
        return good;
    }
    if (!place_code(debugger, cursor, &address))
        return false;
    be_at(debugger, address, stop);
    *moved = stop->address != address;
    return true;
}

static bool read_place(struct debugger *debugger, struct text_cursor *cursor,
                       struct breakpoint *stop, bool *moved)
{
    char name[MAX_TEXT];
    if (text_cursor_take(cursor, "insn")) {
        size_t length = take_name(cursor, name);
        stop->kind = BREAK_INSN;
        stop->insn = c205_insn_named(name, length);
        return stop->insn || debug_fault(debugger, "unknown instruction '%.60s'", name);
    }
    if (text_cursor_take(cursor, "region")) {
        const c205_region *region;
        take_name(cursor, name);
        region = object_region_named(debugger->setup.object, name);
        stop->kind = BREAK_ENTRY;
        stop->region = region ? region->name : NULL;
        return region || debug_fault(debugger, "unknown region '%.60s'", name);
    }
    return read_address(debugger, cursor, stop, moved);
}

static void add_position(struct breakpoint *stop)
{
    size_t length = strlen(stop->text);
    if (stop->file)
        snprintf(stop->text + length, sizeof stop->text - length, " (at %s:%zu)",
                 stop->file, stop->line);
    else
        snprintf(stop->text + length, sizeof stop->text - length, " (at %" PRIX64 ")",
                 stop->address);
}

bool place_read(struct debugger *debugger, struct text_cursor *cursor,
                struct breakpoint *stop)
{
    const char *from;
    bool moved = false;
    if (text_cursor_end(cursor))
        return debug_fault(
            debugger,
            "expected a label, a line, FILE:LINE, *ADDRESS, insn NAME or region NAME");
    from = cursor->at;
    if (!read_place(debugger, cursor, stop, &moved))
        return false;
    text_cursor_text(from, cursor, stop->text);
    if (moved)
        add_position(stop);
    return true;
}

/* ---- The instruction before ------------------------------------------------- */

/* Returns an address from which the code up to `address` can be decoded. Without source
 * lines it is the start of the code segment, but at most 1024 half words back. Outside
 * of all segments each half word counts as an instruction. */
static uint64_t read_from(const struct debugger *debugger, uint64_t address)
{
    enum { FAR_BACK = 32 * 1024 };
    const struct object *object = debugger->setup.object;
    const struct asm_line *line = object_line(object, address);
    const c205_segment *segment = NULL;
    if (line)
        return line->is_code ? line->address : address;
    if (object->line_count == 0)
        segment = object_segment(object, address);
    if (!segment)
        return address;
    return address - segment->address < FAR_BACK ? segment->address
                                                 : address - FAR_BACK;
}

uint64_t place_before(const struct debugger *debugger, uint64_t address)
{
    uint64_t at, next = address < 32 ? 0 : read_from(debugger, address - 32);
    do {
        struct instruction_view view;
        at = next;
        view_decode(&view, machine_of(debugger), at);
        next = at + 32 * (uint64_t)view.halves;
    } while (next < address);
    return at;
}
