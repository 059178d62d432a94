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

#include "asm/warning.h"
#include "base/diagnostic.h"
#include "vm/c205.h"

struct text;

/* The type of the data at a label. */
enum asm_contents {
    ASM_NOTHING, /* nothing, or unknown: an object file has no types */
    ASM_CODE,    /* its count is in half words */
    ASM_WORDS,
    ASM_HALF_WORDS,
    ASM_BITS,
    ASM_BYTES
};

struct asm_symbol {
    const char *name;
    int64_t value; /* labels: bit address */
    bool is_label;
    bool is_word;               /* value holds the bits of a word, not an integer */
    bool is_used;               /* used in an expression or a condition of the text */
    enum asm_contents contents; /* of a label, up to the next label */
    bool counted;               /* the declaration gives the length */
    uint64_t count; /* elements at the label; for .vector and similar directives the
                     * length that they declare */
};

/* The address of a statement's words, for listings, debuggers and profiles. */
struct asm_line {
    uint64_t address;
    uint64_t halves;
    const char *file;
    size_t number;
    const char *source;
    bool is_code; /* instructions */
    /* The outermost macro call that contains the line, or the line itself. */
    const char *call_file;
    size_t call_number;
    const char *call_source;
};

/* A name of a register, declared by .reg or .regs. */
struct asm_register {
    const char *name;
    bool half;
    uint8_t number;
    const char *file;
    size_t line;  /* of the declaration */
    size_t owner; /* index of the first name of the same value, in this list */
};

/* A use of a register name in an instruction. */
struct asm_mention {
    uint64_t address; /* of the instruction */
    size_t name;      /* index in the list of registers */
};

/* An expectation of a test program, from a comment "; expect" (asm/expect.h). */
struct asm_expectation;

struct object {
    c205_program program;
    size_t symbol_count;
    const struct asm_symbol *symbols;     /* sorted by name */
    size_t line_count;                    /* 0 if read from an object file */
    const struct asm_line *lines;         /* sorted by address */
    size_t register_count;                /* 0 if read from an object file */
    const struct asm_register *registers; /* in the order of the text */
    size_t mention_count;                 /* 0 if read from an object file */
    const struct asm_mention *mentions;   /* by address, then in the order of the
                                           * text */
    size_t expectation_count;
    const struct asm_expectation *expectations;
    warning_set warned; /* warnings that the text causes, also the disabled ones */
};

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
void object_free(struct object *object);

/* Returns true if a diagnostic reports that the text redefines a name that the options
 * define. */
bool asm_is_redefined(const struct diagnostic *diagnostic, const char *name);

/* Returns the line whose words contain an address, or NULL if none is known. */
const struct asm_line *object_line(const struct object *object, uint64_t address);
/* Returns the name of the region that contains an address, or "". */
const char *object_region(const struct object *object, uint64_t address);
/* Returns the source position of the first word of a line. */
struct position asm_line_position(const struct asm_line *line);

/* Returns the name of directive i, or NULL after the last. */
const char *asm_directive(size_t i);

/* Returns NULL if there is no such symbol. */
const struct asm_symbol *object_symbol(const struct object *object, const char *name);
/* Returns the first of the names that no program uses, or NULL if all are used. The
 * list ends with a NULL name. An object that was read from a file uses none: its
 * constants are fixed. */
const char *asm_unused_define(const struct asm_define *defines,
                              struct object *const *objects, size_t count);

#endif
