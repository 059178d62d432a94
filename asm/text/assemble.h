/* assemble.h - assembles the text of a program into an object that
 * the machine can load.
 *
 *   lex -> expand (includes, macros, repetition, conditions) -> parse ->
 *   encode -> object
 *
 * docs/assembly.md describes the language. Nothing here prints or exits; the errors of
 * a text are collected, so that one run reports all of them.
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
    const struct asm_define *defines; /* defined by .equ before the first line; the last
                                       * has a NULL name; NULL: none. A name that a
                                       * constant cannot have is an error. */
    const char *const *search;        /* folders for .include, NULL-terminated, or NULL;
                                       * the folder of the file itself precedes them */
    /* Texts that are included by name, with priority over all folders: the library of
     * asm/lib and, for rt, the kernels. NULL-terminated array of text tables
     * (vm/text.h); the library is always available. */
    const struct text *const *texts;
    bool sealed; /* .include reads no files, only these texts */
    struct warning_choice warnings;
};

/* Returns the object, or NULL after errors; a file that cannot be read is one.
 * options may be NULL. */
struct object *assemble_file(const char *path, const struct asm_options *options,
                             struct diagnostics *diagnostics);
struct object *assemble_text(const char *name, const char *text,
                             const struct asm_options *options,
                             struct diagnostics *diagnostics);
/* Assembles `length` bytes. They may contain NULs, and a NUL must follow them. */
struct object *assemble_bytes(const char *name, const char *text, size_t length,
                              const struct asm_options *options,
                              struct diagnostics *diagnostics);

/* Returns true if a diagnostic reports that the text redefines a name that the options
 * define. */
bool asm_is_redefined(const struct diagnostic *diagnostic, const char *name);

/* Returns the name of directive i, or NULL after the last. */
const char *asm_directive(size_t i);

/* Returns the first of the names that no program uses, or NULL if all are used. The
 * list ends with a NULL name. An object that was read from a file uses none: its
 * constants are fixed. */
const char *asm_unused_define(const struct asm_define *defines,
                              struct object *const *objects, size_t count);

#endif
