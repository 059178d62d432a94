/* c205.h - an emulator of a CYBER 205 style vector computer.
 *
 * The machine is "205-style, reconstructed": docs/machine.md says for each
 * part what is known and what is not.  Its time is cycle-accounted: every
 * clock of a run is charged to one cause, and the causes sum to the total.
 *
 * How it is used:
 *
 *   c205_model *model = c205_model_find("cyber205-2pipe", &error);
 *   c205 *machine = c205_new(model, &error);
 *   c205_load(machine, &program, &error);
 *   c205_stop stop = c205_run(machine, C205_NO_LIMIT);
 *
 * Library functions never print and never exit.  Those that can fail take a
 * c205_error, fill its message, and return false or NULL.  A machine is used
 * by one thread at a time; different machines share nothing that changes.
 */
#ifndef C205_H
#define C205_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The release; the model that programs take unless told otherwise. */
#define C205_VERSION "0.7.0"
#define C205_DEFAULT_MODEL "cyber205-2pipe"

typedef struct c205_error {
    char message[256]; /* one sentence, no newline; empty: no error */
} c205_error;

/* ---- Numbers (vm/number/word.c, decimal.c) --------------------------------------
 *
 * A word is 64 bits; bit 0 is the leftmost.  As a number it is
 *
 *   | exponent 16, two's complement | coefficient 48, two's complement |
 *
 * with the value coefficient x 2^exponent.  An exponent of 8000-8FFF hex is
 * machine zero, of 7000-7FFF indefinite.  Source: machine notes, section 1.
 */
typedef uint64_t c205_word;

#define C205_MACHINE_ZERO UINT64_C(0x8000000000000000)
#define C205_INDEFINITE UINT64_C(0x7000000000000000)
#define C205_ONE UINT64_C(0xFFD2400000000000)

/* The normalised word nearest below (floor) to a double; exact wherever 47
 * bits hold it.  Too large, infinite or NaN: indefinite; zero or too small:
 * machine zero. */
c205_word c205_from_double(double value);

/* Exact up to the range of a double; indefinite gives NaN, values beyond
 * the range an infinity or zero with the right sign. */
double c205_to_double(c205_word word);

/* An integer, -2^47 .. 2^47-1, as a word with exponent 0. */
c205_word c205_from_integer(int64_t value);
/* The low 48 bits, sign extended. */
int64_t c205_to_integer(c205_word word);

/* Decimal text ("-12.5e-3"), cut (floor) to a normalised word from the exact
 * decimal value, whatever its length.  *end is set to the first character
 * not used; end == text: no number there. */
c205_word c205_from_text(const char *text, const char **end);

enum { C205_TEXT_SIZE = 40 };
/* The shortest decimal text that c205_from_text reads back as the same
 * value; "indefinite" for those, "0" for every zero. */
void c205_to_text(c205_word word, char text[C205_TEXT_SIZE]);
/* To the nearest of so many digits, of two the even one: behind the point (FIXED), or in
 * all, the first before the point, and the power of ten behind an e (SCIENTIFIC).  What
 * has more than C205_DIGITS digits so is written in scientific notation with as many behind
 * the point. */
typedef enum c205_notation { C205_FIXED, C205_SCIENTIFIC } c205_notation;
enum { C205_DIGITS = 17 };
void c205_to_decimal(c205_word word, c205_notation notation, unsigned digits,
                     char text[C205_TEXT_SIZE]);
/* "FFD2 4000 0000 0000" */
void c205_to_hex(c205_word word, char text[C205_TEXT_SIZE]);

/* ---- Half words (vm/number/word.c, decimal.c) ----------------------------------
 *
 * A half word is 32 bits:
 *
 *   | exponent 8, two's complement | coefficient 24, two's complement |
 *
 * with the exponents 80-8F hex for machine zero, 70-7F for indefinite.  Here
 * it always is at the left of a c205_word, zeros behind it, so that
 * C205_MACHINE_ZERO and C205_INDEFINITE serve both sizes.
 */
#define C205_HALF_ONE UINT64_C(0xEA40000000000000)

/* As for words; 23 bits are left of a double or a text. */
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
    C205_UNIT_VECTOR, /* all of it; the rest are parts of it */
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

/* What is done with the operands of an instruction, or with each element. */
typedef enum c205_operation {
#define OPERATION(name, specials) C205_OPERATION_##name,
#include "arith.def"
    C205_OPERATIONS
} c205_operation;

