/* debugger_engine.h - the internals of a debugger, for its verbs and for the debug
 * adapter of editors (asm/dap). Not public.
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

/* The value of an expression. A number of the program text has no word. A word of the
 * machine keeps its bits in `word`; a half word is in the left half of it. */
struct value_of {
    bool is_real, is_word, is_half;
    int64_t integer; /* of a word: its low 48 bits */
    double real;     /* the value as a number, always valid */
    c205_word word;
};

/* A cursor in a text that is being parsed. */
struct text_cursor {
    const char *at;
};

/* ---- Stops (breakpoints.c) ------------------------------------------------------ */

enum breakpoint_kind {
    BREAK_ADDRESS, /* an address */
    BREAK_LINE,    /* where code of a source line begins, or of a macro that the line
                 * calls */
    BREAK_INSN,    /* each instruction with a given mnemonic */
    BREAK_ENTRY,   /* where control enters a region */
    BREAK_WATCH    /* the contents of memory change */
};

enum { WATCHED_WORDS = 64, MAX_TEXT = 200 };

struct breakpoint {
    size_t number;
    size_t group; /* stops of a group are deleted together; 0: no group */
    enum breakpoint_kind kind;
    bool once;
    char text[MAX_TEXT];      /* as the user wrote it */
    char condition[MAX_TEXT]; /* "": none */
    char wanted[MAX_TEXT];    /* condition on the number of hits: "> 4", "% 3"; or "" */
    bool met;                 /* met at the current location */
    uint64_t address;
    const char *file; /* of BREAK_LINE, and of BREAK_ADDRESS if it is known */
    size_t line;
    const c205_insn *insn;
    const char *region;
    size_t count; /* number of watched words, and their last values */
    c205_word held[WATCHED_WORDS];
    uint64_t hits; /* times that it was met while executing forward */
};

/* ---- A debugger ----------------------------------------------------------- */

