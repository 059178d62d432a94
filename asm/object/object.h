/* object.h - an assembled program: its words, symbols, source lines, register names,
 * expectations and warnings.
 */
#ifndef ASM_OBJECT_H
#define ASM_OBJECT_H

#include "asm/object/warning.h"
#include "base/diagnostic.h"
#include "vm/c205.h"

/* The type of the data at a label. */
enum asm_contents {
    ASM_NOTHING, /* nothing, or unknown: an object file has no types */
    ASM_CODE,    /* its count is in half words */
    ASM_WORDS,
    ASM_HALF_WORDS,
    ASM_BITS,
    ASM_BYTES
};

/* Returns "words", "half words", "bits", "bytes", "code" or "". */
const char *asm_contents_name(enum asm_contents contents);

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

/* An expectation of a test program, from a comment "; expect" (asm/object/expectation.h). */
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

void object_free(struct object *object);

/* Returns the line whose words contain an address, or NULL if none is known. */
const struct asm_line *object_line(const struct object *object, uint64_t address);
/* Returns the segment with words that contains an address, or NULL. */
const c205_segment *object_segment(const struct object *object, uint64_t address);
/* Returns whether a segment is code: it contains the entry or the start of a region. */
bool object_is_code(const struct object *object, const c205_segment *segment);
/* Returns the name of the region that contains an address, or "". */
const char *object_region(const struct object *object, uint64_t address);
/* Returns the region of a name, or NULL. */
const c205_region *object_region_named(const struct object *object, const char *name);
/* Returns the source position of the first word of a line. */
struct position asm_line_position(const struct asm_line *line);
/* Returns NULL if there is no such symbol. */
const struct asm_symbol *object_symbol(const struct object *object, const char *name);
/* Returns the first label at an address, by name, or "". */
const char *object_label(const struct object *object, uint64_t address);
/* Returns the last name that the program gives a register, or half register, or "". */
const char *object_register_name(const struct object *object, unsigned number,
                                 bool half);

#endif
