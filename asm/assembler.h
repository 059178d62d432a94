/* assembler.h - what the passes of one assembly share.  Not public.
 *
 * The passes run line by line: expand hands out logical lines (after
 * includes, macros, repetition and conditions), parse turns each into items
 * that lie at known addresses and whose values are expressions, and when the
 * last line is read, every label known, encode turns items into words.
 *
 * Pointers into program text stay good during the whole assembly.  Functions
 * that can fail return false or NULL after they have reported why.
 */
#ifndef ASM_ASSEMBLER_H
#define ASM_ASSEMBLER_H

#include "base/arena.h"
#include "asm/assemble.h"
#include "asm/expect.h"

/* Bounds, so that no text makes the assembler run away. */
#define MAX_WORDS ((uint64_t)1 << 26)     /* of a program */
#define MAX_EXPANSION ((uint64_t)1 << 26) /* bytes made by .macro and .rept */
#define MAX_LINE ((size_t)1 << 16)        /* bytes of one line */
#define MAX_FRAMES 64u                    /* includes and macros in use */
#define MAX_CONDITIONS 64u
#define MAX_SHARES 64u  /* .share in .share */
#define MAX_SHARERS 64u /* of a register that a new name is compared with */
#define MAX_EXPRESSION_DEPTH 200u
#define MAX_ERRORS 200u

#define ADDRESS_BITS 48
#define PAGE_BITS ((uint64_t)C205_PAGE_WORDS * 64)
#define CODE_ORIGIN (1 * PAGE_BITS) /* page 0 stays unmapped */
#define DATA_ORIGIN (2 * PAGE_BITS)

/* A line of program text, as read or as expanded. */
struct line {
    const char *file;
    size_t number;
    const char *text, *text_end; /* for messages */
    const char *begin, *end;     /* the part that is to be parsed */
    const struct line *caller;   /* the macro call or .rept it came from */
};

enum value_kind {
    VALUE_INTEGER,
    VALUE_WORD,    /* X'..': as an integer its bits */
    VALUE_FLOATING /* computed as the machine does */
};

struct value {
    enum value_kind kind;
    uint64_t bits;
};

enum symbol_kind {
    SYMBOL_UNDEFINED,
    SYMBOL_LABEL,
    SYMBOL_CONSTANT,
    SYMBOL_REGISTER,
    SYMBOL_HALF_REGISTER
};

struct symbol {
    struct symbol *next; /* with the same hash */
    const char *name;
    size_t length;
    enum symbol_kind kind;
    struct value value;         /* register: its number */
    size_t naming;              /* register: the last one of this name, from 1 */
    const struct macro *macro;  /* of this name; macros have their own space */
    const struct line *defined; /* NULL: given by the caller */
    bool used;                  /* an expression or a condition has it */
    bool counted;               /* label: it was given a length, of what: */
    enum asm_contents contents;
    uint64_t count;
};

enum { SYMBOL_BUCKETS = 4096 };

/* A register of 64 bits, or a half register. */
struct register_name {
    bool half;
    uint8_t number;
    size_t naming; /* by which it was meant, from 1; 0: r5 itself */
};

/* From .share to .endshare. */
struct register_share {
    const struct register_share *outer;
    const struct line *line;
    const char *word; /* NULL: none */
    unsigned depth;
};

/* What .reg and .regs declare: a name of a register from there on. */
struct naming {
    const struct line *line;
    const char *at;
    const struct symbol *symbol;
    struct register_name named;
    size_t owner;                       /* the first naming of what this is */
    const struct register_share *share; /* the block it is in, or NULL */
    bool ended;                         /* the name has moved on */
    size_t below;                       /* the one of this register before it, from 1 */
};

struct registers {
    struct naming *namings;
    size_t count, capacity;
    size_t newest[C205_REGISTERS]; /* naming of each, from 1 */
    size_t *mentions;              /* namings, as instructions have them */
    size_t mention_count, mention_capacity;
    const struct register_share *share; /* the block that is open, or NULL */
};

struct symbols {
    struct symbol *buckets[SYMBOL_BUCKETS];
    size_t count;
};

struct instruction {
    const c205_insn *insn;
    c205_fields fields;
    const struct expression *value; /* immediate or branch target, or NULL */
    bool relative;                  /* value is a target address */
    size_t mention, mentions;       /* the first, and how many */
};

