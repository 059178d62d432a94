/* c205.h - an emulator of a CYBER 205 style vector computer.
 *
 * The machine is "205-style, reconstructed": docs/machine.md states which parts are
 * known and which are reconstructed. Its time is cycle-accounted: every clock of a run
 * is charged to one cause, and the causes sum to the total.
 *
 * Example:
 *
 *   c205_model *model = c205_model_find("cyber205-2pipe", &error);
 *   c205 *machine = c205_new(model, &error);
 *   c205_load(machine, &program, &error);
 *   c205_stop stop = c205_run(machine, C205_NO_LIMIT);
 *
 * Library functions never print and never exit. Those that can fail take a c205_error,
 * fill its message, and return false or NULL. A machine may be used by one thread at a
 * time. Different machines share no mutable state.
 */
#ifndef C205_H
#define C205_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The release, and the default model of the programs. */
#define C205_VERSION "0.7.0"
#define C205_DEFAULT_MODEL "cyber205-2pipe"

typedef struct c205_error {
    char message[256]; /* one sentence, no newline; empty: no error */
} c205_error;

/* ---- Numbers (vm/number/word.c, decimal.c) ---------------------------------
 *
 * A word is 64 bits; bit 0 is the leftmost. As a number it is
 *
 *   | exponent 16, two's complement | coefficient 48, two's complement |
 *
 * with the value coefficient x 2^exponent. Exponents 8000-8FFF hex mark a machine zero,
 * 7000-7FFF an indefinite. Source: machine notes, section 1.
 */
typedef uint64_t c205_word;

#define C205_MACHINE_ZERO UINT64_C(0x8000000000000000)
#define C205_INDEFINITE UINT64_C(0x7000000000000000)
#define C205_ONE UINT64_C(0xFFD2400000000000)

/* Returns a double rounded down to a normalised word; exact if 47 bits hold it. Too
 * large, infinite or NaN: indefinite. Zero or too small: machine zero. */
c205_word c205_from_double(double value);

/* Returns the exact value within the range of a double. Indefinite gives NaN. Values
 * beyond the range give an infinity or a zero with the right sign. */
double c205_to_double(c205_word word);

/* Returns an integer, -2^47 .. 2^47-1, as a word with exponent 0. */
c205_word c205_from_integer(int64_t value);
/* Returns the low 48 bits, sign extended. */
int64_t c205_to_integer(c205_word word);
/* The parts of a descriptor of a vector: its bit address, the 48 bits at the right, and
 * its length in elements, the 16 bits at the left. */
uint64_t c205_descriptor_address(c205_word descriptor);
size_t c205_descriptor_length(c205_word descriptor);

/* Reads decimal text ("-12.5e-3") of any length and rounds its exact value down to a
 * normalised word. Sets *end to the first unused character; end == text: there is no
 * number. */
c205_word c205_from_text(const char *text, const char **end);

enum { C205_TEXT_SIZE = 40 };
/* Writes the shortest decimal text that c205_from_text reads back as the same value,
 * "indefinite" for an indefinite, and "0" for every zero. */
void c205_to_text(c205_word word, char text[C205_TEXT_SIZE]);
/* Writes a word rounded to the nearest decimal, ties to even. FIXED has the given
 * number of digits after the point. SCIENTIFIC has the given number of digits in all,
 * one of them before the point, then an e and the power of ten. A FIXED number of more
 * than C205_DIGITS digits is written in scientific notation with the given number of
 * digits after the point. */
typedef enum c205_notation { C205_FIXED, C205_SCIENTIFIC } c205_notation;
enum { C205_DIGITS = 17 };
void c205_to_decimal(c205_word word, c205_notation notation, unsigned digits,
                     char text[C205_TEXT_SIZE]);
/* Writes "FFD2 4000 0000 0000". */
void c205_to_hex(c205_word word, char text[C205_TEXT_SIZE]);

/* ---- Half words (vm/number/word.c, decimal.c) ------------------------------
 *
 * A half word is 32 bits:
 *
 *   | exponent 8, two's complement | coefficient 24, two's complement |
 *
 * Exponents 80-8F hex mark a machine zero, 70-7F an indefinite. In this API a half word
 * is always at the left of a c205_word, followed by zeros, so that C205_MACHINE_ZERO
 * and C205_INDEFINITE serve both sizes.
 */
#define C205_HALF_ONE UINT64_C(0xEA40000000000000)

