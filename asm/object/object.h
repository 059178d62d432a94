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
    ASM_NOTHING, /* no data, or unknown, as in an object file */
    ASM_CODE,    /* counted in half words */
    ASM_WORDS,
    ASM_HALF_WORDS,
    ASM_BITS,
    ASM_BYTES
};

/* Returns the name of a type: "words", "half words", "bits", "bytes", "code" or "". */
const char *asm_contents_name(enum asm_contents contents);

struct asm_symbol {
    const char *name;
    int64_t value; /* a bit address for labels */
    bool is_label;
    bool is_word;               /* value has the bits of a word, not an integer */
    bool is_used;               /* an expression or a condition of the text uses it */
    enum asm_contents contents; /* type of the data from a label to the next label */
    bool counted;               /* the declaration contains the length */
    uint64_t count; /* number of elements at the label; .vector and similar directives
                       declare it */
};

/* The form of an operation of asm/lib/forms.s. */
enum asm_form { ASM_NO_FORM = 0, ASM_SCALAR_FORM = 1, ASM_VECTOR_FORM = 2 };

/* Returns "scalar", "vector" or "". */
const char *asm_form_name(enum asm_form form);

/* A source line that contains or calls an instruction. */
struct asm_place {
    const char *file;
    size_t number;
    const char *source;
    bool begins; /* the previous words are not code of the same expansion of the line */
};

/* The addresses of the words of a statement and its source line, for listings,
 * debuggers and profiles. */
struct asm_line {
    uint64_t address;
    uint64_t halves;
    const char *file;
    size_t number;
    const char *source;
    bool is_code;           /* the words are instructions */
    struct asm_place shown; /* the line at which the words are shown: the line itself,
                               or that of a macro call (asm/text/shown_line.h) */
    struct asm_place call;  /* the outermost macro call that contains the line, or the
                               line itself */
    struct asm_place reported; /* the line at which its warnings are reported: the line
                                  itself, or the call of a macro of asm/lib */
    enum asm_form form;        /* form of the operation to which the words belong */
};

/* A register name, declared by .reg or .regs. */
struct asm_register {
    const char *name;
    bool half;
    uint8_t number;
    const char *file;
    size_t line;  /* line of the declaration */
    size_t owner; /* index of the first name of the same value */
};

/* The use of a register name in an instruction. */
struct asm_mention {
    uint64_t address; /* address of the instruction */
    size_t name;      /* index in the list of registers */
};

/* An expectation of a test program (asm/object/expectation.h). */
struct asm_expectation;

struct object {
    c205_program program;
    size_t symbol_count;
    const struct asm_symbol *symbols;     /* sorted by name */
    size_t line_count;                    /* 0 for an object file */
    const struct asm_line *lines;         /* sorted by address */
    size_t register_count;                /* 0 for an object file */
    const struct asm_register *registers; /* in the order of the text */
    size_t mention_count;                 /* 0 for an object file */
    const struct asm_mention *mentions;   /* sorted by address, then in the order of the
                                             text */
    size_t expectation_count;
    const struct asm_expectation *expectations;
    warning_set warned; /* all warnings that the text causes, even if they are
                           disabled */
};

void object_free(struct object *object);

/* Returns the line whose words contain an address, or NULL. */
const struct asm_line *object_line(const struct object *object, uint64_t address);
/* Returns the segment that contains an address and has words, or NULL. */
const c205_segment *object_segment(const struct object *object, uint64_t address);
/* Returns true if a segment is code: it contains the entry or the start of a region. */
bool object_is_code(const struct object *object, const c205_segment *segment);
/* Returns the name of the region that contains an address, or "". */
const char *object_region(const struct object *object, uint64_t address);
/* Returns the region with the given name, or NULL. */
const c205_region *object_region_named(const struct object *object, const char *name);
/* Returns true if a line belongs to a macro that another line calls. */
bool asm_line_is_called(const struct asm_line *line);
/* Returns true if a place is this line of this file. */
bool asm_place_is(const struct asm_place *place, const char *file, size_t number);
/* Returns the position in the source at which warnings of a line are reported. */
struct position asm_line_position(const struct asm_line *line);
/* Returns the symbol with the given name, or NULL. */
const struct asm_symbol *object_symbol(const struct object *object, const char *name);
/* Returns the first label at an address, in the order of names, or "". */
const char *object_label(const struct object *object, uint64_t address);
/* Returns the name by which the instruction at an address mentions a register or half
 * register, or "" if it does not mention a name. */
const char *object_mentioned_name(const struct object *object, uint64_t address,
                                  unsigned number, bool half);
/* Returns the name that the program declares for a register or half register, or "" if
 * it declares none. If there are several names, returns the last. */
const char *object_register_name(const struct object *object, unsigned number,
                                 bool half);

#endif
