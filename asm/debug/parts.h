/* parts.h - the inside of a debugger.  Not public.
 *
 * A verb gets the rest of its line; each part reads of it what it knows, by a
 * struct rest that moves on.  What is wrong is told by debug_fault, once.
 */
#ifndef ASM_DEBUG_PARTS_H
#define ASM_DEBUG_PARTS_H

#include "asm/debug/debugger.h"
#include "asm/print.h"

/* ---- Values (value.c) ---------------------------------------------------- */

/* A number; of a word of the machine its value as a number, and the word; of a half word the
 * same, with the half at the left of it. */
struct value_of {
    bool is_real, is_word, is_half;
    int64_t integer; /* of a word: its low 48 bits, as an integer */
    double real;     /* in any case */
    c205_word word;
};

struct rest {
    const char *at;
};

/* ---- Stops (stops.c) ------------------------------------------------------ */

enum stop_kind {
    STOP_AT, /* an address */
    STOP_LINE, /* where code of a source line begins, or of a macro that it calls */
    STOP_INSN,  /* each instruction of a name */
    STOP_ENTRY, /* where control comes into a region */
    STOP_WATCH  /* what memory holds changes */
};

enum { WATCHED_WORDS = 64, TEXT_MOST = 200 };

struct stop_point {
    size_t number;
    enum stop_kind kind;
    bool once;
    char text[TEXT_MOST];      /* as it was written */
    char condition[TEXT_MOST]; /* "": none */
    bool met;                  /* where the program stands */
    uint64_t address;
    const char *file; /* STOP_LINE */
    size_t line;
    const c205_insn *insn;
    const char *region;
    size_t count; /* words that are watched, and what they held */
    c205_word held[WATCHED_WORDS];
    uint64_t hits;
};

struct debugger {
    struct debugger_setup setup;
    struct sink out;
    c205_history *history;
    struct printer printer;
    bool line_open; /* what the program printed has not ended its line */
    uint64_t told;  /* steps whose output was printed */
    bool has_last;  /* there is a last instruction: */
    c205_event last;
    c205_times record; /* its time */
    bool has_end;      /* .. with which the program ended: */
    c205_times end;    /* what was in flight then */
    bool halted;       /* the program cannot go on from here: */
    c205_stop halt;
    size_t stop_count, stop_number;
    struct stop_point *stops;
    char again[TEXT_MOST]; /* the last movement */
    size_t faults;
};

static inline c205 *machine_of(const struct debugger *debugger)
{
    return c205_history_machine(debugger->history);
}

/* "error: ..." to the sink; false. */
bool debug_fault(struct debugger *debugger, const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 2, 3)))
#endif
    ;

/* ---- Reading a line (value.c) --------------------------------------------- */

void rest_skip(struct rest *rest);
bool rest_end(struct rest *rest);
/* A word of letters, digits and _ . if it is this one; or the beginning of it. */
bool rest_take(struct rest *rest, const char *word);
bool rest_begin(struct rest *rest, const char *word);
/* Nothing may be left. */
bool rest_finish(struct debugger *debugger, struct rest *rest);

/* An expression; false after telling what is wrong. */
bool debug_value(struct debugger *debugger, struct rest *rest,
                 struct value_of *value);
bool debug_address(struct debugger *debugger, struct rest *rest,
                   uint64_t *address);
bool debug_count(struct debugger *debugger, struct rest *rest,
                 uint64_t *count);
/* As a word, or as a half word at the left of one; false after telling that there is none. */
bool debug_word(struct debugger *debugger, const struct value_of *value,
                bool half, c205_word *word);
bool debug_is_true(const struct value_of *value);
/* A register by its name or number: r10, h21, or a name of the program. */
struct register_of {
    uint8_t number;
    bool half;
};
bool debug_register(struct debugger *debugger, struct rest *rest,
                    struct register_of *named);
/* The name that the program gave it last; "": none. */
const char *debug_register_name(const struct debugger *debugger,
                                unsigned number);
c205_word debug_register_word(const struct debugger *debugger,
                              struct register_of named);

/* ---- Places (place.c) ------------------------------------------------------ */

/* What a stop point is at: fills all but its number.  LABEL, LABEL + EXPRESSION, LINE,
 * FILE:LINE, *EXPRESSION, insn NAME, region NAME. */
bool place_read(struct debugger *debugger, struct rest *rest,
                struct stop_point *stop);
/* One address. */
bool place_address(struct debugger *debugger, struct rest *rest,
                   uint64_t *address);
/* Where the machine stands before it executes what is at an address: behind a LINKV that is
 * the LINKV. */
uint64_t place_of(const struct debugger *debugger, uint64_t address);
/* Whether code of that source line, or of a macro called there, begins at an address. */
bool place_begins(const struct debugger *debugger, const char *file,
                  size_t number, uint64_t address);

/* ---- Stops ---------------------------------------------------------------- */

/* Whether the last instruction, or where the program stands, has come to some of them; these
 * are marked.  before: the address of that instruction. */
bool stops_meet(struct debugger *debugger, uint64_t before);
/* What is watched is as it is now. */
void stops_sample(struct debugger *debugger);
/* Those that were met have been: they are counted, and what is once is over.  With a word of
 * each, or without. */
void stops_pass(struct debugger *debugger, bool told);

/* ---- Verbs: each false after telling a fault ------------------------------ */

typedef bool debug_verb(struct debugger *debugger, struct rest *rest);

/* move.c */
debug_verb verb_step, verb_next, verb_continue, verb_reverse_step,
    verb_reverse_continue, verb_until, verb_goto, verb_run;
/* stops.c */
debug_verb verb_break, verb_tbreak, verb_watch, verb_delete;
/* show.c */
debug_verb verb_where, verb_list, verb_disassemble;
/* print.c */
debug_verb verb_print, verb_assert, verb_x;
/* info.c, set.c */
debug_verb verb_info, verb_set;
/* time.c */
debug_verb verb_why, verb_account;

/* What the program printed has its line to itself. */
void show_end_line(struct debugger *debugger);
/* Step, clock and region, then the next instruction: where the program stands, or that it has ended. */
void show_place(struct debugger *debugger);
/* A word, or a half word at the left of one, in all that it may mean. */
void show_word(const struct debugger *debugger, c205_word word, bool half);
/* An instruction, and its source line if it is known. */
void show_instruction(struct debugger *debugger, uint64_t address,
                      const char *before);

#endif
