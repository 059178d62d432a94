/* c205_machine.h - programs, the machine that runs them, its events and breakpoints. */
#ifndef C205_API_MACHINE_H
#define C205_API_MACHINE_H

#include "c205_model.h"

/* ---- Programs ----------------------------------------------------------- */

typedef struct c205_segment {
    uint64_t address;       /* bit address, a multiple of 64 */
    size_t length;          /* number of words */
    const c205_word *words; /* NULL: zeros, mapped as C205_WHEN_TOUCHED */
} c205_segment;

/* The code between two addresses belongs to a named region of the accounts. Ranges with
 * the same name share one account. */
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
    bool warm; /* the run starts as after c205_warm */
} c205_program;

/* Returns a hash of entry, segments and regions that identifies a program. */
uint64_t c205_program_hash(const c205_program *program);

/* ---- The machine (vm/machine.c) ----------------------------------------- */

typedef struct c205 c205;

enum { C205_REGISTERS = 256 };
#define C205_NO_LIMIT UINT64_MAX
#define C205_PAGE_WORDS 65536u /* size of a large page (primary source) */
#define C205_MAX_LENGTH 65535u /* elements of a vector (primary source) */

/* Returns a new machine, or NULL with the error if the model is a projection or the
 * host is out of memory. The model must outlive the machine. */
c205 *c205_new(const c205_model *model, c205_error *error);
void c205_free(c205 *machine);
const c205_model *c205_machine_model(const c205 *machine);

/* Zeroes registers, clock and accounts, unmaps all memory, maps and fills the segments
 * of the program, and sets the program counter to its entry. */
bool c205_load(c205 *machine, const c205_program *program, c205_error *error);
/* Returns the hash of the last loaded program, or 0. */
uint64_t c205_loaded_program(const c205 *machine);

/* ---- Memory (vm/inspect.c, shared.c) ------------------------------------- */

typedef enum c205_access {
    C205_READ_ONLY,
    C205_READ_WRITE,
    C205_WHEN_TOUCHED /* may be read and written; the host allocates a page on first
                         use, and the page counts as unmapped if the allocation fails */
} c205_access;
/* Maps the pages of a range of words that starts at a bit address. Pages that were not
 * mapped before are zeroed. */
bool c205_map(c205 *machine, uint64_t address, size_t words, c205_access access,
              c205_error *error);

/* Pages of words that several machines share, also in different threads. A machine that
 * writes to a shared page gets its own copy of the page first. The pages must exist
 * while any of these machines runs or is inspected. A machine may be freed or load
 * another program after the pages are freed. */
typedef struct c205_shared c205_shared;
/* Copies the words to new shared pages, and fills the last page with zeros. NULL: out
 * of memory. */
c205_shared *c205_shared_new(const c205_word *words, size_t count);
void c205_shared_free(c205_shared *shared);
/* Maps the words at consecutive addresses from the start of a page on. No page may be
 * mapped there. */
bool c205_map_shared(c205 *machine, uint64_t address, const c205_shared *shared,
                     c205_error *error);

/* A mapped page. writable: the program may write to the page. touched: a
 * C205_WHEN_TOUCHED page has been used. c205_next_page finds the first mapped page at
 * or after an address, and returns false if there is none. */
typedef struct c205_page {
    uint64_t address;
    bool writable, touched;
} c205_page;
bool c205_next_page(const c205 *machine, uint64_t from, c205_page *page);

/* Makes mapped pages resident in real memory and in the associative registers, as if
 * the program had used them before. The highest addresses come first if there is no
 * room for all pages. Takes no clocks. */
void c205_warm(c205 *machine);

/* Copy words between the host and the machine's memory, without clocks. Return false,
 * without effect, if a page of the range is not mapped. */
bool c205_read(const c205 *machine, uint64_t address, c205_word *words, size_t count);
bool c205_write(c205 *machine, uint64_t address, const c205_word *words, size_t count);

/* ---- Runs (vm/machine.c, stop_text.c) ------------------------------------ */

typedef enum c205_trap {
    C205_TRAP_NONE,
    C205_TRAP_UNDEFINED_INSTRUCTION, /* no such opcode or G bits */
    C205_TRAP_UNMAPPED_ADDRESS,
    C205_TRAP_PROTECTED_ADDRESS,  /* write to read-only memory */
    C205_TRAP_BAD_DESCRIPTOR,     /* negative offset, missing vector and similar
                                     errors */
    C205_TRAP_MISALIGNED_OPERAND, /* a word vector that does not start at a word, and
                                     similar errors */
    C205_TRAP_BAD_LINK,           /* the pair after LINKV cannot be linked */
    C205_TRAP_BAD_REQUEST,        /* no such monitor request */
    C205_TRAP_CLOCK_LIMIT,
    C205_TRAP_NO_MEMORY, /* the host is out of memory */
    C205_TRAP_PAUSED,    /* c205_pause, or the maximum number of instructions */
    C205_TRAP_BREAKPOINT,
    C205_TRAP_WATCHPOINT, /* address: the first watched word */
    C205_TRAPS
} c205_trap;
const char *c205_trap_name(c205_trap trap); /* for example "undefined-instruction" */