/* insn.flags */
#define C205_INSN_SIGN 1u
#define C205_INSN_PADZ 2u
#define C205_INSN_PADO 4u
#define C205_INSN_HALF 8u

/* Bits of the G byte, as values of that byte. */
#define C205_G_HALF 0x80u   /* 32-bit operands */
#define C205_G_ZEROS 0x40u  /* control vector acts on zeros */
#define C205_G_OFFSET 0x20u /* C+1 holds the offset of C and Z */
#define C205_G_GIVEN 0x20u  /* of sparse rows instead: Z is given */
#define C205_G_BROADCAST_A 0x10u
#define C205_G_BROADCAST_B 0x08u
#define C205_G_MAGNITUDE_A 0x04u
#define C205_G_NEGATE_A 0x02u /* after the magnitude, if both */
#define C205_G_MAGNITUDE_B 0x01u
#define C205_G_RELATIVE 0x40u /* in B0-B5 */

typedef struct c205_insn {
    const char *mnemonic;
    uint8_t opcode;
    uint8_t subop;      /* fixed bits of G .. */
    uint8_t subop_mask; /* .. and which they are */
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

/* By name, any case; NULL: there is none. */
const c205_insn *c205_insn_named(const char *mnemonic, size_t length);
/* By code; g is the second byte.  NULL: undefined. */
const c205_insn *c205_insn_coded(uint8_t opcode, uint8_t g);

const char *c205_format_name(c205_format format);
const char *c205_format_syntax(c205_format format);
unsigned c205_format_halves(c205_format format);
const char *c205_unit_name(c205_unit unit);
bool c205_unit_is_vector(c205_unit unit);
/* Whether its instructions can be linked with those of another such unit. */
bool c205_unit_links(c205_unit unit);
const char *c205_timing_name(c205_timing timing);
bool c205_timing_is_vector(c205_timing timing);
/* What it makes of machine zeros and indefinites. */
const char *c205_operation_specials(c205_operation operation);
/* Floating-point operations that it counts as, on one element. */
unsigned c205_operation_flops(c205_operation operation);

/* The fields of an instruction, wherever they lie in its word.  F8 G8 X8 A8
 * Y8 B8 Z8 C8 for the long formats, F8 R8 S8 T8 for the short ones. */
typedef struct c205_fields {
    uint8_t f, g, x, a, y, b, z, c; /* VECTOR and its kin, INDEX, FLOAT */
    uint8_t r, s, t;                /* register formats */
    int64_t immediate;              /* I8 .. I48, or the branch distance in halves */
} c205_fields;

/* Take an instruction apart and put it together.  A short instruction lies
 * in the high half of word.  Both are pure bit moving: encode puts every
 * field of the format, decode gives zero for the fields it lacks. */
c205_fields c205_decode(const c205_insn *insn, c205_word word);
c205_word c205_encode(const c205_insn *insn, const c205_fields *fields);

/* ---- Machine models (vm/time/model.c) -----------------------------------
 *
 * A model is a text file of lines "name value unit source # remark"; the
 * sources are the letters P S D R of the instruction table, and F: fitted.
 * Built in are cyber205-1pipe, -2pipe and -4pipe, on which programs run, and
 * the projections cdc6600 and cyber720, which only tell times.  All but the
 * 6600 were fitted; NAME-prior is what NAME was before.  NAME-32bit streams
 * words at the rate of half words; cyber205-2pipe-small has small pages.
 */
typedef struct c205_model c205_model;

typedef struct c205_constant {
    const char *name; /* "startup.vadd" */
    const char *text; /* the value as written */
    double value;     /* for display; the clock uses the exact decimal */
    const char *unit; /* "clk", "clk/element", "clk*pipe/element", "ns" .. */
    char source;      /* P S D R F */
    const char *remark;
} c205_constant;

/* How near a model comes to published figures, as its own text has it. */
typedef struct c205_belief {
    unsigned figures;  /* so many; 0: it has not been compared with any */
    double largest;    /* the largest error, percent */
    const char *worst; /* which figure's that is */
} c205_belief;

/* What a text file is.  It is UTF-8.  A byte order mark at its start is not part
 * of it.  CR, LF and CR LF each end a line.  0x1A, the end mark of DOS files, ends
 * the text.  UTF-16 is rejected.
 * Rewrites a text in place: without the mark, with "\n" at the end of each line,
 * and with a NUL after it; there is room for length + 1 bytes.  Returns NULL, or
 * the reason why it is not a text. */
const char *c205_plain_text(char *text, size_t *length);

/* A built-in model, or a file if the name holds a '/', ends in ".model" or is
 * "-", which is stdin.
 * The model is read once and not changed afterwards. */
c205_model *c205_model_find(const char *name, c205_error *error);
bool c205_model_is_file(const char *name); /* the name is that of a file */
c205_model *c205_model_parse(const char *name, const char *text, c205_error *error);
/* The same for who shows the line: the error's message is without its place,
 * which is told apart; line 0: of no line. */
typedef struct c205_place {
    unsigned line, column; /* from 1 */
} c205_place;
c205_model *c205_model_read(const char *name, const char *text, c205_place *place,
                            c205_error *error);
void c205_model_free(c205_model *model);

const char *c205_model_name(const c205_model *model);
const char *c205_model_title(const c205_model *model);
/* What it was fitted to; and with what it was only compared. */
c205_belief c205_model_fitted(const c205_model *model);
c205_belief c205_model_compared(const c205_model *model);
/* The times of another machine, for a projection alone. */
bool c205_model_is_projection(const c205_model *model);
size_t c205_model_size(const c205_model *model);
const c205_constant *c205_model_constant(const c205_model *model, size_t i);
/* NULL: no such constant. */
const c205_constant *c205_model_lookup(const c205_model *model, const char *name);
/* The model whose constants it took over, or NULL. */
const c205_model *c205_model_like(const c205_model *model);

typedef struct c205_setting {
    const char *name; /* of a constant */
    double value;     /* in its unit; six places after the point count */
} c205_setting;

/* The model with these constants in place of its own, their source R; of two
 * settings of one constant the last counts.  Its name says what they are
 * ("cyber205-2pipe with machine.pipes 4"), c205_model_like gives the model,
 * and it was fitted to nothing and compared with nothing.  It borrows the
 * texts of the model, which must outlive it.  NULL: there is no such constant,
 * or it cannot have that value. */
c205_model *c205_model_change(const c205_model *model, const c205_setting *settings,
                              size_t count, c205_error *error);
/* Names of the built-in models, NULL at the end. */
const char *const *c205_model_names(void);

/* ---- Programs ----------------------------------------------------------- */

typedef struct c205_segment {
    uint64_t address;       /* bit address, a multiple of 64 */
    size_t length;          /* words */
    const c205_word *words; /* NULL: zeros, C205_WHEN_TOUCHED */
} c205_segment;

/* Code between two addresses belongs to a named region of the accounts.
 * Several ranges may bear one name; they share one account. */
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
    bool warm; /* it begins as if it had used its pages before: c205_warm */
} c205_program;

