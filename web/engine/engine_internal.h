/* engine_internal.h - the internals of an engine. Not public.
 *
 * A request is a function that reads the members of the request and writes the members
 * of its reply. On failure it sets the error and returns false, as all functions with a
 * c205_error do, and the incomplete reply is discarded. A long request sets `goes_on`
 * to the function of its next slice, which the request `more` calls.
 */
#ifndef WEB_ENGINE_ENGINE_INTERNAL_H
#define WEB_ENGINE_ENGINE_INTERNAL_H

#include "asm/check/runtime_check.h"
#include "asm/debug/debugger_state.h"
#include "asm/debug/execution_control.h"
#include "asm/measure/line_profile.h"
#include "asm/text/assemble.h"
#include "asm/timeline/timeline.h"
#include "base/json.h"
#include "base/json_read.h"
#include "base/table.h"
#include "vm/error.h"
#include "web/engine/cause_shares.h"
#include "web/engine/engine.h"

/* ---- A slice of work ------------------------------------------------------- */

/* A slice ends after a number of milliseconds of the host or of clocks of the
 * machine. */
struct slice {
    double begun, ms;  /* ms < 0: no limit */
    uint64_t clocks;   /* maximum clocks; 0: no limit */
    uint64_t from;     /* the clock at the start of the slice */
    uint64_t spent;    /* clocks of the machine, or runs of a sweep, in work that does
                          not execute the program */
    uint64_t ends_at;  /* the clock at which the execution ends */
    bool to_the_limit; /* ends_at was reached */
};

/* ---- Output of a program ---------------------------------------------------- */

enum { MAX_PRINTED = 1 << 20 }; /* maximum number of stored bytes */

/* The length of the output after a step. */
struct printed_mark {
    uint64_t step;
    size_t length;
};

struct printed {
    struct text_buffer text;
    size_t count;
    struct printed_mark *marks;
    bool cut; /* output after the last mark was dropped */
};

/* ---- Warnings of a run ------------------------------------------------------ */

/* The runtime checks of a program. Each step is checked the first time that it is
 * executed. */
struct run_checks {
    struct runtime_checker *checker; /* NULL: out of memory */
    uint64_t checked;                /* number of checked steps */
    size_t count;
    uint64_t *steps; /* the number of checked steps when each warning was found */
};

/* ---- An execution -------------------------------------------------------- */

struct execution {
    enum execution_end (*move)(struct engine *engine);
    uint64_t step, clock; /* target */
    uint64_t left;        /* remaining steps */
    bool inside;          /* within a call, which returns to `behind` */
    uint64_t behind;
    struct back_search search;
};

/* ---- A replay for listeners ---------------------------------------------- */

/* A run from the start to a step, followed by a return to the current step. */
struct replay {
    bool begun;
    struct line_profile *profile;     /* NULL: not requested */
    struct timeline *timeline;        /* NULL: not requested */
    struct cause_shares *shares;      /* NULL: not requested */
    uint64_t stands, end;             /* the step to return to, and the last step of the
                                         replay */
    bool halted;                      /* the program cannot continue from the current
                                         step */
    bool in_order;                    /* sort the profile by line */
    const struct timeline_form *form; /* format of the timeline as a file; NULL:
                                         spans */
};

/* ---- An engine ----------------------------------------------------------- */

typedef bool engine_request(struct engine *engine, const struct json_value *request,
                            struct json *reply, c205_error *error);
/* Executes the next slice. Clears goes_on after the last slice. */
typedef bool engine_slice(struct engine *engine, struct json *reply, c205_error *error);

struct engine {
    char *name; /* name of the program; NULL: none */
    struct object *object;
    c205_model *model;
    struct debugger *debugger;
    uint64_t bound; /* maximum clocks of an execution or a run */
    struct run_checks checks;
    struct printed printed;
    struct text_buffer said;        /* reports of the debugger that no reply contains
                                       yet */
    struct diagnostics diagnostics; /* diagnostics of the text in this request */
    struct slice slice;
    engine_slice *goes_on; /* NULL: no unfinished work */
    struct execution execution;
    struct replay replay;
    struct timeline timeline;
    struct laboratory *laboratory;      /* the current sweep, or NULL */
    struct text_comparison *comparison; /* the current comparison, or NULL */
};

engine_request answer_about, answer_load, answer_breaks, answer_go, answer_view,
    answer_results, answer_timeline, answer_profile, answer_accounts, answer_command,
    answer_sweep, answer_compare, answer_grade;

/* Writes the list of lessons for the request `about`. */
bool put_lessons(struct json *reply, c205_error *error);

void sweep_drop(struct engine *engine);
void compare_drop(struct engine *engine);

/* ---- Members of a request (answer.c) ------------------------------------- */

/* Reads a text. Returns false if it is missing or not a text. */
bool take_text(const struct json_value *request, const char *key, const char **text,
               c205_error *error);
/* Reads an optional text. Returns false if it is not a text. */
bool take_text_or(const struct json_value *request, const char *key, const char **text,
                  c205_error *error);
/* Reads true or false. *truth is unchanged if the member is missing. */
bool take_truth(const struct json_value *request, const char *key, bool *truth,
                c205_error *error);
/* Reads an integer >= 0. *count is unchanged if the member is missing. */
bool take_count(const struct json_value *request, const char *key, uint64_t *count,
                c205_error *error);