/* Convert half words in the same way; 23 bits of a double or a text remain. */
c205_word c205_half_from_double(double value);
double c205_half_to_double(c205_word half);
c205_word c205_half_from_text(const char *text, const char **end);
void c205_half_to_text(c205_word half, char text[C205_TEXT_SIZE]);

/* ---- Instructions (vm/insn.c, from vm/insn.def, vm/arith.def) ------------ */

typedef enum c205_format {
#define FORMAT(name, halves, syntax) C205_FORMAT_##name,
#include "insn.def"
    C205_FORMATS
} c205_format;

typedef enum c205_unit {
    C205_UNIT_SINGLE,
    C205_UNIT_ADD,
    C205_UNIT_MULTIPLY,
    C205_UNIT_DIVIDE,
    C205_UNIT_LOGICAL,
    C205_UNIT_MEMORY,
    C205_UNIT_BRANCH,
    C205_UNIT_VECTOR, /* the whole unit; the following are its parts */
    C205_UNIT_V_ADD,
    C205_UNIT_V_MULTIPLY,
    C205_UNIT_V_DIVIDE,
    C205_UNIT_V_SHIFT,
    C205_UNIT_V_LOGICAL,
    C205_UNITS
} c205_unit;

typedef enum c205_timing {
#define TIMING(name, kind) C205_TIMING_##name,
#include "insn.def"
    C205_TIMINGS
} c205_timing;

/* The operation on the operands of an instruction, or on each element. */
typedef enum c205_operation {
#define OPERATION(name, specials) C205_OPERATION_##name,
#include "arith.def"
    C205_OPERATIONS
} c205_operation;

/* Bits of c205_insn.flags. */
#define C205_INSN_SIGN 1u
#define C205_INSN_PADZ 2u
#define C205_INSN_PADO 4u
#define C205_INSN_HALF 8u

/* Bits of the G byte, as values of that byte. */
#define C205_G_HALF 0x80u   /* 32-bit operands */
#define C205_G_ZEROS 0x40u  /* a zero in the control vector permits its element */
#define C205_G_OFFSET 0x20u /* C+1 holds the offset of C and Z */
#define C205_G_GIVEN 0x20u  /* sparse instructions: Z is given */
#define C205_G_BROADCAST_A 0x10u
#define C205_G_BROADCAST_B 0x08u
#define C205_G_MAGNITUDE_A 0x04u
#define C205_G_NEGATE_A 0x02u /* after the magnitude, if both are set */
#define C205_G_MAGNITUDE_B 0x01u
#define C205_G_RELATIVE 0x40u /* in B0-B5 */

typedef struct c205_insn {
    const char *mnemonic;
    uint8_t opcode;
    uint8_t subop;      /* fixed bits of G */
    uint8_t subop_mask; /* mask of these bits */
    uint8_t flags;
    c205_format format;
    c205_unit unit;
    c205_timing timing;
    c205_operation operation;
    const char *operands; /* one letter each, see insn.def */
    const char *effect;
    char provenance;
} c205_insn;

extern const c205_insn c205_insns[]; /* in table order */
extern const size_t c205_insn_count;

/* Returns the instruction with a name, in upper or lower case; NULL: none. */
const c205_insn *c205_insn_named(const char *mnemonic, size_t length);
/* Returns the instruction with a code; g is the second byte. NULL: undefined. */
const c205_insn *c205_insn_coded(uint8_t opcode, uint8_t g);

const char *c205_format_name(c205_format format);
const char *c205_format_syntax(c205_format format);
unsigned c205_format_halves(c205_format format);
const char *c205_unit_name(c205_unit unit);
bool c205_unit_is_vector(c205_unit unit);
/* Returns true if instructions of this unit can be linked with those of another such
 * unit. */
bool c205_unit_links(c205_unit unit);
const char *c205_timing_name(c205_timing timing);
bool c205_timing_is_vector(c205_timing timing);
/* Returns the treatment of machine zeros and indefinites, as text. */
const char *c205_operation_specials(c205_operation operation);
/* Returns the number of floating-point operations per element that an operation counts
 * as. */
unsigned c205_operation_flops(c205_operation operation);

/* The fields of an instruction, wherever they are in its word: F8 G8 X8 A8 Y8 B8 Z8 C8
 * for the long formats, F8 R8 S8 T8 for the short ones. */
