/* assemble.h - from program text to a program the machine can load.
 *
 *   lex -> expand (includes, macros, repetition, conditions) -> parse ->
 *   encode -> object
 *
 * The language is described in docs/assembly.md.  Nothing here prints or
 * exits; all errors of a text are collected in one go.
 */
#ifndef ASM_ASSEMBLE_H
#define ASM_ASSEMBLE_H

#include "asm/warning.h"
#include "base/diagnostic.h"
#include "vm/c205.h"

struct text;

/* What lies at a label. */
enum asm_contents {
    ASM_NOTHING, /* or it is not known: an object file does not tell */
    ASM_CODE,    /* counted in half words */
    ASM_WORDS,
    ASM_HALF_WORDS,
    ASM_BITS,
    ASM_BYTES
};

struct asm_symbol {
    const char *name;
    int64_t value; /* labels: bit address */
    bool is_label;
    bool is_word;               /* value holds the bits of a 205 word, not an integer */
    bool is_used;               /* an expression or a condition of the text has it */
    enum asm_contents contents; /* of a label, up to the next one .. */
    bool counted;               /* by a length that was given to it */
    uint64_t count; /* .. and how many; what .vector and its kin make has the
                                   length given there */
};

/* Where a statement's words lie, for listings, debuggers and profiles. */
struct asm_line {
    uint64_t address;
    uint64_t halves;
    const char *file;
    size_t number;
    const char *source;
    bool is_code; /* instructions */
    /* The macro call that it comes from, the outermost; the line itself if it comes
     * from none. */
    const char *call_file;
    size_t call_number;
    const char *call_source;
};

/* A name of a register, as .reg and .regs gave it. */
struct asm_register {
    const char *name;
    bool half;
    uint8_t number;
    const char *file;
    size_t line;  /* where it was given */
    size_t owner; /* the first name of what this is, in the same list */
};

/* An instruction has a name of a register. */
struct asm_mention {
    uint64_t address; /* the instruction's */
    size_t name;      /* in the list of registers */
};

/* What a test program expects (its "; expect" comments): asm/expect.h. */
struct asm_expectation;

struct object {
    c205_program program;
    size_t symbol_count;
    const struct asm_symbol *symbols;     /* sorted by name */
    size_t line_count;                    /* 0 when read from an object file */
    const struct asm_line *lines;         /* sorted by address */
    size_t register_count;                /* likewise */
    const struct asm_register *registers; /* as the text has them */
    size_t mention_count;                 /* likewise */
    const struct asm_mention *mentions;   /* by address, then as written */
    size_t expectation_count;
    const struct asm_expectation *expectations;
    warning_set warned; /* of this the assembler has warned, or would have */
};

struct asm_define {
    const char *name;
    int64_t value;
};

struct asm_options {
    const struct asm_define *defines; /* as .equ before the first line;
                                         ends with a NULL name; or NULL; an error
                                         if a name cannot be that of a constant */
    const char *const *search;        /* folders for .include, NULL-terminated
                                         or NULL; the file's own comes first */
    /* Texts that are included by name before any folder is looked at: the
     * library of asm/lib and, for rt, the kernels.  NULL-terminated array of
     * text tables (vm/text.h); the library is always there. */
    const struct text *const *texts;
    bool sealed; /* nothing else is included: no file is read */
    struct warning_choice warnings;
};

/* NULL: there are errors; a file that cannot be read is one.  options may be
 * NULL. */
struct object *assemble_file(const char *path, const struct asm_options *options,
                             struct diagnostics *diagnostics);
struct object *assemble_text(const char *name, const char *text,
                             const struct asm_options *options,
                             struct diagnostics *diagnostics);
/* The same of so many bytes, NULs among them or not, and a NUL behind them. */
struct object *assemble_bytes(const char *name, const char *text, size_t length,
                              const struct asm_options *options,
                              struct diagnostics *diagnostics);
void object_free(struct object *object);

/* Whether it says that the text defines what the options define already, otherwise. */
bool asm_is_redefined(const struct diagnostic *diagnostic, const char *name);

/* The line whose words lie at an address; NULL: none is known. */
const struct asm_line *object_line(const struct object *object, uint64_t address);
/* The region that it belongs to; "": none. */
const char *object_region(const struct object *object, uint64_t address);
/* Of its first word. */
struct position asm_line_position(const struct asm_line *line);

/* The names of the directives, NULL behind the last. */
const char *asm_directive(size_t i);

/* NULL: no such symbol. */
const struct asm_symbol *object_symbol(const struct object *object, const char *name);
/* The first of the names, ended by a NULL name, that none of the programs uses; NULL: all are
 * used.  The object of a file uses none, its constants are fixed. */
const char *asm_unused_define(const struct asm_define *defines,
                              struct object *const *objects, size_t count);

#endif