/* Reads the optional "limit" in clocks. The result is at most the bound of the
 * engine. */
bool take_limit(const struct engine *engine, const struct json_value *request,
                uint64_t *limit, c205_error *error);
/* Reads "ms" and "clocks", the limits of a slice, and starts the slice. */
bool take_slice(struct engine *engine, const struct json_value *request,
                c205_error *error);
/* For debugger_setup.interrupted: returns true if the slice is over. */
bool slice_is_over(void *engine);
/* Like slice_is_over, for work that counts its clocks in slice.spent. */
bool slice_is_full(const struct engine *engine);

/* Prefixes the error with a name and returns false. */
bool refuse_of(c205_error *error, const char *name);
/* Sets the error to the debugger's report and returns false. */
bool refuse_with_report(struct engine *engine, c205_error *error);
/* Writes the debugger's report as a member and clears it. */
bool put_said(struct engine *engine, struct json *reply, const char *key,
              c205_error *error);
/* Writes a text as a member and frees it. Returns false if the text is incomplete. */
bool put_buffer(struct json *reply, const char *key, struct text_buffer *text,
                c205_error *error);
/* Writes begin, end and cause of charged clocks as an element of an array. */
void put_clocks(struct json *reply, uint64_t begin, uint64_t end, c205_cause cause);
/* Returns a copy, or NULL if memory is exhausted. */
char *copy_of(const char *text);

/* ---- Programs (program.c) ------------------------------------------------ */

void program_drop(struct engine *engine);
/* put_diagnostics writes a list of diagnostics, put_diagnostic one element of it. */
void put_diagnostics(const struct diagnostics *diagnostics, struct json *reply);
void put_diagnostic(const struct diagnostic *diagnostic, struct json *reply);
/* Reads "defines" and "files" of a request into an arena. */
bool take_options(const struct json_value *request, struct arena *arena,
                  struct asm_options *options, c205_error *error);
/* Reads the optional "warm". */
bool take_warm(const struct json_value *request, struct object *object,
               c205_error *error);
/* Checks that each defined name is used by at least one of the programs. */
bool uses_defines(const struct asm_options *options, struct object *const *objects,
                  size_t count, c205_error *error);
/* Assembles a text. Returns NULL if it has errors, which are then in the diagnostics of
 * the engine. */
struct object *engine_assemble(struct engine *engine, const char *name,
                               const char *text, const struct asm_options *options,
                               c205_error *error);
/* Returns the named model. Without a name, returns the model of the program's
 * expect-model or the default model. Returns NULL with the error if there is no such
 * model. */
c205_model *program_model(const char *name, const struct object *object,
                          c205_error *error);
/* Returns the line of an instruction in the program's text. An instruction of a macro
 * has the line of the call. Returns 0 if the line is unknown. */
size_t program_line(const struct engine *engine, uint64_t address);

/* Drops the output after a step, because it belongs to another run. */
void printed_forget(struct printed *printed, uint64_t step);
/* Returns the length of the output up to a step. */
size_t printed_until(const struct printed *printed, uint64_t step);
/* Returns true if output up to a step was dropped. */
bool printed_is_cut(const struct printed *printed, uint64_t step);

/* ---- Warnings of a run (warnings.c) ---------------------------------------- */

/* Starts the runtime checks of a program at its start. Returns false if memory is
 * exhausted. */
bool warnings_begin(struct engine *engine, c205_error *error);
void warnings_drop(struct engine *engine);
c205_listener warnings_listen;
/* Writes the diagnostics of the run up to the current step: its warnings, and the trap
 * that ended it. */
bool put_warnings(const struct engine *engine, struct json *reply, c205_error *error);

/* ---- Views (view.c, registers.c, instruction.c) -------------------------- */

const c205 *engine_machine(const struct engine *engine);
void put_hex(struct json *json, const char *key, c205_word word);
void put_number(struct json *json, const char *key, c205_word word, bool half);
void put_registers(const struct engine *engine, bool all, struct json *reply);
bool put_vectors(const struct engine *engine, const struct json_value *request,
                 struct json *reply, c205_error *error);
void put_next_insn(const struct engine *engine, struct json *reply);
bool put_last_insn(const struct engine *engine, struct json *reply, c205_error *error);
bool put_accounts(const struct engine *engine, struct json *reply, c205_error *error);

/* Writes a table and frees it. */
bool put_table(struct table *table, const char *key, struct json *reply,
               c205_error *error);

/* ---- Replays (replay.c) -------------------------------------------------- */

/* The listener of the machine. It calls the listeners of the current replay. */
c205_listener replay_listen;
/* Starts a replay up to the step `end`, which must be known. The replay then owns the
 * listeners, of which one may be NULL. Returns false if both are NULL, which means that
 * memory is exhausted. */
bool replay_begin(struct engine *engine, struct line_profile *profile,
                  struct timeline *timeline, uint64_t end, c205_error *error);
/* Continues the replay until the end of the slice. If the replay is then complete,
 * calls `put`. Otherwise makes `again` the function of the next slice. */
bool replay_slice(struct engine *engine, struct json *reply, engine_slice *again,
                  engine_slice *put, c205_error *error);
/* Ends a replay, frees its listeners, and returns to the step before the replay. */
void replay_drop(struct engine *engine);

#endif
