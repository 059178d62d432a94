/* assemble.h - assembles the text of a program into an object that
 * the machine can load.
 *
 *   lex -> expand (includes, macros, repetition, conditions) -> parse ->
 *   encode -> object
 *
 * docs/assembly.md describes the language. These functions neither print nor exit.
 * Errors of a text are collected, so one run reports all of them.
 */
#ifndef ASM_ASSEMBLE_H
#define ASM_ASSEMBLE_H

#include "asm/object/object.h"

struct text;

struct asm_define {
    const char *name;
    int64_t value;
};

struct asm_options {
    const struct asm_define *defines; /* constants that are defined before the first
                                         line; the last has a NULL name; NULL: none. An
                                         invalid name is an error. */
    const char *const *search;        /* folders for .include, with NULL at the end, or
                                         NULL; the folder of the file is searched
                                         first */
    /* Texts for .include, with priority over all folders. The array of text tables
     * (vm/text.h) ends with NULL. The library, asm/lib, is always available. */
    const struct text *const *texts;
    bool sealed; /* .include reads only these texts and no files */
    struct warning_choice warnings;
};

/* Returns the object, or NULL after errors. A file that cannot be read is an error.
 * options may be NULL. */
struct object *assemble_file(const char *path, const struct asm_options *options,
                             struct diagnostics *diagnostics);
struct object *assemble_text(const char *name, const char *text,
                             const struct asm_options *options,
                             struct diagnostics *diagnostics);
/* Assembles `length` bytes, which may contain NULs. A NUL must follow the bytes. */
struct object *assemble_bytes(const char *name, const char *text, size_t length,
                              const struct asm_options *options,
                              struct diagnostics *diagnostics);

/* Returns true if a diagnostic reports that the text redefines the name, which the
 * options define. */
bool asm_is_redefined(const struct diagnostic *diagnostic, const char *name);

/* Returns the name of directive i, or NULL after the last. */
const char *asm_directive(size_t i);

/* Returns the first of these names that none of the programs uses, or NULL if all are
 * used. The list ends with a NULL name. An object that was read from a file uses no
 * names, because its constants are fixed. */
const char *asm_unused_define(const struct asm_define *defines,
                              struct object *const *objects, size_t count);

#endif
