/* assemble.c - runs the passes of an assembly and reports errors of whole files. */
#include "asm/text/assemble.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "asm/text/constant_folder.h"
#include "asm/text/expand.h"
#include "asm/text/lex.h"
#include "base/text_file.h"

/* Returns the reason for which a text cannot be the name of a constant, or NULL if it
 * can. */
static const char *name_fault(const char *name)
{
    size_t length = strlen(name);
    const char *at = name;
    while (is_name_part(*at))
        at++;
    return !is_name_start(*name) || *at     ? "is not a name"
           : is_register_name(name, length) ? "is a register"
           : c205_insn_named(name, length)  ? "is an instruction"
                                            : NULL;
}

static bool check_name(struct assembler *assembler, const char *file, const char *name)
{
    const char *fault = name_fault(name);
    char message[160];
    snprintf(message, sizeof message, "'%.100s' cannot be defined: it %s", name,
             fault ? fault : "");
    return !fault || report_file(assembler->diagnostics, file, message);
}

static bool define(struct assembler *assembler, const char *file)
{
    const struct asm_define *define = NULL;
    struct value value = { VALUE_INTEGER, 0 };
    if (assembler->options)
        define = assembler->options->defines;
    for (; define && define->name; define++) {
        struct symbol *symbol = symbol_intern(assembler, define->name,
                                              strlen(define->name));
        if (!symbol || !check_name(assembler, file, define->name))
            return false;
        symbol->kind = SYMBOL_CONSTANT;
        symbol->value = value;
        symbol->value.bits = (uint64_t)define->value;
    }
    return true;
}

static void start(struct assembler *assembler)
{
    static const struct section sections[] = { { .name = ".code", .at = CODE_ORIGIN },
                                               { .name = ".data", .at = DATA_ORIGIN } };
    memcpy(assembler->sections, sections, sizeof sections);
    assembler->section = &assembler->sections[0];
}

/* Copies the text, because the assembler modifies it. Returns false after a report. */
static bool take_text(struct assembler *assembler, struct asm_source *source)
{
    size_t length = (size_t)(source->end - source->text);
    char *text = arena_text(assembler->arena, source->text, length);
    c205_error error;
    if (!text)
        return false;
    if (!text_clean(text, &length, &error))
        return report_file(assembler->diagnostics, source->name, error.message);
    source->text = text;
    source->end = text + length;
    return true;
}

static struct object *run_passes(struct assembler *assembler, struct asm_source *source)
{
    const struct line *line;
    bool halted;
    start(assembler);
    assembler->expander = expander_new(assembler, source);
    if (!assembler->expander || !define(assembler, source->name))
        return NULL;
    while ((line = expander_next(assembler->expander)) != NULL
           && !assembler->arena->failed)
        parse_line(assembler, line);
    halted = assembler->expander->halted;
    assembler->expander = NULL;
    if (halted || assembler->arena->failed || too_many_errors(assembler))
        return NULL;
    return build_object(assembler);
}

static struct object *assemble(struct asm_source *source,
                               const struct asm_options *options,
                               struct diagnostics *diagnostics)
{
    struct arena arena = { NULL, false };
    struct assembler *assembler = arena_take(&arena, sizeof *assembler);
    struct object *object = NULL;
    if (assembler) {
        assembler->arena = &arena;
        assembler->options = options;
        assembler->diagnostics = diagnostics;
        assembler->first_error = diagnostics->errors;
        if (take_text(assembler, source))
            object = run_passes(assembler, source);
        constant_folder_free(assembler->constant_folder);
    }
    if (arena.failed) {
        report_file(diagnostics, source->name, "the host is out of memory");
        object_free(object);
        object = NULL;
    }
    arena_free(&arena);
    return object;
}

struct object *assemble_bytes(const char *name, const char *text, size_t length,
                              const struct asm_options *options,
                              struct diagnostics *diagnostics)
{
    struct asm_source source;
    source.name = name;
    source.text = text;
    source.end = text + length;
    return assemble(&source, options, diagnostics);
}

struct object *assemble_text(const char *name, const char *text,
                             const struct asm_options *options,
                             struct diagnostics *diagnostics)
{
    return assemble_bytes(name, text, strlen(text), options, diagnostics);
}

struct object *assemble_file(const char *path, const struct asm_options *options,
                             struct diagnostics *diagnostics)
{
    struct object *object;
    c205_error error;
    size_t length;
    char *text = text_file_read(path, FILE_LARGEST, &length, &error);
    if (!text) {
        report_file(diagnostics, path, error.message);
        return NULL;
    }
    object = assemble_bytes(path, text, length, options, diagnostics);
    free(text);
    return object;
}

static bool is_used(const struct object *object, const char *name)
{
    const struct asm_symbol *symbol = object_symbol(object, name);
    return symbol && symbol->is_used;
}

const char *asm_unused_define(const struct asm_define *defines,
                              struct object *const *objects, size_t count)
{
    for (; defines && defines->name; defines++) {
        size_t i = 0;
        while (i < count && !is_used(objects[i], defines->name))
            i++;
        if (i == count)
            return defines->name;
    }
    return NULL;
}