typedef struct c205_fields {
    uint8_t f, g, x, a, y, b, z, c; /* VECTOR and similar formats, INDEX, FLOAT */
    uint8_t r, s, t;                /* register formats */
    int64_t immediate;              /* I8 .. I48, or the branch distance in half
                                       words */
} c205_fields;

/* Decode and encode an instruction. A short instruction is in the high half of word.
 * Both only move bits: encode inserts every field of the format, decode sets missing
 * fields to zero. */
c205_fields c205_decode(const c205_insn *insn, c205_word word);
c205_word c205_encode(const c205_insn *insn, const c205_fields *fields);

/* ---- Machine models (vm/time/model.c) --------------------------------------
 *
 * A model is a text file of lines "name value unit source # remark". The sources are
 * the letters P S D R of the instruction table, and F: fitted. Built in are
 * cyber205-1pipe, -2pipe and -4pipe, on which programs run, and the projections cdc6600
 * and cyber720, which only supply times. All but the 6600 were fitted; NAME-prior is
 * the state of NAME before the fit. NAME-32bit streams words at the rate of half words.
 * cyber205-2pipe-small has small pages.
 */
typedef struct c205_model c205_model;

typedef struct c205_constant {
    const char *name; /* for example "startup.vadd" */
    const char *text; /* the value as written */
    double value;     /* for display; the clock uses the exact decimal */
    const char *unit; /* "clk", "clk/element", "clk*pipe/element", "ns", ... */
    char source;      /* P S D R F */
    const char *remark;
} c205_constant;

/* The agreement of a model with published figures, as stated in its text. */
typedef struct c205_belief {
    unsigned figures;  /* number of figures; 0: not compared */
    double largest;    /* the largest error, percent */
    const char *worst; /* name of the figure with the largest error */
} c205_belief;

/* Converts a text file to plain text in place. A text file is UTF-8. A byte order mark
 * at its start is dropped. CR, LF and CR LF each end a line and become "\n". 0x1A, the
 * end mark of DOS files, ends the text. UTF-16 is rejected. The result ends with NUL,
 * so there must be room for length + 1 bytes. Returns NULL, or the reason why it is not
 * a text. */
const char *c205_plain_text(char *text, size_t *length);

/* Returns a built-in model, or reads a file if the name contains '/', ends in ".model"
 * or is "-", which is stdin. The model is not changed afterwards. */
c205_model *c205_model_find(const char *name, c205_error *error);
bool c205_model_is_file(const char *name); /* returns true for the name of a file */
c205_model *c205_model_parse(const char *name, const char *text, c205_error *error);
/* c205_model_read parses a model for callers that show the line. The error message
 * lacks the place, which is returned separately; line 0: no line. */
typedef struct c205_place {
    unsigned line, column; /* from 1 */
} c205_place;
c205_model *c205_model_read(const char *name, const char *text, c205_place *place,
                            c205_error *error);
void c205_model_free(c205_model *model);

const char *c205_model_name(const c205_model *model);
const char *c205_model_title(const c205_model *model);
/* The comparisons with the figures used in the fit, and with other figures. */
c205_belief c205_model_fitted(const c205_model *model);
c205_belief c205_model_compared(const c205_model *model);
/* Returns true if the model holds the times of another machine, for a projection
 * only. */
bool c205_model_is_projection(const c205_model *model);
size_t c205_model_size(const c205_model *model);
const c205_constant *c205_model_constant(const c205_model *model, size_t i);
/* NULL: no such constant. */
const c205_constant *c205_model_lookup(const c205_model *model, const char *name);
/* Returns the model whose constants it inherits, or NULL. */
const c205_model *c205_model_like(const c205_model *model);

typedef struct c205_setting {
    const char *name; /* of a constant */
    double value;     /* in its unit; rounded to six decimal places */
} c205_setting;

/* Returns a copy of a model with these constants changed; their source is R. The last
 * of several settings of one constant counts. Its name lists the settings
 * ("cyber205-2pipe with machine.pipes 4"), c205_model_like returns the original, and it
 * has no comparisons with figures. It borrows the texts of the original, which must
 * outlive it. NULL: a constant does not exist, or cannot have that value. */
c205_model *c205_model_change(const c205_model *model, const c205_setting *settings,
                              size_t count, c205_error *error);
/* Returns the names of the built-in models, NULL at the end. */
const char *const *c205_model_names(void);

