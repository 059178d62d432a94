/* debugger_engine.h - the internals of a debugger, for its verbs and for asm/dap. Not
 * public.
 *
 * Each error is reported once, by debug_fault. A function that has failed then returns
 * false; a function that executes the program returns EXECUTION_FAILED.
 */
#ifndef ASM_DEBUG_DEBUGGER_ENGINE_H
#define ASM_DEBUG_DEBUGGER_ENGINE_H

#include "asm/debug/debugger_state.h"
#include "asm/debug/execution_control.h"
#include "asm/view/print.h"
#include "vm/error.h"

/* ---- Values (value.c) ---------------------------------------------------- */

/* The value of an expression. A number of the program text has no word. `word` has the
 * bits of a word of the machine; a half word is in the left half. */
struct value_of {
    bool is_real, is_word, is_half;
    int64_t integer; /* low 48 bits of a word */
    double real;     /* the value as a number; always valid */
    c205_word word;
};

/* The unread part of a text, such as a debugger command. */
struct text_cursor {
    const char *at;
};

/* ---- Stops (breakpoints.c) ------------------------------------------------------ */

enum breakpoint_kind {
    BREAK_ADDRESS, /* an address that the user states */
    BREAK_LINE,    /* start of the code of a source line, or of a macro that the line
                      calls */
    BREAK_INSN,    /* each instruction with a mnemonic */
    BREAK_ENTRY,   /* entry of control into a region */
    BREAK_WATCH    /* change of memory */
};

enum { WATCHED_WORDS = 64, MAX_TEXT = 200 };

struct breakpoint {
    size_t number;
    size_t group; /* group of breakpoints that are deleted together; 0: no group */
    enum breakpoint_kind kind;
    bool once;
    char text[MAX_TEXT];      /* as in the command */
    char condition[MAX_TEXT]; /* the condition; "": none */
    char wanted[MAX_TEXT];    /* condition on the number of hits, such as "> 4" or "%
                                 3"; "": none */
    bool met; /* the breakpoint stopped the program at the current location */
    uint64_t address;
    const char *file; /* for BREAK_LINE, and for BREAK_ADDRESS if the line is known */
    size_t line;
    const c205_insn *insn;
    const char *region;
    size_t count; /* number of watched words, followed by their last values */
    c205_word held[WATCHED_WORDS];
    uint64_t hits; /* number of hits while executing forward */
};

/* ---- A debugger ----------------------------------------------------------- */

