/* assembler.h - data structures that the passes of an assembly share. Not public.
 *
 * The passes run line by line. The expander produces logical lines, after includes,
 * macros, repetition and conditions. The parser turns each line into items with known
 * addresses, whose values are expressions. After the last line all labels are known,
 * and the encoder turns the items into words.
 *
 * Pointers into the program text are valid during the whole assembly. Functions that
 * fail return false or NULL after they have reported the reason.
 */
#ifndef ASM_ASSEMBLER_H
#define ASM_ASSEMBLER_H

#include "asm/object/address_space.h"
#include "asm/object/expectation.h"
#include "asm/text/assemble.h"
#include "base/arena.h"
#include "vm/error.h"

/* Limits, so that no text makes an assembly endless or exhausts memory. */
#define MAX_EXPANSION ((uint64_t)1 << 26) /* bytes made by .macro and .rept */
#define MAX_LINE ((size_t)1 << 16)        /* bytes of one line */
#define MAX_FRAMES 64u                    /* includes and macros in use */
#define MAX_CONDITIONS 64u
#define MAX_SHARES 64u  /* .share in .share */
#define MAX_SHARERS 64u /* names of one register that a new name is compared with */
#define MAX_EXPRESSION_DEPTH 200u
#define MAX_ERRORS 200u

/* A line of program text, as read or as expanded. */
struct line {
    const char *file;
    size_t number;
    const char *text, *text_end; /* for messages */
    const char *begin, *end;     /* the part to parse */
    const struct line *caller;   /* the macro call or .rept that produced it */
};

enum value_kind {
    VALUE_INTEGER,
    VALUE_WORD,    /* X'..': as an integer, its bits */
    VALUE_FLOATING /* computed by the machine's arithmetic */
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
    struct value value;         /* register: its number */
    size_t naming;              /* register: its last naming, counted from 1 */
    const struct macro *macro;  /* the macro of this name; macros have
                                 * their own name space */
    const struct line *defined; /* NULL: defined by the caller */
    bool used;                  /* used in an expression or a condition */
    bool counted;               /* label: contents and count are declared */
    enum asm_contents contents;
    uint64_t count;
};

enum { SYMBOL_BUCKETS = 4096 };

/* A register of 64 bits or a half register. */
struct register_name {
    bool half;
    uint8_t number;
    size_t naming; /* the naming that the text used, counted from
                    * 1; 0: none, as in r5 */
};

/* A block from .share to .endshare. */
struct register_share {
    const struct register_share *outer;
    const struct line *line;
    const char *word; /* NULL: no word is given */
    unsigned depth;
};

/* A name of a register, valid from its .reg or .regs on. */
struct naming {
    const struct line *line;
    const char *at;
    const struct symbol *symbol;
    struct register_name named;
    size_t owner;                       /* the first naming of the same value */
    const struct register_share *share; /* the block that contains it, or NULL */
    bool ended;                         /* the name has been given to another
                                         * register */
    size_t below;                       /* previous naming of the same
                                         * register, counted from 1 */
};

struct registers {
    struct naming *namings;
    size_t count, capacity;
    size_t newest[C205_REGISTERS]; /* last naming of each register, counted from 1 */
    size_t *mentions;              /* namings, in the order of their use in
                                    * instructions */
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
    bool relative;                  /* value is a target address */
    size_t mention, mentions;       /* index of the first, and number */
};

enum item_kind {
    ITEM_INSTRUCTION,
    ITEM_WORDS,      /* values are known */
    ITEM_VALUE,      /* one word from one expression */
    ITEM_HALF,       /* 32 bits of an integer from one expression */
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
        const struct expression *values[2]; /* descriptor: length, address */
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
    int64_t next, size; /* words */
};

struct section {
    const char *name;
    uint64_t at;
    bool moved; /* by .org */
    bool full;  /* reported; further items are dropped, until .org */
};

/* A warning whose position in the program is known, but not yet whether the program
 * declares it as intended. */
struct pending_warning {
    enum warning warning;
    struct position position;
    const char *message;
};

/* An expectation whose expressions are not evaluated yet. */
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
    size_t first_error; /* number of earlier errors */
    struct symbols symbols;
    struct registers registers;
    struct expander *expander;
    struct constant_folder *constant_folder; /* NULL: not needed so far */

    struct section sections[2];
    struct section *section;
    uint64_t words;             /* number of words so far */
    enum asm_contents contents; /* type of the current data */

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
    /* Labels that move with the following data when those are aligned. */
    struct symbol **waiting;
    size_t waiting_count, waiting_capacity;

    const struct instruction *writing; /* the instruction whose operands are
                                        * being parsed, if its syntax has
                                        * not been reported yet */
    bool warm;                         /* .warm */
    const struct line *entry_line;
    const struct expression *entry;
};

/* error.c. `at` points into the line; if the whole line is meant, it is the start of
 * the line. All of them return false. */
bool report(struct assembler *assembler, const struct line *line, const char *at,
            const char *format, ...) PRINTF_FORMAT(4, 5);
/* Records a warning, which is reported at the end unless it is disabled or declared. */
void warn(struct assembler *assembler, enum warning warning, const struct line *line,
          const char *at, const char *format, ...) PRINTF_FORMAT(5, 6);
/* Reports the recorded warnings. Returns their set, including those not reported. */
warning_set report_pending_warnings(struct assembler *assembler);
bool report_file(struct diagnostics *diagnostics, const char *file,
                 const char *message);
bool too_many_errors(const struct assembler *assembler);

/* symbol.c */
struct symbol *symbol_intern(struct assembler *assembler, const char *name,
                             size_t length);
/* Returns NULL if the name was never used. */
struct symbol *symbol_find(const struct assembler *assembler, const char *name,
                           size_t length);
bool symbol_define(struct assembler *assembler, const struct line *line, const char *at,
                   struct symbol *symbol, enum symbol_kind kind, struct value value);

/* parse.c */
bool parse_line(struct assembler *assembler, const struct line *line);

/* Warns of code that continues past its end (fallthrough.c). */
void check_ends(struct assembler *assembler);

/* layout.c: returns the address after an item; sorts the items by address. */
uint64_t layout_end(const struct layout_item *item);
void layout_sort(struct assembler *assembler);

/* Adds the words of the sorted items to an object. Continues after errors of values, so
 * that all of them are reported (encode.c). */
bool encode_segments(struct assembler *assembler, struct storage *storage);

/* Returns the object, or NULL after errors (build.c). */
struct object *build_object(struct assembler *assembler);

#endif