/* ---- Programs ----------------------------------------------------------- */

typedef struct c205_segment {
    uint64_t address;       /* bit address, a multiple of 64 */
    size_t length;          /* words */
    const c205_word *words; /* NULL: zeros, mapped as C205_WHEN_TOUCHED */
} c205_segment;

/* The code between two addresses belongs to a named region of the accounts. Several
 * ranges may have one name; they share one account. */
typedef struct c205_region {
    const char *name;
    uint64_t begin, end;
} c205_region;

typedef struct c205_program {
    uint64_t entry;
    size_t segment_count;
    const c205_segment *segments;
    size_t region_count;
    const c205_region *regions;
    bool warm; /* starts with its pages in use already: c205_warm */
} c205_program;

/* ---- The machine (vm/machine.c) ----------------------------------------- */

typedef struct c205 c205;

enum { C205_REGISTERS = 256 };
#define C205_NO_LIMIT UINT64_MAX
#define C205_PAGE_WORDS 65536u /* large page (source P); the unit of storage */
#define C205_MAX_LENGTH 65535u /* of a vector (source P) */

/* The cause of a clock; each clock has one cause. */
typedef enum c205_cause {
    C205_ISSUE,
    C205_OPERAND_WAIT,
    C205_UNIT_BUSY,
    C205_BRANCH,
    C205_MEMORY_WAIT,
    C205_VECTOR_STARTUP,
    C205_VECTOR_STREAM,
    C205_BANK_CONFLICT,
    C205_TRANSLATION_MISS,
    C205_PAGE_FAULT,
    C205_CAUSES
} c205_cause;
const char *c205_cause_name(c205_cause cause);

typedef enum c205_trap {
    C205_TRAP_NONE,
    C205_TRAP_UNDEFINED_INSTRUCTION, /* no such opcode or G bits */
    C205_TRAP_UNMAPPED_ADDRESS,
    C205_TRAP_PROTECTED_ADDRESS,  /* write to read-only memory */
    C205_TRAP_BAD_DESCRIPTOR,     /* negative offset, missing vector, ... */
    C205_TRAP_MISALIGNED_OPERAND, /* for example a word vector that does not start at a
                                     word */
    C205_TRAP_BAD_LINK,           /* the pair after LINKV cannot be linked */
    C205_TRAP_BAD_REQUEST,        /* no such monitor request */
    C205_TRAP_CLOCK_LIMIT,
    C205_TRAP_NO_MEMORY, /* the host is out of memory */
    C205_TRAP_PAUSED,    /* by c205_pause, or after a given number of instructions */
    C205_TRAP_BREAKPOINT,
    C205_TRAP_WATCHPOINT, /* address: of the watched words */
    C205_TRAPS
} c205_trap;
const char *c205_trap_name(c205_trap trap); /* for example "undefined-instruction" */

/* The end of a run. */
typedef struct c205_stop {
    c205_trap trap;        /* NONE: the program ended itself with EXIT */
    uint64_t pc;           /* bit address of the instruction that stopped */
    uint64_t address;      /* the operand address at fault, or 0 */
    const char *rule;      /* the broken rule, a sentence; NULL: none */
    const c205_insn *insn; /* NULL: undefined */
    int64_t status;        /* operand R of EXIT */
} c205_stop;

typedef struct c205_account {
    const char *name; /* region; "" is all code outside regions */
    uint64_t clocks[C205_CAUSES];
    uint64_t instructions; /* all issued instructions */
    uint64_t vector_instructions;
    uint64_t elements;   /* of vector results or scanned operands */
    uint64_t operations; /* floating-point operations, scalar or on elements */
    uint64_t entries;    /* number of times that control entered the region */
} c205_account;

/* A range of memory. */
typedef struct c205_range {
    uint64_t address, bits;
} c205_range;
enum { C205_STORES = 3 };

/* The kinds of events. Listeners are notified once after each instruction. */
typedef enum c205_event_kind {
    C205_EVENT_INSTRUCTION,
    C205_EVENT_REQUEST, /* EXIT with a request other than 0 */
    C205_EVENT_TRAP,
    C205_EVENT_STOP
} c205_event_kind;