/* ---- The machine (vm/machine.c) ----------------------------------------- */

typedef struct c205 c205;

enum { C205_REGISTERS = 256 };
#define C205_NO_LIMIT UINT64_MAX
#define C205_PAGE_WORDS 65536u /* large page (source P); those of storage */
#define C205_MAX_LENGTH 65535u /* of a vector (source P) */

/* Why a clock passed; each clock has one cause. */
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
    C205_TRAP_PROTECTED_ADDRESS,  /* write to memory that is read-only */
    C205_TRAP_BAD_DESCRIPTOR,     /* negative offset, missing vector .. */
    C205_TRAP_MISALIGNED_OPERAND, /* word vector not on a word, ... */
    C205_TRAP_BAD_LINK,           /* the pair after LINKV cannot be linked */
    C205_TRAP_BAD_REQUEST,        /* the monitor knows no such request */
    C205_TRAP_CLOCK_LIMIT,
    C205_TRAP_NO_MEMORY, /* the host has none left */
    C205_TRAP_PAUSED,    /* by c205_pause, or after so many instructions */
    C205_TRAP_BREAKPOINT,
    C205_TRAP_WATCHPOINT, /* address: of what is watched */
    C205_TRAPS
} c205_trap;
const char *c205_trap_name(c205_trap trap); /* "undefined-instruction" .. */

/* How a run ended. */
typedef struct c205_stop {
    c205_trap trap;        /* NONE: the program ended itself with EXIT */
    uint64_t pc;           /* bit address of the instruction that stopped */
    uint64_t address;      /* the operand address at fault, or 0 */
    const char *rule;      /* the one that was broken, a sentence; NULL: none */
    const c205_insn *insn; /* NULL: undefined */
    int64_t status;        /* operand R of EXIT */
} c205_stop;

