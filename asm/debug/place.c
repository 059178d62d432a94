/* place.c - where in a program: by label, source line, address, name. */
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "asm/debug/parts.h"
#include "asm/operand_view.h"

const char *place_region(const struct debugger *debugger, uint64_t address)
{
    const c205_program *program = &debugger->setup.object->program;

    for (size_t i = 0; i < program->region_count; i++)
        if (address >= program->regions[i].begin
            && address < program->regions[i].end)
            return program->regions[i].name;
    return "";
}

static bool is_region(const struct debugger *debugger, const char *name,
                      const char **region)
{
    const c205_program *program = &debugger->setup.object->program;

    for (size_t i = 0; i < program->region_count; i++)
        if (strcmp(program->regions[i].name, name) == 0) {
            *region = program->regions[i].name;
            return true;
        }
    return false;
}

/* ---- Source lines --------------------------------------------------------- */

/* "dir/name.s" is called name.s as well. */
static bool is_file(const char *file, const char *name)
{
    size_t length = strlen(file), ending = strlen(name);

    return strcmp(file, name) == 0
           || (ending < length && file[length - ending - 1] == '/'
               && strcmp(file + length - ending, name) == 0);
}

/* The first code of that line, or of the next that has any. */
static bool find_line(struct debugger *debugger, const char *file,
                      unsigned long number, uint64_t *address)
{
    const struct object *object = debugger->setup.object;
    const struct asm_line *found = NULL;

    for (size_t i = 0; i < object->line_count; i++) {
        const struct asm_line *line = &object->lines[i];

        if (line->number >= number && line->halves > 0
            && is_file(line->file, file)
            && (!found || line->number < found->number))
            found = line;
    }
    if (!found)
        return debug_fault(debugger,
                           object->line_count == 0
                               ? "the source lines of %.100s are not known"
                               : "%.100s has no code at line %lu or behind",
                           file, number);
    *address = found->address;
    return true;
}

/* NAME:LINE, or LINE of the program's own file. */
static bool read_line(struct debugger *debugger, struct rest *rest,
                      uint64_t *address, bool *good)
{
    const char *at = rest->at, *colon = at;
    char name[TEXT_MOST];
    size_t length;

    while (*colon && !isspace((unsigned char)*colon) && *colon != ':')
        colon++;
    length = (size_t)(colon - at);
    if (isdigit((unsigned char)*at) && *colon != ':') {
        unsigned long number = strtoul(at, (char **)&rest->at, 10);

        *good = find_line(debugger, debugger->setup.name, number, address);
        return true;
    }
    if (*colon != ':' || !isdigit((unsigned char)colon[1])
        || length >= sizeof name)
        return false;
    memcpy(name, at, length);
    name[length] = '\0';
    *good = find_line(debugger, name,
                      strtoul(colon + 1, (char **)&rest->at, 10), address);
    return true;
}

/* ---- Places --------------------------------------------------------------- */

bool place_address(struct debugger *debugger, struct rest *rest,
                   uint64_t *address)
{
    bool good;

    rest_skip(rest);
    if (*rest->at == '*') {
        rest->at++;
        return debug_address(debugger, rest, address);
    }
    if (read_line(debugger, rest, address, &good))
        return good;
    return debug_address(debugger, rest, address);
}

static size_t take_name(struct rest *rest, char name[TEXT_MOST])
{
    size_t length = 0;

    rest_skip(rest);
    while (rest->at[length] && !isspace((unsigned char)rest->at[length])
           && length + 1 < TEXT_MOST) {
        name[length] = rest->at[length];
        length++;
    }
    name[length] = '\0';
    rest->at += length;
    return length;
}

/* The two instructions behind a LINKV are executed with it. */
static uint64_t link_of(const struct debugger *debugger, uint64_t address)
{
    struct instruction_view view;

    for (uint64_t back = 32; back <= 96; back += 32) {
        uint64_t end = address - back;

        if (back > address)
            break;
        view_decode(&view, machine_of(debugger), end);
        if (!view.insn || view.insn->timing != C205_TIMING_vlink)
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

bool place_read(struct debugger *debugger, struct rest *rest,
                struct stop_point *stop)
{
    char name[TEXT_MOST];

    if (rest_end(rest))
        return debug_fault(debugger, "where? a label, a line, FILE:LINE, "
                                     "*ADDRESS, insn NAME or region NAME");
    if (rest_take(rest, "insn")) {
        size_t length = take_name(rest, name);

        stop->kind = STOP_INSN;
        stop->insn = c205_insn_named(name, length);
        return stop->insn
               || debug_fault(debugger, "no instruction is called '%.60s'",
                              name);
    }
    if (rest_take(rest, "region")) {
        take_name(rest, name);
        stop->kind = STOP_ENTRY;
        return is_region(debugger, name, &stop->region)
               || debug_fault(debugger, "no region is called '%.60s'", name);
    }
    stop->kind = STOP_AT;
    if (!place_address(debugger, rest, &stop->address))
        return false;
    stop->address = link_of(debugger, stop->address);
    return true;
}