/* The object of a wait. */
typedef enum c205_wait {
    C205_WAIT_NONE,     /* no wait: work of the instruction itself */
    C205_WAIT_REGISTER, /* a register by number: a source that was not ready, or a
                           pending result */
    C205_WAIT_UNIT,     /* a unit by number of c205_unit: it was busy */
    C205_WAIT_LOADS,    /* all loads in flight, or the oldest if the maximum is in
                           flight */
    C205_WAIT_RESULTS,  /* all results in flight */
    C205_WAIT_VECTOR,   /* the vector unit was busy */
    C205_WAITS
} c205_wait;

typedef struct c205_piece {
    uint64_t clocks;
    c205_cause cause;
    size_t region; /* whose account is charged */
    uint64_t pc;   /* the instruction that does the work; a vector instruction continues
                      while others wait */
    c205_wait wait;
    unsigned number; /* of the register or unit, or 0 */
} c205_piece;

/* The times of one instruction, recorded by the clock. The pieces, in the order of
 * time, sum to the clocks by which the instruction advanced the clock. A vector
 * instruction continues after that. Its phases follow each other from its issue to its
 * end; phases of zero length are omitted. */
enum { C205_PIECES = 40, C205_PHASES = 5 };
typedef struct c205_times {
    uint64_t pc;
    uint64_t arrived;   /* the clock before it */
    uint64_t issued;    /* the clock at which it issued */
    uint64_t ready;     /* the clock at which its results are ready */
    uint64_t unit_free; /* the clock at which its unit accepts the next instruction; for
                           a vector instruction, one whose start-up does not overlap */
    uint64_t misses;    /* pages not in the associative registers */
    uint64_t faults;    /* those of them not in real memory */
    size_t piece_count, phase_count;
    c205_piece piece[C205_PIECES];
    struct {
        uint64_t begin, end;
        c205_cause cause;
    } phase[C205_PHASES];
} c205_times;

typedef struct c205_event {
    c205_event_kind kind;
    uint64_t pc;
    const c205_insn *insn;
    c205_fields fields;
    size_t region;            /* index into the accounts */
    uint64_t issued;          /* the clock at which it issued */
    uint64_t clocks;          /* by which it advanced the clock */
    const c205_times *record; /* its times; after an end or a trap only the pieces of
                                 the wait for everything in flight; NULL: none */
    size_t elements;          /* vector length, 0 for scalar instructions */
    size_t recurrent;         /* elements that waited for the result of an earlier
                                 one */
    bool taken;               /* branches */
    /* The changes: register r that it wrote is bit r % 64 of written[r / 64], and store
     * lists the ranges of memory that it stored into. With a control vector it stored
     * only parts of them. For a list of indices, the range is the smallest one that
     * contains all of its elements. */
    uint64_t written[C205_REGISTERS / 64];
    size_t store_count;
    c205_range store[C205_STORES];
    /* For C205_EVENT_REQUEST: */
    unsigned request;
    c205_word r, s; /* its operands */
    c205_trap trap;
} c205_event;

typedef void c205_listener(void *context, const c205 *machine, const c205_event *event);

c205 *c205_new(const c205_model *model, c205_error *error);
void c205_free(c205 *machine);

/* Zeroes registers, clock and accounts, unmaps all memory, maps and fills the segments
 * of the program, and sets the program counter to its entry. */
bool c205_load(c205 *machine, const c205_program *program, c205_error *error);

typedef enum c205_access {
    C205_READ_ONLY,
    C205_READ_WRITE,
    C205_WHEN_TOUCHED /* may be read and written; the host allocates a page on first
                         use, and if it cannot, the page counts as unmapped */
} c205_access;
/* Maps the pages of a range of words that starts at a bit address. Pages that were not
 * mapped before are zeroed. */
bool c205_map(c205 *machine, uint64_t address, size_t words, c205_access access,
              c205_error *error);

/* Words that machines in any threads share. A page is copied for a machine before that
 * machine first writes to it. The words must exist as long as any of these machines
 * runs or is inspected. A machine may still be freed, or load another program, after
 * the words are freed. */
typedef struct c205_shared c205_shared;
/* The words are followed by zeros to the end of the last page. NULL: out of memory. */
c205_shared *c205_shared_new(const c205_word *words, size_t count);
void c205_shared_free(c205_shared *shared);
/* Maps the words from the address of a page on. No page may be mapped there. */
bool c205_map_shared(c205 *machine, uint64_t address, const c205_shared *shared,
                     c205_error *error);