typedef struct c205_account {
    const char *name; /* region; "" is all code outside regions */
    uint64_t clocks[C205_CAUSES];
    uint64_t instructions; /* all that were issued */
    uint64_t vector_instructions;
    uint64_t elements;   /* of vector results or scanned operands */
    uint64_t operations; /* floating-point ones that were done, scalar or on
                            elements */
    uint64_t entries;    /* times control came in from elsewhere */
} c205_account;

/* Of memory. */
typedef struct c205_range {
    uint64_t address, bits;
} c205_range;
enum { C205_STORES = 3 };

/* What a listener is told: one event after each instruction. */
typedef enum c205_event_kind {
    C205_EVENT_INSTRUCTION,
    C205_EVENT_REQUEST, /* EXIT with a request other than 0 */
    C205_EVENT_TRAP,
    C205_EVENT_STOP
} c205_event_kind;

/* What a piece of time was spent on: what was waited for. */
typedef enum c205_wait {
    C205_WAIT_NONE,     /* for nothing: it is the instruction's own work */
    C205_WAIT_REGISTER, /* its number: a source that was not ready, or a result
                           on its way */
    C205_WAIT_UNIT,     /* its number, of c205_unit: it was busy */
    C205_WAIT_LOADS,    /* all that were in flight, or the oldest of as many as
                           there can be */
    C205_WAIT_RESULTS,  /* all that were in flight */
    C205_WAIT_VECTOR,   /* the vector unit was busy */
    C205_WAITS
} c205_wait;

typedef struct c205_piece {
    uint64_t clocks;
    c205_cause cause;
    size_t region; /* whose account they are in */
    uint64_t pc;   /* the instruction whose work it is: a vector instruction goes
                      on while others wait */
    c205_wait wait;
    unsigned number; /* .. of what, or 0 */
} c205_piece;

/* The time of one instruction, from the clock itself.  Its pieces, in the order of time,
 * are by how much it moved the clock.  A vector instruction continues after that; its
 * phases follow each other from the clock at which it issued to the end, those of no
 * length left out. */
enum { C205_PIECES = 40, C205_PHASES = 5 };
typedef struct c205_times {
    uint64_t pc;
    uint64_t arrived;   /* the clock before it */
    uint64_t issued;    /* at which it issued */
    uint64_t ready;     /* at which its results are */
    uint64_t unit_free; /* .. its unit takes the next one: of a vector instruction,
                           one whose start-up does not overlap */
    uint64_t misses;    /* pages that the associative registers did not know .. */
    uint64_t faults;    /* .. and of them those that were not in memory */
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
    uint64_t clocks;          /* by how much it moved the clock */
    const c205_times *record; /* all about its time; of what was in flight at
                                  the end or at a trap pieces alone; NULL: there is
                                  nothing to tell */
    size_t elements;          /* vector length, 0 for scalar instructions */
    size_t recurrent;         /* those that waited for an earlier one's result */
    bool taken;               /* branches */
    /* What it changed: registers that it wrote, register r as bit r % 64 of word
     * r / 64; and ranges of memory that it stored into: with a control vector into
     * parts of them, by a list of indices into parts of the least range that has
     * all of these places. */
    uint64_t written[C205_REGISTERS / 64];
    size_t store_count;
    c205_range store[C205_STORES];
    /* C205_EVENT_REQUEST */
    unsigned request;
    c205_word r, s; /* its operands */
    c205_trap trap;
} c205_event;

typedef void c205_listener(void *context, const c205 *machine, const c205_event *event);

c205 *c205_new(const c205_model *model, c205_error *error);
void c205_free(c205 *machine);

/* Zero registers, clock, accounts; unmap all memory; map and fill the
 * program's segments; set the program counter to its entry. */
bool c205_load(c205 *machine, const c205_program *program, c205_error *error);

typedef enum c205_access {
    C205_READ_ONLY,
    C205_READ_WRITE,
    C205_WHEN_TOUCHED /* read and written; a page takes room of the host when
                         it is, and if there is none it is not mapped then */
} c205_access;
/* Map the pages that hold words words from a bit address on, zeroed where
 * they were not mapped before. */
bool c205_map(c205 *machine, uint64_t address, size_t words, c205_access access,
              c205_error *error);

/* Words that machines have in common, in any threads: a page is copied before the first
 * of them writes there, for that machine.  They must stay as long as any of these runs or is
 * looked at; to free it, or load it again, is not that. */