enum item_kind {
    ITEM_INSTRUCTION,
    ITEM_WORDS,      /* known already */
    ITEM_VALUE,      /* one word from one expression */
    ITEM_HALF,       /* 32 bits of an integer from one expression */
    ITEM_HALF_WORD,  /* a half word from one expression */
    ITEM_DESCRIPTOR, /* one word from two */
    ITEM_SPACE       /* zeros */
};

struct layout_item {
    enum item_kind kind;
    enum asm_contents contents;
    const struct line *line;
    uint64_t address;
    uint64_t halves;
    size_t order;
    union {
        const struct instruction *instruction;
        const c205_word *words;
        const struct expression *values[2]; /* descriptor: length, address */
    } of;
};

struct asm_region {
    const char *name;
    const struct line *line;
    uint64_t begin, end;
};

/* Between .record and .endrecord. */
struct open_record {
    const struct line *line; /* NULL: none */
    const char *name;
    int64_t next, size; /* words */
};

struct section {
    const char *name;
    uint64_t at;
    bool moved; /* by .org */
    bool full;  /* reported; what follows is left out, until .org */
};

/* A warning before it is known which of them the program means. */
struct pending_warning {
    enum warning warning;
    struct position position;
    const char *message;
};

/* An expectation before its expressions are known. */
struct expectation {
    const struct line *line;
    enum expectation_kind kind;
    unsigned number;
    const struct expression *address;
    size_t count;
    const struct expression **values;
    const c205_word *bits;
    const struct expression *tolerance; /* NULL: none */
    const char *text;
};

struct assembler {
    struct arena *arena;
    const struct asm_options *options;
    struct diagnostics *diagnostics;
    size_t first_error; /* errors that were there before */
    struct symbols symbols;
    struct registers registers;
    struct expander *expander;
    struct constant_folder *constant_folder; /* NULL: nothing was to be computed yet */

    struct section sections[2];
    struct section *section;
    uint64_t words;             /* put so far */
    enum asm_contents contents; /* of the data that are being put */

    struct layout_item *items;
    size_t item_count, item_capacity;
    struct asm_region *regions;
    size_t region_count, region_capacity;
    struct asm_region open_region; /* line NULL: none */
    const struct section *region_section;
    struct open_record record;
    struct expectation *expectations;
    size_t expectation_count, expectation_capacity;
    struct pending_warning *pending_warnings;
    size_t pending_count, pending_capacity;
    /* Labels that move on with the data after them when that is aligned. */
    struct symbol **waiting;
    size_t waiting_count, waiting_capacity;

    const struct instruction *writing; /* its operands are being read, and
                                          its form is still to be told */
    bool warm;                         /* .warm */
    const struct line *entry_line;
    const struct expression *entry;
};

/* error.c.  at points into the line, or to its beginning if the whole of it is
 * meant; all return false. */
bool report(struct assembler *assembler, const struct line *line, const char *at,
            const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 4, 5)))
#endif
    ;
/* The same for what is no error; told at the end, if at all. */
void warn(struct assembler *assembler, enum warning warning, const struct line *line,
          const char *at, const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 5, 6)))
#endif
    ;
/* All of them; which there were, told or not. */
warning_set report_pending_warnings(struct assembler *assembler);
bool report_file(struct diagnostics *diagnostics, const char *file,
                 const char *message);
bool too_many_errors(const struct assembler *assembler);

/* symbol.c */
struct symbol *symbol_intern(struct assembler *assembler, const char *name,
                             size_t length);
/* NULL: never heard of. */
struct symbol *symbol_find(const struct assembler *assembler, const char *name,
                           size_t length);
/* False: neither r0 .. r255 nor h0 .. h255. */
bool register_named(const char *name, size_t length, struct register_name *found);
bool symbol_define(struct assembler *assembler, const struct line *line, const char *at,
                   struct symbol *symbol, enum symbol_kind kind, struct value value);

/* parse.c */
bool parse_line(struct assembler *assembler, const struct line *line);

/* fallthrough.c: warns of code that has no end. */
void check_ends(struct assembler *assembler);

/* encode.c: the object, or NULL. */
struct object *encode_program(struct assembler *assembler);

#endif