/* Finds the first mapped page from an address on. Sets whether it may be written, and
 * whether a C205_WHEN_TOUCHED page has been used. Returns false if there is none. */
typedef struct c205_page {
    uint64_t address;
    bool writable, touched;
} c205_page;
bool c205_next_page(const c205 *machine, uint64_t from, c205_page *page);

/* Puts all mapped pages into real memory and the associative registers as far as there
 * is room, with preference for the highest addresses, as if the program had used them
 * before. Takes no clocks. */
void c205_warm(c205 *machine);

/* Copy between the host and the machine's memory; take no clocks. Fail without effect
 * if a page is not mapped. */
bool c205_read(const c205 *machine, uint64_t address, c205_word *words, size_t count);
bool c205_write(c205 *machine, uint64_t address, const c205_word *words, size_t count);

/* Runs until the program ends, a trap occurs, or the clock has reached limit. The limit
 * may stop the run between two instructions or within a vector instruction. In the
 * latter case its first elements are stored, and the program counter stays at it. The
 * next run continues there, and its results, clocks and accounts are those of a run
 * without a stop. Nothing happens if the clock has already reached the limit. */
c205_stop c205_run(c205 *machine, uint64_t limit);
/* Executes one instruction, or the rest of an interrupted one. A linked pair with its
 * prefix counts as one. Returns true if the program continues; otherwise *stop states
 * the reason. */
bool c205_step(c205 *machine, c205_stop *stop);
/* Runs at most count instructions, then stops with PAUSED; otherwise like c205_run. */
c205_stop c205_run_steps(c205 *machine, uint64_t count, uint64_t limit);
/* Writes a text such as "trap unmapped-address at 1000: ADDNV: address 2040: no memory
 * is mapped there". */
void c205_describe_stop(const c205 *machine, const c205_stop *stop, c205_error *text);

c205_word c205_register(const c205 *machine, unsigned number);
void c205_set_register(c205 *machine, unsigned number, c205_word word);
uint64_t c205_pc(const c205 *machine);
/* Sets the program counter and abandons an interrupted vector instruction: its stored
 * elements remain, its other results are lost, and its clocks so far are charged. */
void c205_set_pc(c205 *machine, uint64_t address);
c205_word c205_data_flags(const c205 *machine);

/* Returns the clocks charged so far: the sum of all accounts. After the end of a
 * program or a trap, everything in flight is included. At the clock limit it is not.
 * Within a vector instruction the clock equals the limit, and the accounts include the
 * clocks of that instruction up to there. The instruction is counted when it is done.
 *
 * After a trap or at the limit, a run may continue as if it had not been stopped, from
 * the clock at which the instruction at the program counter issues. If a missing page
 * was mapped in between, the final times are those of a run with the page present from
 * the start.
 */
uint64_t c205_clock(const c205 *machine);
const c205_model *c205_machine_model(const c205 *machine);
size_t c205_account_count(const c205 *machine);
const c205_account *c205_account_at(const c205 *machine, size_t i);
/* Sets clock and accounts to zero and empties the pipes. Memory, registers, resident
 * pages and the remaining time of the job interval timer are unchanged. An interrupted
 * instruction remains interrupted, and is charged as a whole when it is done. */
void c205_reset_clock(c205 *machine);

/* Adds a listener. Returns false if there are C205_LISTENERS already. */
enum { C205_LISTENERS = 8 };
bool c205_listen(c205 *machine, c205_listener *listener, void *context);

/* ---- Breakpoints and watchpoints (vm/breakpoints.c) ------------------------------
 *
 * They end a run after an instruction with a trap of their own, of which listeners are
 * notified like of others. The next run continues there as if it had not been stopped.
 * Loading a program keeps them. Saving a machine omits them.
 */

/* For a listener: stops the run with PAUSED after the current instruction. */
void c205_pause(c205 *machine);
/* Stops a run with BREAKPOINT before the instruction at an address, unless the run
 * begins there. set: add or remove. Returns false if memory is exhausted. */
bool c205_break(c205 *machine, uint64_t address, bool set);
/* Stops a run with WATCHPOINT after an instruction that changed one of these words.
 * Writes by the host between two runs do not count, except within a vector instruction
 * that a limit interrupted. set: add or remove. Returns false if memory is exhausted or
 * nothing is mapped there. */
bool c205_watch(c205 *machine, uint64_t address, size_t words, bool set);