typedef struct c205_shared c205_shared;
/* With zeros behind them, to the end of a page.  NULL: no memory. */
c205_shared *c205_shared_new(const c205_word *words, size_t count);
void c205_shared_free(c205_shared *shared);
/* From the address of a page on; no page must be mapped there. */
bool c205_map_shared(c205 *machine, uint64_t address, const c205_shared *shared,
                     c205_error *error);

/* The first mapped page from an address on, whether it may be written, and whether a page
 * that is mapped when it is touched was; false: there is none. */
typedef struct c205_page {
    uint64_t address;
    bool writable, touched;
} c205_page;
bool c205_next_page(const c205 *machine, uint64_t from, c205_page *page);

/* All mapped pages are known to the associative registers and in real memory, as far as
 * there is room, those of the highest addresses for sure: as if the program had used
 * them before.  Costs no clocks. */
void c205_warm(c205 *machine);

/* Copy between the host and the machine's memory; costs no clocks.  Fails
 * without effect where a page is not mapped. */
bool c205_read(const c205 *machine, uint64_t address, c205_word *words, size_t count);
bool c205_write(c205 *machine, uint64_t address, const c205_word *words, size_t count);

/* Run until the program ends, a trap, or the clock has reached limit: between
 * two instructions, or in the middle of a vector instruction, whose first
 * elements are stored then and which stays the one at the program counter.
 * The next run continues there, and its results, clocks and accounts are those
 * of a run that was not stopped.  Nothing happens where the clock has reached
 * the limit already. */
c205_stop c205_run(c205 *machine, uint64_t limit);
/* One instruction (a linked pair with its prefix counts as one), or what is
 * left of the one that was interrupted; true: go on, false: *stop tells why
 * not. */
bool c205_step(c205 *machine, c205_stop *stop);
/* At most so many instructions, then the stop PAUSED; else as c205_run. */
c205_stop c205_run_steps(c205 *machine, uint64_t count, uint64_t limit);
/* "trap unmapped-address at 1000: ADDNV: address 2040: no memory is mapped
 * there" */
void c205_describe_stop(const c205 *machine, const c205_stop *stop, c205_error *text);

c205_word c205_register(const c205 *machine, unsigned number);
void c205_set_register(c205 *machine, unsigned number, c205_word word);
uint64_t c205_pc(const c205 *machine);
/* Gives up a vector instruction that was interrupted: what it stored stays,
 * its other results are lost, and its clocks so far are charged. */
void c205_set_pc(c205 *machine, uint64_t address);
c205_word c205_data_flags(const c205 *machine);

/* Clocks charged so far: the sum of all accounts.  When a run has ended, by
 * itself or by a trap, everything in flight is included.  At the clock limit
 * it is not; in the middle of a vector instruction the clock is the limit, and
 * the clocks of that instruction up to there are in the accounts (it is
 * counted when it is done).
 *
 * After a trap or at the limit a run may continue as if it had not been stopped:
 * from the clock at which the instruction at the program counter issues.  So
 * where a page was missing and has been mapped, the end is as if it had been
 * there from the beginning. */
uint64_t c205_clock(const c205 *machine);
const c205_model *c205_machine_model(const c205 *machine);
size_t c205_account_count(const c205 *machine);
const c205_account *c205_account_at(const c205 *machine, size_t i);
/* Set clock and accounts to zero, the machine's pipes empty; memory,
 * registers, which pages are resident and what is left on the job interval
 * timer, counted from the clock shown, stay.  An instruction that was
 * interrupted stays so, and is charged as a whole when it is done. */
void c205_reset_clock(c205 *machine);

/* At most C205_LISTENERS; false when there are more. */
enum { C205_LISTENERS = 8 };
bool c205_listen(c205 *machine, c205_listener *listener, void *context);

/* ---- Stops (vm/breakpoints.c) ---------------------------------------------------
 *
 * They end a run behind an instruction, with a trap of their own, of which listeners hear
 * as of others, and the next run continues there as if nothing had been.  A load leaves
 * them as they are, a machine that is saved leaves them out.
 */

/* For a listener: behind the instruction that it is being told of, the stop PAUSED. */
void c205_pause(c205 *machine);
/* The stop BREAKPOINT before the instruction at an address, unless the run begins there.
 * False: no memory. */
bool c205_break(c205 *machine, uint64_t address, bool set);
/* The stop WATCHPOINT behind an instruction that has changed one of so many words; what
 * the host writes between two runs is no change, but within a vector instruction that a
 * limit has interrupted it is.  False: no memory, or nothing is mapped
 * there. */
