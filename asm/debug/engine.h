/* engine.h - the inside of a debugger, as its verbs and the protocol of editors use
 * it (asm/dap).  Not public.
 *
 * What is wrong is told by debug_fault, once; a function that could not do its work
 * returns false after that, a motion EXECUTION_FAILED.
 */
#ifndef ASM_DEBUG_ENGINE_H
#define ASM_DEBUG_ENGINE_H

#include "asm/debug/execution_control.h"
#include "asm/debug/debugger_state.h"
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

/* What is left of a text that is read. */
struct text_cursor {
    const char *at;
};

/* ---- Stops (stops.c) ------------------------------------------------------ */

enum breakpoint_kind {
    BREAK_ADDRESS, /* an address */
    BREAK_LINE,    /* where code of a source line begins, or of a macro that it calls */
    BREAK_INSN,    /* each instruction of a name */
    BREAK_ENTRY,   /* where control comes into a region */
    BREAK_WATCH    /* what memory holds changes */
};

enum { WATCHED_WORDS = 64, MAX_TEXT = 200 };

struct breakpoint {
    size_t number;
    size_t group; /* those of one group go together; 0: of nobody */
    enum breakpoint_kind kind;
    bool once;
    char text[MAX_TEXT];      /* as it was written */
    char condition[MAX_TEXT]; /* "": none */
    char wanted[MAX_TEXT];    /* of the number of hits: "> 4", "% 3"; or "" */
    bool met;                 /* where the program stands */
    uint64_t address;
    const char *file; /* BREAK_LINE; BREAK_AT, if it is known */
    size_t line;
    const c205_insn *insn;
    const char *region;
    size_t count; /* words that are watched, and what they held */
    c205_word held[WATCHED_WORDS];
    uint64_t hits; /* times that it was met on a way forward */
};

/* ---- A debugger ----------------------------------------------------------- */

struct debugger {
    struct debugger_setup setup;
    struct sink out;
    c205_history *history;
    struct printer printer;
    struct line_tracker printed; /* the output of the program */
    uint64_t reported;           /* steps whose output was printed */
    bool has_last;               /* there is a last instruction: */
    c205_event last;
    c205_times record; /* its time */
    bool has_end;      /* .. with which the program ended: */
    c205_times end;    /* what was in flight then */
    bool halted;       /* the program cannot go on from here: */
    c205_stop halt;
    uint64_t asked; /* the clock at which it was asked last whether to stop */
    bool searching; /* it is run again to find a stop: hits do not count */
    size_t breakpoint_count, breakpoint_number;
    struct breakpoint *breakpoints;
    char again[MAX_TEXT]; /* the last movement */
    size_t faults;
};

static inline c205 *machine_of(const struct debugger *debugger)
{
    return c205_history_machine(debugger->history);
}

static inline uint64_t step_of(const struct debugger *debugger)
{
    return c205_history_step(debugger->history);
}

/* "error: ..." to the sink; false. */
bool debug_fault(struct debugger *debugger, const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 2, 3)))
#endif
    ;

/* ---- Reading a text (value.c) --------------------------------------------- */

void text_cursor_skip(struct text_cursor *cursor);
bool text_cursor_end(struct text_cursor *cursor);
/* A word of letters, digits and _ . if it is this one; or the beginning of it. */
bool text_cursor_take(struct text_cursor *cursor, const char *word);
bool text_cursor_begin(struct text_cursor *cursor, const char *word);
/* Nothing may be left. */
bool text_cursor_finish(struct debugger *debugger, struct text_cursor *cursor);
/* What was read from there on, as far as there is room, without spaces at its end. */
void text_cursor_text(const char *from, const struct text_cursor *cursor,
                      char text[MAX_TEXT]);

/* An expression. */
bool debug_value(struct debugger *debugger, struct text_cursor *cursor,
                 struct value_of *value);
/* Whether it is one, whatever registers and memory hold now. */
bool debug_grammar(struct debugger *debugger, struct text_cursor *cursor);
bool debug_address(struct debugger *debugger, struct text_cursor *cursor,
                   uint64_t *address);
bool debug_count(struct debugger *debugger, struct text_cursor *cursor,
                 uint64_t *count);