struct debugger {
    struct debugger_setup setup;
    struct sink out;
    c205_history *history;
    struct printer printer;
    struct line_tracker printed; /* the output of the program */
    uint64_t reported;           /* number of steps whose output has been printed */
    bool has_last;               /* `last` and `record` are valid */
    c205_event last;
    c205_times record; /* times of the last instruction */
    bool has_end;      /* the program has ended, and `end` is valid */
    c205_times end;    /* times of the results that were in flight then */
    bool halted;       /* the program cannot continue; `halt` is valid */
    c205_stop halt;
    uint64_t asked; /* clock at the last poll for an interruption */
    bool searching; /* replaying to find a stop: hits are not counted */
    size_t breakpoint_count, breakpoint_number;
    struct breakpoint *breakpoints;
    char again[MAX_TEXT]; /* the last execution command, which an empty line repeats */
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
/* Skips a word (letters, digits, _ . $) that is equal to `word` or, in
 * text_cursor_begin, is a prefix of it. Returns true if there was one. */
bool text_cursor_take(struct text_cursor *cursor, const char *word);
bool text_cursor_begin(struct text_cursor *cursor, const char *word);
/* Skips a sign such as "=". Returns true if there was one. */
bool text_cursor_sign(struct text_cursor *cursor, const char *sign);
/* Fails if any text is left. */
bool text_cursor_finish(struct debugger *debugger, struct text_cursor *cursor);
/* Copies the text from `from` to the cursor, truncated to the size, without trailing
 * spaces. */
void text_cursor_text(const char *from, const struct text_cursor *cursor,
                      char text[MAX_TEXT]);

/* Parses and evaluates an expression. */
bool debug_value(struct debugger *debugger, struct text_cursor *cursor,
                 struct value_of *value);
/* Checks that the text is an expression, independently of the values of registers and
 * memory. */
bool debug_grammar(struct debugger *debugger, struct text_cursor *cursor);
bool debug_address(struct debugger *debugger, struct text_cursor *cursor,
                   uint64_t *address);
bool debug_count(struct debugger *debugger, struct text_cursor *cursor,
                 uint64_t *count);
/* Converts a value to a word, or to a half word in the left half of one. Fails if the
 * value is not representable. */
bool debug_word(struct debugger *debugger, const struct value_of *value, bool half,
                c205_word *word);
bool debug_is_true(const struct value_of *value);

/* A register, from its number (r10, h21) or from a name of the program. */
struct register_of {
    uint8_t number;
    bool half;
};
/* Parses a register. Returns false without a report if the text is none. */
bool debug_register(const struct debugger *debugger, struct text_cursor *cursor,
                    struct register_of *named);
c205_word debug_register_word(const struct debugger *debugger,
                              struct register_of named);

/* ---- Verbs ----------------------------------------------------------------- */

/* Executes a verb with the rest of its line. */
typedef bool debug_verb(struct debugger *debugger, struct text_cursor *cursor);

/* Verbs that the debug adapter uses as well. */
debug_verb verb_print, verb_set;

/* ---- Changes of the state (set.c): they start a different run --------------- */

bool debug_set_register(struct debugger *debugger, struct register_of named,
                        const struct value_of *value);
/* Writes at most 64 bits, all within one word. The bits are left-aligned in the
 * value. */
bool debug_set_bits(struct debugger *debugger, uint64_t address, unsigned width,
                    c205_word bits);
/* Writes bytes from an address on, and fails if one of them is not mapped. */
bool debug_set_bytes(struct debugger *debugger, uint64_t address,
                     const unsigned char *bytes, size_t count);
/* Continues at another address. It must be an instruction of the program's text. */
bool debug_jump(struct debugger *debugger, uint64_t address);

/* ---- Places (place.c) ------------------------------------------------------ */

/* Reads a place and sets the kind, the address and the text of a stop. If the stop is
 * at another place than the text names, the text includes its position. The grammar is:
 * LABEL, LABEL + EXPRESSION, LINE, FILE:LINE, *EXPRESSION, insn NAME, region NAME. */
bool place_read(struct debugger *debugger, struct text_cursor *cursor,
                struct breakpoint *stop);
/* Does the same for a source line, or the next line that has code. */
bool place_line(struct debugger *debugger, const char *file, size_t number,
                struct breakpoint *stop);
/* place_address reads any address. place_code reads an address at which an instruction
 * of the program begins. */
bool place_address(struct debugger *debugger, struct text_cursor *cursor,
                   uint64_t *address);
bool place_code(struct debugger *debugger, struct text_cursor *cursor,
                uint64_t *address);
/* Returns where the program counter is before the instruction at an address is
 * executed. For an instruction linked by a LINKV that is the address of the LINKV. */
uint64_t place_of(const struct debugger *debugger, uint64_t address);
/* Returns whether code of that source line, or of a macro called there, begins at an
 * address. */
bool place_begins(const struct debugger *debugger, const char *file, size_t number,
                  uint64_t address);
/* Returns whether a line belongs to a macro that another line calls. */
bool place_is_called(const struct asm_line *line);
/* Returns the address of the instruction before an address, by the program's lines. */
uint64_t place_before(const struct debugger *debugger, uint64_t address);

/* ---- Stops (breakpoints.c) -------------------------------------------------- */

/* Parses ADDRESS [, WORDS] of a watchpoint. */
bool breakpoints_watch(struct debugger *debugger, struct text_cursor *cursor,
                       struct breakpoint *stop);
/* Sets the condition to the whole text; "" or NULL: none. */
bool breakpoints_condition(struct debugger *debugger, struct breakpoint *stop,
                           const char *text);
/* Sets the condition on hits: an operator and its operand, or the number of the first
 * hit at which it stops. */
bool breakpoints_wanted(struct debugger *debugger, struct breakpoint *stop,
                        const char *text);
/* Adds a copy of the stop and assigns its number. Fails if memory is exhausted. */
bool breakpoints_add(struct debugger *debugger, struct breakpoint *stop);
/* breakpoints_delete deletes the stop with a number, and returns false if there is
 * none; breakpoints_forget deletes all stops of a group. */
bool breakpoints_delete(struct debugger *debugger, uint64_t number);
void breakpoints_forget(struct debugger *debugger, size_t group);

/* Marks the stops that are met at the current location after the last instruction, and
 * returns whether any is. before: the address of that instruction. */
bool breakpoints_meet(struct debugger *debugger, uint64_t before);
/* Records the current contents of the watched words. */
void breakpoints_sample(struct debugger *debugger);
/* ---- Output ------------------------------------------------------------------ */

/* Prints a word, or a half word in the left half of one, in all its interpretations. */
void show_word(c205_word word, bool half, const struct sink *sink);

#endif