bool c205_watch(c205 *machine, uint64_t address, size_t words, bool set);

/* ---- The time of other machines (vm/time/projection.c) --------------------
 *
 * A listener that charges each scalar instruction of a program that time which
 * another machine would take for the same operation.
 */
typedef struct c205_projection c205_projection;

/* The model must be a projection. */
c205_projection *c205_projection_new(const c205_model *model, c205_error *error);
void c205_projection_free(c205_projection *projection);
/* The listener; its context is the projection. */
c205_listener c205_project;
/* Clocks of that machine for a region, as numbered in the accounts. */
uint64_t c205_projected_clocks(const c205_projection *projection, size_t region);
/* False: there were vector instructions, or memory ran out. */
bool c205_projection_holds(const c205_projection *projection, c205_error *error);

/* ---- What if (vm/time/recording.c) ---------------------------------
 *
 * A listener that keeps of a run what time is made from, and tells the time of
 * the same run with other constants, by the machine's own clock or by a
 * projection.  That is exact as long as the program does not read the clock.
 */
typedef struct c205_recording c205_recording;
c205_recording *c205_recording_new(c205_error *error);
void c205_recording_free(c205_recording *recording);
/* The listener; its context is the recording, of one run from its beginning. */
c205_listener c205_record;

/* The clocks of each region, as numbered in the accounts: of so many regions,
 * 0 in those that did not run.  With these constants in place of the model's;
 * time advances in ticks, of which a clock has so many (1: as the machine).
 * By a projection: NaN in regions that have vector instructions. */
bool c205_retime(const c205_recording *recording, const c205_model *model,
                 const c205_setting *settings, size_t count, unsigned ticks,
                 double *clocks, size_t regions, c205_error *error);

/* ---- Saving and restoring (vm/save.c) ------------------------------------
 *
 * A machine that is not running (not in a listener) as a list of bytes:
 * format version, model, program, registers, memory, the clock with all that
 * is in flight, and how far an interrupted vector instruction came.  A
 * restored machine continues as the saved one would have: same results, same
 * clocks, same accounts.  Listeners are not saved.
 */

/* Take the next bytes; false: it cannot, which ends the saving. */
typedef bool c205_writer(void *context, const void *bytes, size_t count);

bool c205_save(const c205 *machine, c205_writer *write, void *context,
               c205_error *error);
/* A new machine from what was saved on a model with the same constants.  NULL:
 * the bytes are damaged, not a saved machine, of another version or model. */
c205 *c205_restore(const void *bytes, size_t count, const c205_model *model,
                   c205_error *error);

/* ---- Going back (vm/history.c) --------------------------------------------
 *
 * A machine with its past: it goes forward an instruction at a time, and back to any
 * step, by snapshots and running again from the one before.  State, clock and accounts
 * are those of a run that came there for the first time.
 */
typedef struct c205_history c205_history;

/* The machine as it is is step 0; it is the history's from then on.  Snapshots
 * take so many bytes at most, but two are always kept, and those that c205_history_changed
 * made: with fewer of them it is farther to go.  NULL: no memory, and the machine remains the caller's. */
c205_history *c205_history_new(c205 *machine, size_t budget, c205_error *error);
void c205_history_free(c205_history *history);
/* The machine at this step: after a way back it is another one, with the same
 * listeners. */
c205 *c205_history_machine(const c205_history *history);
/* Instructions since step 0: now, and the most that there were. */
uint64_t c205_history_step(const c205_history *history);
uint64_t c205_history_known(const c205_history *history);
/* One instruction, as c205_step does it; where the program has ended the same stop
 * again. */
bool c205_history_forward(c205_history *history, c205_stop *stop);
/* To a step before this one; of what is run again for that, listeners hear of the last
 * instruction alone.  False: no memory; the machine stays where it is. */
bool c205_history_back(c205_history *history, uint64_t step, c205_error *error);
/* Somebody has written registers or memory: from here on the run is another one.
 * False: no memory; the way back is that of before. */
bool c205_history_changed(c205_history *history, c205_error *error);

/* Tells programs apart: entry, segments and regions all count. */
uint64_t c205_program_hash(const c205_program *program);
/* That of the program last loaded; 0: none. */
uint64_t c205_loaded_program(const c205 *machine);

#ifdef __cplusplus
}
#endif
#endif
