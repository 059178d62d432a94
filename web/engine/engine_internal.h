/* engine_internal.h - the internals of an engine. Not public.
 *
 * A request is a function that reads its members and writes those of its reply. If
 * it fails it sets the error, and the reply written so far is discarded. A request
 * that takes long sets `goes_on` to the function of its next slice, which the
 * request `more` calls.
 */
#ifndef WEB_ENGINE_ENGINE_INTERNAL_H
#define WEB_ENGINE_ENGINE_INTERNAL_H

#include "asm/debug/debugger_state.h"
#include "asm/debug/execution_control.h"
#include "asm/measure/line_profile.h"
#include "asm/text/assemble.h"
#include "asm/timeline/timeline.h"
#include "base/json.h"
#include "base/json_read.h"
#include "base/table.h"
#include "vm/error.h"
#include "web/engine/engine.h"

/* ---- A slice of work ------------------------------------------------------- */

/* A slice ends after a number of milliseconds of the host, or of
 * clocks of the machine. */
struct slice {
    double begun, ms;  /* ms below 0: no limit */
    uint64_t clocks;   /* 0: no limit */
    uint64_t from;     /* the clock at its start */
    uint64_t spent;    /* by work other than the program's: clocks, or points */
    uint64_t ends_at;  /* the clock at which the whole execution ends */
    bool to_the_limit; /* ends_at was reached */
};

/* ---- What a program has printed ---------------------------------------------- */

enum { MAX_PRINTED = 1 << 20 }; /* bytes stored at most */

/* The length of the output after a step. */
struct printed_mark {
    uint64_t step;
    size_t length;
};

struct printed {
    struct text_buffer text;
    size_t count;
    struct printed_mark *marks;
    bool cut; /* output was dropped, at or after the last mark */
};

/* ---- An execution -------------------------------------------------------- */

struct execution {
    enum execution_end (*move)(struct engine *engine);
    uint64_t step, clock; /* the target */
    uint64_t left;        /* steps that remain */
    bool inside;          /* inside a call, which returns to `behind` */
    uint64_t behind;
    struct back_search search;
};

/* ---- A replay for listeners ---------------------------------------------- */

/* A run from the start to a step, and back to the current step. */
struct replay {
    bool begun;
    struct line_profile *profile;     /* NULL: not requested */
    struct timeline *timeline;        /* NULL: not requested */
    uint64_t stands, end;             /* steps: to return to, and the last to replay */
    bool halted;                      /* the program cannot continue
                                       * from the current step */
    bool in_order;                    /* order of the profile's lines */
    const struct timeline_form *form; /* of a timeline as a file; NULL: as spans */
};

/* ---- An engine ----------------------------------------------------------- */

typedef bool engine_request(struct engine *engine, const struct json_value *request,
                            struct json *reply, c205_error *error);
/* Executes the next slice, and clears goes_on after the last. */
typedef bool engine_slice(struct engine *engine, struct json *reply, c205_error *error);

struct engine {
    char *name; /* of the program; NULL: none is loaded */
    struct object *object;
    c205_model *model;
    struct debugger *debugger;
    uint64_t bound; /* most clocks of an execution or a run */
    struct printed printed;
    struct text_buffer said;        /* reports of the debugger, not yet in a reply */
    struct diagnostics diagnostics; /* of the text of this request */
    struct slice slice;
    engine_slice *goes_on; /* NULL: no unfinished work */
    struct execution execution;
    struct replay replay;
    struct timeline timeline;
    struct laboratory *laboratory;      /* the current sweep, or NULL */
    struct text_comparison *comparison; /* the current comparison, or NULL */
};

engine_request answer_about, answer_load, answer_breaks, answer_go, answer_view,
    answer_timeline, answer_profile, answer_accounts, answer_printf, answer_sweep,
    answer_compare, answer_grade;

/* Writes the lessons of the request about. */
bool put_lessons(struct json *reply, c205_error *error);

void sweep_drop(struct engine *engine);
void compare_drop(struct engine *engine);

/* ---- Members of a request (answer.c) ------------------------------------- */

/* Reads a text. Fails if it is missing, or not a text. */
bool take_text(const struct json_value *request, const char *key, const char **text,
               c205_error *error);