struct debugger {
    struct debugger_setup setup;
    struct sink out;
    c205_history *history;
    struct printer printer;
    struct line_tracker printed; /* output of the program */
    uint64_t reported;           /* step up to which output has been printed */
    bool has_last;               /* `last` and `record` are valid */
    c205_event last;
    c205_times record; /* times of the last instruction */
    bool has_end;      /* the program has ended, and `end` is valid */
    c205_times end;    /* times of results that were in flight at the end */
    bool halted;       /* the program cannot continue; `halt` is valid */
    c205_stop halt;
    uint64_t asked; /* clock at the last check for an interruption */
    bool searching; /* true during a replay that searches for breakpoints; hits are then
                       not counted */
    size_t breakpoint_count, breakpoint_number;
    struct breakpoint *breakpoints;
    char again[MAX_TEXT]; /* the last execution command, for an empty line */
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

/* Prints "error: ..." to the sink, counts the fault, and returns false. */
bool debug_fault(struct debugger *debugger, const char *format, ...)
    PRINTF_FORMAT(2, 3);

/* ---- Reading a text (value.c) --------------------------------------------- */

void text_cursor_skip(struct text_cursor *cursor);
bool text_cursor_end(struct text_cursor *cursor);
/* Skips a word (letters, digits, _ . $) and returns true if it equals `word`.
 * text_cursor_begin also accepts a prefix of `word`. */
bool text_cursor_take(struct text_cursor *cursor, const char *word);
bool text_cursor_begin(struct text_cursor *cursor, const char *word);
/* Skips a sign such as "=" and returns true if it is next. */
bool text_cursor_sign(struct text_cursor *cursor, const char *sign);
/* Reports an error and returns false if any text is left. */
bool text_cursor_finish(struct debugger *debugger, struct text_cursor *cursor);
/* Copies the text between `from` and the cursor, without trailing spaces and truncated
 * to the size. */
void text_cursor_text(const char *from, const struct text_cursor *cursor,
                      char text[MAX_TEXT]);

bool debug_value(struct debugger *debugger, struct text_cursor *cursor,
                 struct value_of *value);
/* debug_grammar checks that the text is an expression, whatever registers and memory
 * contain. debug_address and debug_count evaluate an expression that must be an address
 * or a count. */
bool debug_grammar(struct debugger *debugger, struct text_cursor *cursor);
bool debug_address(struct debugger *debugger, struct text_cursor *cursor,
                   uint64_t *address);
bool debug_count(struct debugger *debugger, struct text_cursor *cursor,
                 uint64_t *count);
/* Converts a value to a word, or to a half word in the left half of a word. Reports an
 * error and returns false if the value is not representable. */
bool debug_word(struct debugger *debugger, const struct value_of *value, bool half,
                c205_word *word);
bool debug_is_true(const struct value_of *value);

/* A register that was written as a number (r10, h21) or as a name of the program. */
struct register_of {
    uint8_t number;
    bool half;
};
/* Parses a register. Returns false without a report if the text is not a register. */
bool debug_register(const struct debugger *debugger, struct text_cursor *cursor,
                    struct register_of *named);
c205_word debug_register_word(const struct debugger *debugger,
                              struct register_of named);

/* ---- Verbs ----------------------------------------------------------------- */

/* Executes a verb. The cursor is at the text after the name of the verb. */
typedef bool debug_verb(struct debugger *debugger, struct text_cursor *cursor);

/* Verbs that the debug adapter uses as well. */
debug_verb verb_print, verb_set;

/* ---- Changes of the state (set.c), after which the program runs differently
 * -------- */

bool debug_set_register(struct debugger *debugger, struct register_of named,
                        const struct value_of *value);
/* Writes at most 64 bits within one word. The bits are left-aligned in the value. */
bool debug_set_bits(struct debugger *debugger, uint64_t address, unsigned width,
                    c205_word bits);
/* Writes bytes from an address on. Reports an error and returns false if a byte is not
 * mapped. */
bool debug_set_bytes(struct debugger *debugger, uint64_t address,
                     const unsigned char *bytes, size_t count);
/* Continues at another address, which must be an instruction of the program's text. */
bool debug_jump(struct debugger *debugger, uint64_t address);

/* ---- Places (place.c) ------------------------------------------------------ */

/* Reads a place and sets the kind, the address and the text of a breakpoint. If the
 * text does not determine the position, the position is added to the text. The grammar
 * is: LABEL, LABEL + EXPRESSION, LINE, FILE:LINE, *EXPRESSION, insn NAME, region
 * NAME. */
bool place_read(struct debugger *debugger, struct text_cursor *cursor,
                struct breakpoint *stop);
/* Sets the kind, the address and the text of a breakpoint at a source line, or at the
 * next line that has code. */
bool place_line(struct debugger *debugger, const char *file, size_t number,
                struct breakpoint *stop);
/* place_address reads any address. place_code reads an address at which an instruction
 * of the program begins. */
bool place_address(struct debugger *debugger, struct text_cursor *cursor,
                   uint64_t *address);
bool place_code(struct debugger *debugger, struct text_cursor *cursor,
                uint64_t *address);
/* Returns the program counter at which an instruction is executed: the address of the
 * LINKV if the instruction belongs to a linked pair, otherwise its own address. */
uint64_t place_of(const struct debugger *debugger, uint64_t address);
/* Returns true if code of a source line, or of a macro called there, begins at an
 * address. */
bool place_begins(const struct debugger *debugger, const char *file, size_t number,
                  uint64_t address);
/* Returns the address of the instruction before an address. Without source lines, code
 * is decoded from the start of its segment, but at most 1024 half words back. */
uint64_t place_before(const struct debugger *debugger, uint64_t address);

/* ---- Stops (breakpoints.c) -------------------------------------------------- */

/* Parses the ADDRESS [, WORDS] of a watchpoint. */
bool breakpoints_watch(struct debugger *debugger, struct text_cursor *cursor,
                       struct breakpoint *stop);
/* Sets the condition to the whole text; "" or NULL removes it. */
bool breakpoints_condition(struct debugger *debugger, struct breakpoint *stop,
                           const char *text);
/* Sets the condition on the number of hits: an operator and its operand, such as "% 3",
 * or the number of the first hit that stops the program. */
bool breakpoints_wanted(struct debugger *debugger, struct breakpoint *stop,
                        const char *text);
/* Adds a copy of the breakpoint and assigns its number. Returns false if memory is
 * exhausted. */
bool breakpoints_add(struct debugger *debugger, struct breakpoint *stop);
/* breakpoints_delete deletes the breakpoint with a number, or returns false if there is
 * none. breakpoints_forget deletes all breakpoints of a group. */
bool breakpoints_delete(struct debugger *debugger, uint64_t number);
void breakpoints_forget(struct debugger *debugger, size_t group);

/* Marks the breakpoints that stop the program at the current location, after the
 * instruction at address `before` was executed. Returns true if there are any. */
bool breakpoints_meet(struct debugger *debugger, uint64_t before);
/* Records the current contents of the watched words. */
void breakpoints_sample(struct debugger *debugger);
/* ---- Output ------------------------------------------------------------------ */

/* Prints all interpretations of a word, or of a half word in the left half of a
 * word. */
void show_word(c205_word word, bool half, const struct sink *sink);

#endif