/* The reason for which a run stopped, and the place. */
typedef struct c205_stop {
    c205_trap trap;        /* NONE: the program executed EXIT */
    uint64_t pc;           /* bit address of the instruction that stopped */
    uint64_t address;      /* the operand address of a trap, or 0 */
    const char *rule;      /* the rule that was broken, as a sentence, or NULL */
    const c205_insn *insn; /* NULL: undefined */
    int64_t status;        /* operand R of EXIT */
} c205_stop;

/* Runs until the program ends, a trap occurs, or the clock has reached limit. Returns
 * the reason of the stop. The limit may stop the run within a vector instruction. The
 * first elements of the instruction are then stored, and the program counter remains at
 * the instruction. The next run continues there. A stop does not change the results,
 * clocks and accounts. Nothing happens if the clock has already reached the limit. */
c205_stop c205_run(c205 *machine, uint64_t limit);
/* Executes one instruction, or the rest of an interrupted instruction. A linked pair
 * and its prefix count as one instruction. Returns true if the program continues;
 * otherwise *stop states the reason. */
bool c205_step(c205 *machine, c205_stop *stop);
/* Like c205_run, but also stops, with PAUSED, when `count` instructions have been
 * executed. */
c205_stop c205_run_steps(c205 *machine, uint64_t count, uint64_t limit);
/* Writes a text such as "trap unmapped-address at 1000: ADDNV: address 2040: no memory
 * is mapped there". */
void c205_describe_stop(const c205 *machine, const c205_stop *stop, c205_error *text);

/* ---- Registers (vm/inspect.c) -------------------------------------------- */

/* Return and set a register. Register 0 and numbers above 255 read as zero. Setting
 * these has no effect. */
c205_word c205_register(const c205 *machine, unsigned number);
void c205_set_register(c205 *machine, unsigned number, c205_word word);
uint64_t c205_pc(const c205 *machine);
/* Sets the program counter and abandons an interrupted vector instruction. Its stored
 * elements remain, its other results are lost, and the elapsed clocks are charged. */
void c205_set_pc(c205 *machine, uint64_t address);
c205_word c205_data_flags(const c205 *machine);

/* ---- Events (vm/events.c) ------------------------------------------------ */

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

typedef struct c205_times c205_times; /* c205_time.h */

typedef struct c205_event {
    c205_event_kind kind;
    uint64_t pc;
    const c205_insn *insn;
    c205_fields fields;
    size_t region;            /* index of the region in the accounts */
    uint64_t issued;          /* the clock at which the instruction issued */
    uint64_t clocks;          /* increase of the clock */
    const c205_times *record; /* times of the instruction; after an end or a trap, only
                                 the wait for everything in flight; NULL: not
                                 recorded */
    size_t elements;          /* vector length, 0 for scalar instructions */
    size_t recurrent;         /* elements that waited for the result of an earlier
                                 element */
    bool taken;               /* a branch was taken */
    /* Bit r % 64 of written[r / 64] is set if the instruction wrote register r. store
     * lists the ranges of memory that it stored into. A control vector may select only
     * parts of a range. A list of indices has the smallest range that contains all of
     * its elements. */
    uint64_t written[C205_REGISTERS / 64];
    size_t store_count;
    c205_range store[C205_STORES];
    /* For C205_EVENT_REQUEST: */
    unsigned request;
    c205_word r, s; /* operands of the request */
    c205_trap trap;
} c205_event;

typedef void c205_listener(void *context, const c205 *machine, const c205_event *event);

/* The largest number of listeners. c205_listen adds a listener, or returns false if
 * there are as many already. */
enum { C205_LISTENERS = 8 };
bool c205_listen(c205 *machine, c205_listener *listener, void *context);

/* ---- Breakpoints and watchpoints (vm/breakpoints.c) ------------------------------
 *
 * Breakpoints and watchpoints end a run between two instructions, each with its own
 * trap. Listeners are notified of this end. The next run continues as if the run had
 * not been stopped. They remain when a program is loaded, and are not saved with a
 * machine.
 */

/* Stops the run with PAUSED after the current instruction. A listener calls this. */
void c205_pause(c205 *machine);
/* Stops a run with BREAKPOINT before the instruction at an address, unless the run
 * begins there. set: true adds the breakpoint, false removes it. Returns false if the
 * host is out of memory. */
bool c205_break(c205 *machine, uint64_t address, bool set);
/* Stops a run with WATCHPOINT after an instruction that changed one of the `words`
 * words at this address. Writes by the host between two runs count only while a vector
 * instruction is interrupted. set: true adds the words, false removes them. Returns
 * false if the host is out of memory or the address is not mapped. */
bool c205_watch(c205 *machine, uint64_t address, size_t words, bool set);

#endif
