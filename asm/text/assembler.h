/* assembler.h - data structures that the passes of an assembly share. Not public.
 *
 * The passes run line by line. The expander produces logical lines, after includes,
 * macros, repetition and conditions. The parser converts each line to items. Their
 * addresses are known, and their values are expressions. After the last line all labels
 * are known, and the encoder converts the items to words.
 *
 * Pointers into the program text are valid during the whole assembly. Functions return
 * false or NULL on failure, after reporting the reason.
 */
#ifndef ASM_ASSEMBLER_H
#define ASM_ASSEMBLER_H

#include "asm/object/address_space.h"
#include "asm/object/expectation.h"
#include "asm/text/assemble.h"
#include "base/arena.h"
#include "vm/error.h"

/* Limits that prevent endless assembly and use of all memory. */
#define MAX_EXPANSION ((uint64_t)1 << 26) /* bytes from .macro and .rept */
#define MAX_LINE ((size_t)1 << 16)        /* maximum bytes of a line */
#define MAX_FRAMES 64u                    /* nested includes and macros */
#define MAX_CONDITIONS 64u
#define MAX_SHARES 64u  /* nested .share blocks */
#define MAX_SHARERS 64u /* names of a register that a new name is compared with */
#define MAX_EXPRESSION_DEPTH 200u
#define MAX_ERRORS 200u

/* A line of program text, before or after expansion. */
struct line {
    const char *file;
    size_t number;
    const char *text, *text_end;       /* the whole line, for messages */
    const char *begin, *end;           /* the part to parse */
    const char *written, *written_end; /* the text in the definition of the macro that
                                          contains the line; NULL: no macro */
    const struct call *call; /* the macro call or .rept that produced the line, or
                                NULL */
};

enum value_kind {
    VALUE_INTEGER,
    VALUE_WORD,    /* X'..'; an integer with the bits of a word */
    VALUE_FLOATING /* result of the machine's arithmetic */
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
    struct symbol *next; /* next in the hash bucket */
    const char *name;
    size_t length;
    enum symbol_kind kind;
    struct value value;         /* number of a register */
    size_t naming;              /* last naming of a register, counted from 1 */
    const struct macro *macro;  /* macro of this name; macros have a separate name
                                   space */
    const struct line *defined; /* the line of the definition; NULL: defined by the
                                   caller */
    bool used;                  /* an expression or a condition uses it */
    bool counted;               /* the declaration contains contents and count of the
                                   label */
    enum asm_contents contents;
    uint64_t count;
};

enum { SYMBOL_BUCKETS = 4096 };

/* A register or a half register, by its number. */
struct register_name {
    bool half;
    uint8_t number;
    size_t naming; /* naming that the text used, counted from 1; 0: none, as in r5 */
};

/* A block from .share to .endshare. */
struct register_share {
    const struct register_share *outer;
    const struct line *line;
    const char *word; /* word after .share, or NULL */
    unsigned depth;
};

/* A register name, which is valid after its .reg or .regs. */
struct naming {
    const struct line *line;
    const char *at;
    const struct symbol *symbol;
    struct register_name named;
    size_t owner;                       /* first naming of the same value */
    const struct register_share *share; /* block that contains it, or NULL */
    bool ended;                         /* another register has the name now */
    size_t below;                       /* previous naming of the same register, counted
                                           from 1 */
};

struct registers {
    struct naming *namings;
    size_t count, capacity;
    size_t newest[C205_REGISTERS]; /* last naming of each register, counted from 1 */
    size_t *mentions;              /* namings in the order of their use in
                                      instructions */
    size_t mention_count, mention_capacity;
    const struct register_share *share; /* the open block, or NULL */
};

struct symbols {
    struct symbol *buckets[SYMBOL_BUCKETS];
    size_t count;
};

struct instruction {
    const c205_insn *insn;
    c205_fields fields;
    const struct expression *value; /* immediate or branch target, or NULL */
    bool relative;                  /* value is the address of a relative branch */
    size_t mention, mentions;       /* index of the first mention, number of mentions */
};

enum item_kind {
    ITEM_INSTRUCTION,
    ITEM_WORDS,      /* words with known values */
    ITEM_VALUE,      /* one word from one expression */
    ITEM_HALF,       /* half of a word: 32 bits of an integer from one expression */
    ITEM_HALF_WORD,  /* a half word from one expression */
    ITEM_DESCRIPTOR, /* one word from two expressions */
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
        const struct expression *values[2]; /* for a descriptor: length, address */
    } of;
};