/* As a word, or as a half word at the left of one; false: there is none. */
bool debug_word(struct debugger *debugger, const struct value_of *value, bool half,
                c205_word *word);
bool debug_is_true(const struct value_of *value);

/* A register by its name or number: r10, h21, or a name of the program. */
struct register_of {
    uint8_t number;
    bool half;
};
/* Tells nothing. */
bool debug_register(const struct debugger *debugger, struct text_cursor *cursor,
                    struct register_of *named);
c205_word debug_register_word(const struct debugger *debugger,
                              struct register_of named);

/* ---- Verbs ----------------------------------------------------------------- */

/* Does what the rest of its line says. */
typedef bool debug_verb(struct debugger *debugger, struct text_cursor *cursor);

/* Those that the protocol has as well. */
debug_verb verb_print, verb_set;

/* ---- Changes (set.c): from here on the run is another one ------------------ */

bool debug_set_register(struct debugger *debugger, struct register_of named,
                        const struct value_of *value);
/* At most 64 bits, all in one word, left-aligned in the value. */
bool debug_set_bits(struct debugger *debugger, uint64_t address, unsigned width,
                    c205_word bits);
/* From a byte on; all of them must be there. */
bool debug_set_bytes(struct debugger *debugger, uint64_t address,
                     const unsigned char *bytes, size_t count);
/* An instruction of the program's text, which is the next one then. */
bool debug_jump(struct debugger *debugger, uint64_t address);

/* ---- Places (place.c) ------------------------------------------------------ */

/* What a stop point is at, and its text, with the position if that is not the one in the text.
 * LABEL, LABEL + EXPRESSION, LINE, FILE:LINE, *EXPRESSION, insn NAME, region NAME. */
bool place_read(struct debugger *debugger, struct text_cursor *cursor,
                struct breakpoint *stop);
/* The same of a source line, or the next that has code. */
bool place_line(struct debugger *debugger, const char *file, size_t number,
                struct breakpoint *stop);
/* One address; one at which an instruction of the program begins. */
bool place_address(struct debugger *debugger, struct text_cursor *cursor,
                   uint64_t *address);
bool place_code(struct debugger *debugger, struct text_cursor *cursor,
                uint64_t *address);
/* Where the machine is before it executes what is at an address: behind a LINKV that is
 * the LINKV. */
uint64_t place_of(const struct debugger *debugger, uint64_t address);
/* Whether code of that source line, or of a macro called there, begins at an address. */
bool place_begins(const struct debugger *debugger, const char *file, size_t number,
                  uint64_t address);
/* Whether a line is of a macro that another one calls. */
bool place_is_called(const struct asm_line *line);
/* The instruction before one, as the program's lines have it. */
uint64_t place_before(const struct debugger *debugger, uint64_t address);

/* ---- Stops (stops.c) -------------------------------------------------------- */

/* ADDRESS [, WORDS], to be watched. */
bool breakpoints_watch(struct debugger *debugger, struct text_cursor *cursor,
                       struct breakpoint *stop);
/* All of a text; "" or NULL: none. */
bool breakpoints_condition(struct debugger *debugger, struct breakpoint *stop,
                           const char *text);
/* An operator and its operand, or a number: the count from which it stops. */
bool breakpoints_wanted(struct debugger *debugger, struct breakpoint *stop,
                        const char *text);
/* It has its number then.  False: no memory. */
bool breakpoints_add(struct debugger *debugger, struct breakpoint *stop);
/* The stop with a number; false: there is none.  All of a group. */
bool breakpoints_delete(struct debugger *debugger, uint64_t number);
void breakpoints_forget(struct debugger *debugger, size_t group);

/* Whether the last instruction, or where the program stands, has come to some of them; these
 * are marked.  before: the address of that instruction. */
bool breakpoints_meet(struct debugger *debugger, uint64_t before);
/* What is watched is as it is now. */
void breakpoints_sample(struct debugger *debugger);
/* ---- What is shown ----------------------------------------------------------- */

/* A word, or a half word at the left of one, in all that it may mean. */
void show_word(c205_word word, bool half, const struct sink *sink);

#endif