/* ---- The time of other machines (vm/time/projection.c) ---------------------
 *
 * A listener that charges each scalar instruction of a program with the time that
 * another machine would take for the same operation.
 */
typedef struct c205_projection c205_projection;

/* Returns a new projection. The model must be a projection. */
c205_projection *c205_projection_new(const c205_model *model, c205_error *error);
void c205_projection_free(c205_projection *projection);
/* The listener; its context is the projection. */
c205_listener c205_project;
/* Returns the clocks of that machine for a region, numbered as in the accounts. */
uint64_t c205_projected_clocks(const c205_projection *projection, size_t region);
/* Returns false if there were vector instructions or memory ran out. */
bool c205_projection_holds(const c205_projection *projection, c205_error *error);

/* ---- Other constants for the same run (vm/time/recording.c) ----------------
 *
 * A listener that records the input of the clock during a run, and computes the time of
 * the same run with other constants, by the machine's own clock or by a projection. The
 * result is exact as long as the program does not read the clock.
 */
typedef struct c205_recording c205_recording;
c205_recording *c205_recording_new(c205_error *error);
void c205_recording_free(c205_recording *recording);
/* The listener; its context is the recording of one run from its start. */
c205_listener c205_record;

/* Sets the clocks of each region, numbered as in the accounts; 0 for regions that did
 * not run. The settings replace constants of the model. Time advances in ticks, of
 * which a clock has the given number (1: as in the machine). By a projection: NaN for
 * regions with vector instructions. */
bool c205_retime(const c205_recording *recording, const c205_model *model,
                 const c205_setting *settings, size_t count, unsigned ticks,
                 double *clocks, size_t regions, c205_error *error);

/* ---- Saving and restoring (vm/save.c) --------------------------------------
 *
 * A machine that is not running (not in a listener) as a list of bytes: format version,
 * model, program, registers, memory, the clock with everything in flight, and the
 * progress of an interrupted vector instruction. A restored machine continues like the
 * saved one: same results, same clocks, same accounts. Listeners are not saved.
 */

/* Takes the next bytes. Returns false if it cannot, which ends the saving. */
typedef bool c205_writer(void *context, const void *bytes, size_t count);

bool c205_save(const c205 *machine, c205_writer *write, void *context,
               c205_error *error);
/* Returns a new machine from bytes saved on a model with the same constants. NULL: the
 * bytes are damaged, not a saved machine, or of another version or model. */
c205 *c205_restore(const void *bytes, size_t count, const c205_model *model,
                   c205_error *error);

/* ---- Going back (vm/history.c) ---------------------------------------------
 *
 * A machine that executes one instruction at a time and can return to any earlier step.
 * It uses snapshots and runs again from the last one before that step. State, clock and
 * accounts are those of a run that reached the step for the first time.
 */
typedef struct c205_history c205_history;

/* Returns a history that owns the machine; its current state is step 0. budget limits
 * the bytes of the snapshots, but two snapshots and those of c205_history_changed are
 * always kept. Fewer snapshots make going back slower. NULL: out of memory; the machine
 * still belongs to the caller. */
c205_history *c205_history_new(c205 *machine, size_t budget, c205_error *error);
void c205_history_free(c205_history *history);
/* Returns the machine at this step. After going back it is another machine with the
 * same listeners. */
c205 *c205_history_machine(const c205_history *history);
/* Return the instructions since step 0: of the current step, and of the last known
 * step. */
uint64_t c205_history_step(const c205_history *history);
uint64_t c205_history_known(const c205_history *history);
/* Executes one instruction like c205_step. If the program has ended, returns the same
 * stop again. */
bool c205_history_forward(c205_history *history, c205_stop *stop);
/* Goes to an earlier step. Listeners are notified only of the last instruction that
 * runs again. Returns false if memory is exhausted; the machine is then unchanged, or
 * at a step before the requested one. */
bool c205_history_back(c205_history *history, uint64_t step, c205_error *error);
/* Must be called after the host wrote registers or memory: later steps are discarded.
 * Returns false if memory is exhausted; going back then works as before the change. */
bool c205_history_changed(c205_history *history, c205_error *error);

/* Returns a hash of entry, segments and regions that identifies a program. */
uint64_t c205_program_hash(const c205_program *program);
/* Returns that of the program last loaded; 0: none. */
uint64_t c205_loaded_program(const c205 *machine);

#ifdef __cplusplus
}
#endif
#endif