struct asm_region {
    const char *name;
    const struct line *line;
    uint64_t begin, end;
};

/* The state between .record and .endrecord. */
struct open_record {
    const struct line *line; /* NULL: none */
    const char *name;
    int64_t next, size; /* position and size in words */
};

struct section {
    const char *name;
    uint64_t at;
    bool moved; /* an .org has changed the address */
    bool full;  /* an overflow was reported; items before the next .org are discarded */
};

/* A warning at a known position. It is not known yet whether the program declares it as
 * intended. */
struct pending_warning {
    enum warning warning;
    struct position position;
    const char *message;
};

/* An expectation before its expressions are evaluated. */
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

struct storage;

struct assembler {
    struct arena *arena;
    const struct asm_options *options;
    struct diagnostics *diagnostics;
    size_t first_error; /* number of errors before this assembly */
    struct symbols symbols;
    struct registers registers;
    struct expander *expander;
    struct constant_folder *constant_folder; /* NULL: not needed yet */

    struct section sections[2];
    struct section *section;
    uint64_t words;             /* number of words so far */
    enum asm_contents contents; /* type of the current data */

    struct layout_item *items;
    size_t item_count, item_capacity;
    struct asm_region *regions;
    size_t region_count, region_capacity;
    struct asm_region open_region; /* its line is NULL if there is none */
    const struct section *region_section;
    struct open_record record;
    struct expectation *expectations;
    size_t expectation_count, expectation_capacity;
    struct pending_warning *pending_warnings;
    size_t pending_count, pending_capacity;
    /* Labels that move with the next data if the data are aligned. */
    struct symbol **waiting;
    size_t waiting_count, waiting_capacity;

    const struct instruction *writing; /* instruction whose operands are parsed, unless
                                          its syntax was already reported */
    bool warm;                         /* the program has a directive .warm */
    const struct line *entry_line;
    const struct expression *entry;
};

/* report reports an error. `at` is a position in the line; the start of the line means
 * the whole line. The reporting functions of error.c return false. */
bool report(struct assembler *assembler, const struct line *line, const char *at,
            const char *format, ...) PRINTF_FORMAT(4, 5);
/* Records a warning. It is reported at the end of the assembly, unless it is disabled
 * or declared as intended. */
void warn(struct assembler *assembler, enum warning warning, const struct line *line,
          const char *at, const char *format, ...) PRINTF_FORMAT(5, 6);
/* Reports the recorded warnings. Returns the set of all recorded warnings, including
 * those that are not reported. */
warning_set report_pending_warnings(struct assembler *assembler);
bool report_file(struct diagnostics *diagnostics, const char *file,
                 const char *message);
bool too_many_errors(const struct assembler *assembler);

/* Returns the symbol with the given name, and adds it if it is new (symbol.c). */
struct symbol *symbol_intern(struct assembler *assembler, const char *name,
                             size_t length);
/* Returns the symbol with the given name, or NULL if the name was never used. */
struct symbol *symbol_find(const struct assembler *assembler, const char *name,
                           size_t length);
bool symbol_define(struct assembler *assembler, const struct line *line, const char *at,
                   struct symbol *symbol, enum symbol_kind kind, struct value value);

/* Parses a line of the expander to items and symbols (parse.c). */
bool parse_line(struct assembler *assembler, const struct line *line);

/* Warns if execution can run past the end of the code (fallthrough.c). */
void check_ends(struct assembler *assembler);
/* Returns true if an instruction is EXIT with request 0, the default request. */
bool ends_program(struct assembler *assembler, const struct layout_item *item);
/* Warns of registers that are read before they are written, in the instructions from
 * the entry to the first branch (first_reads.c). */
void check_first_reads(struct assembler *assembler, uint64_t entry);

/* layout_end returns the address after an item. layout_sort sorts the items by address
 * (layout.c). */
uint64_t layout_end(const struct layout_item *item);
void layout_sort(struct assembler *assembler);

/* Adds the words of the sorted items to an object. Continues after errors, so all
 * errors of values are reported (encode.c). */
bool encode_segments(struct assembler *assembler, struct storage *storage);

/* Builds the object from the items and symbols. Returns NULL after errors (build.c). */
struct object *build_object(struct assembler *assembler);

#endif