/* Reads an optional text. Fails if it is not a text. */
bool take_text_or(const struct json_value *request, const char *key, const char **text,
                  c205_error *error);
/* Reads true or false; if it is missing, *truth is unchanged. */
bool take_truth(const struct json_value *request, const char *key, bool *truth,
                c205_error *error);
/* Reads an integer of at least 0; if it is missing, *count is unchanged. */
bool take_count(const struct json_value *request, const char *key, uint64_t *count,
                c205_error *error);
/* Reads the optional "limit" in clocks, and reduces it to the engine's bound. */
bool take_limit(const struct engine *engine, const struct json_value *request,
                uint64_t *limit, c205_error *error);
/* Reads "ms" and "clocks", and starts a slice. */
bool take_slice(struct engine *engine, const struct json_value *request,
                c205_error *error);
/* The debugger's `interrupted`: returns whether the slice is over. */
bool slice_is_over(void *engine);
/* Returns whether the slice is over, for other work, by its `spent`. */
bool slice_is_full(const struct engine *engine);

/* Prefixes the error with a name and returns false. */
bool refuse_of(c205_error *error, const char *name);
/* Sets the error to the debugger's report, without "error: ", and returns false. */
bool refuse_is_clip(struct engine *engine, c205_error *error);
/* Writes the debugger's report as a member, and clears it. */
bool put_said(struct engine *engine, struct json *reply, const char *key,
              c205_error *error);
/* Writes a text as a member and frees it. Fails if the text is incomplete. */
bool put_buffer(struct json *reply, const char *key, struct text_buffer *text,
                c205_error *error);
/* Writes the begin, the end and the cause of clocks as an element of an array. */
void put_clocks(struct json *reply, uint64_t begin, uint64_t end, c205_cause cause);
/* Returns NULL if memory is exhausted. */
char *copy_of(const char *text);

/* ---- Programs (program.c) ------------------------------------------------ */

void program_drop(struct engine *engine);
void put_diagnostics(const struct diagnostics *diagnostics, struct json *reply);
/* Reads "defines" and "files" of a request into an arena. */
bool take_options(const struct json_value *request, struct arena *arena,
                  struct asm_options *options, c205_error *error);
/* Reads the optional "warm". */
bool take_warm(const struct json_value *request, struct object *object,
               c205_error *error);
/* Checks that at least one of the programs uses each defined name. */
bool uses_defines(const struct asm_options *options, struct object *const *objects,
                  size_t count, c205_error *error);
/* Returns NULL if the text cannot be assembled; the engine's
 * diagnostics have the reason. */
struct object *engine_assemble(struct engine *engine, const char *name,
                               const char *text, const struct asm_options *options,
                               c205_error *error);
/* Returns the named model, or that of the program's expect-model, or the default one.
 * Returns NULL and the error if there is none. */
c205_model *program_model(const char *name, const struct object *object,
                          c205_error *error);
/* Returns the line of the program's own text; for an instruction of a macro, that of
 * the call. Returns 0 if none is known. */
size_t program_line(const struct engine *engine, uint64_t address);

/* Drops the output after a step, since it belongs to another run. */
void printed_forget(struct printed *printed, uint64_t step);
/* Returns the length of the output up to a step. */
size_t printed_until(const struct printed *printed, uint64_t step);
/* Returns whether output up to a step was dropped. */
bool printed_is_cut(const struct printed *printed, uint64_t step);

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

/* The listener of the program's machine. It calls the listeners
 * of the current replay. */
c205_listener replay_listen;
/* Starts a replay up to the step `end`, which must be known. The replay owns its
 * listeners from here on. Fails if both are NULL, since memory is then exhausted. */
bool replay_begin(struct engine *engine, struct line_profile *profile,
                  struct timeline *timeline, uint64_t end, c205_error *error);
/* Replays until the end of the slice. After the last slice it calls `put`; otherwise
 * `again` is the next slice. */
bool replay_slice(struct engine *engine, struct json *reply, engine_slice *again,
                  engine_slice *put, c205_error *error);
/* Ends a replay, frees its listeners, and goes back to the step before it. */
void replay_drop(struct engine *engine);

#endif
