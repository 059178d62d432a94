/* engine_internal.h - the inside of an engine.  Not public.
 *
 * A request is a function that reads its members and writes those of its reply.  One that
 * cannot do its work tells why in the error, and what it has written is dropped.  One
 * that takes long leaves in `goes_on` what does the next slice, which `more` asks for.
 */
#ifndef WEB_ENGINE_ENGINE_INTERNAL_H
#define WEB_ENGINE_ENGINE_INTERNAL_H

#include "asm/assemble.h"
#include "asm/debug/execution_control.h"
#include "asm/debug/debugger_state.h"
#include "asm/line_profile.h"
#include "asm/timeline/timeline.h"
#include "base/json.h"
#include "base/json_read.h"
#include "base/table.h"
#include "web/engine/engine.h"

/* ---- A slice of work ------------------------------------------------------- */

/* It is over when so many milliseconds of the host have passed, or so many clocks of the
 * machine. */
struct slice {
    double begun, ms;  /* ms below 0: as long as it takes */
    uint64_t clocks;   /* 0: as many as it takes */
    uint64_t from;     /* the clock at which it began */
    uint64_t spent;    /* by other work than the program's: clocks, or points */
    uint64_t ends_at;  /* this one ends the whole movement */
    bool to_the_limit; /* it has */
};

/* ---- What a program has printed ---------------------------------------------- */

enum { MAX_PRINTED = 1 << 20 }; /* bytes that are kept */

/* So many bytes had been printed behind a step. */
struct printed_mark {
    uint64_t step;
    size_t length;
};

struct printed {
    struct text_buffer text;
    size_t count;
    struct printed_mark *marks;
    bool cut; /* there was more, at the last mark or behind it */
};

/* ---- A movement ----------------------------------------------------------------- */

struct movement {
    enum execution_end (*move)(struct engine *engine);
    uint64_t step, clock; /* where it is to go */
    uint64_t left;        /* so many are still to come */
    bool inside;          /* a call, which comes back to: */
    uint64_t behind;
    struct back_search search;
};

/* ---- A run again, for who listens ------------------------------------------------- */

/* From the beginning to the end, and back to where the program stands. */
struct replay {
    bool begun;
    struct line_profile *profile;     /* NULL: it does not listen */
    struct timeline *timeline;        /* likewise */
    uint64_t stands, end;             /* steps */
    bool halted;                      /* it is where it cannot go on */
    bool in_order;                    /* the lines of the profile */
    const struct timeline_form *form; /* of the timeline as a file */
};

/* ---- An engine ------------------------------------------------------------------------ */

typedef bool engine_request(struct engine *engine, const struct json_value *request,
                            struct json *reply, c205_error *error);
/* The next slice; it clears goes_on when all is done. */
typedef bool engine_slice(struct engine *engine, struct json *reply, c205_error *error);

struct engine {
    char *name; /* of the program; NULL: there is none */
    struct object *object;
    c205_model *model;
    struct debugger *debugger;
    uint64_t bound; /* clocks of a movement or a run, at most */
    struct printed printed;
    struct text_buffer said;        /* by the debugger, and not told yet */
    struct diagnostics diagnostics; /* of the text of this request */
    struct slice slice;
    engine_slice *goes_on; /* NULL: nothing is left to be done */
    struct movement movement;
    struct replay replay;
    struct timeline timeline;
    struct laboratory *laboratory;      /* a sweep that is at work, or NULL */
    struct text_comparison *comparison; /* likewise */
};

engine_request answer_about, answer_load, answer_breaks, answer_go, answer_view,
    answer_timeline, answer_profile, answer_accounts, answer_printf, answer_sweep,
    answer_compare, answer_grade;

/* Of about. */
bool put_lessons(struct json *reply, c205_error *error);

void sweep_drop(struct engine *engine);
void compare_drop(struct engine *engine);

/* ---- Members of a request (answer.c) --------------------------------------------------- */

/* False after telling: it is missing, or no text. */
bool take_text(const struct json_value *request, const char *key, const char **text,
               c205_error *error);
/* One that may be missing, and is no text of another kind then. */
bool take_text_or(const struct json_value *request, const char *key, const char **text,
                  c205_error *error);
/* true or false; missing: it stays. */
bool take_truth(const struct json_value *request, const char *key, bool *truth,
                c205_error *error);
/* An integer from 0 on; missing: it stays. */
bool take_count(const struct json_value *request, const char *key, uint64_t *count,
                c205_error *error);
/* "limit" of a request, unless it is missing: clocks, not beyond the engine's bound. */
bool take_limit(const struct engine *engine, const struct json_value *request,
                uint64_t *limit, c205_error *error);
/* "ms" and "clocks". */
bool take_slice(struct engine *engine, const struct json_value *request,
                c205_error *error);
/* For who runs the program: is the slice over? */
bool slice_is_over(void *engine);
/* .. for other work, by what it has spent. */
bool slice_is_full(const struct engine *engine);

/* One sentence; false. */
bool refuse(c205_error *error, const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 2, 3)))
#endif
    ;
/* The reason so far, behind a name; false. */
bool refuse_of(c205_error *error, const char *name);
/* The debugger's own words, without "error: ". */
bool refuse_as_said(struct engine *engine, c205_error *error);
/* .. as a member, and nothing is said any more. */
bool put_said(struct engine *engine, struct json *reply, const char *key,
              c205_error *error);
/* NULL: no memory. */
char *copy_of(const char *text);
bool needs_program(const struct engine *engine, c205_error *error);

/* ---- Programs (program.c) --------------------------------------------------------- */

void program_drop(struct engine *engine);
void put_diagnostics(const struct diagnostics *diagnostics, struct json *reply);
/* "defines" and "files" of a request, kept in an arena. */
bool take_options(const struct json_value *request, struct arena *arena,
                  struct asm_options *options, c205_error *error);
/* "warm", if it is there. */
bool take_warm(const struct json_value *request, struct object *object,
               c205_error *error);
/* Whether one of the programs uses each name that is defined. */
bool uses_defines(const struct asm_options *options, struct object *const *objects,
                  size_t count, c205_error *error);
/* NULL: it cannot be assembled, the diagnostics of the engine say why. */
struct object *engine_assemble(struct engine *engine, const char *name,
                               const char *text, const struct asm_options *options,
                               c205_error *error);
/* The model by that name, or that which the program names, or the usual; NULL: there is
 * none. */
c205_model *program_model(const char *name, const struct object *object,
                          c205_error *error);
/* The line of a program's own text: of a macro that is called there, the call.  0: none is
 * known. */
size_t program_line(const struct engine *engine, uint64_t address);

/* What was printed behind a step was of another run. */
void printed_forget(struct printed *printed, uint64_t step);
/* How much had been printed when the program stood at a step. */
size_t printed_until(const struct printed *printed, uint64_t step);
/* .. and whether there was more that is not kept. */
bool printed_is_cut(const struct printed *printed, uint64_t step);

/* ---- Views (view.c, registers.c, instruction.c) ----------------------------------- */

const c205 *engine_machine(const struct engine *engine);
void put_hex(struct json *json, const char *key, c205_word word);
void put_word(struct json *json, const char *key, c205_word word);
void put_half(struct json *json, const char *key, c205_word half);
void put_registers(const struct engine *engine, bool all, struct json *reply);
bool put_vectors(const struct engine *engine, const struct json_value *request,
                 struct json *reply, c205_error *error);
void put_next_insn(const struct engine *engine, struct json *reply);
bool put_last_insn(const struct engine *engine, struct json *reply, c205_error *error);
bool put_accounts(const struct engine *engine, struct json *reply, c205_error *error);

/* The table is freed. */
bool put_table(struct table *table, const char *key, struct json *reply,
               c205_error *error);

/* ---- Once more (replay.c) ---------------------------------------------------------- */

/* The ear of the program's machine: whoever wants to listen does. */
c205_listener replay_listen;
/* From here on whoever listens is the replay's; none of both: there was no memory.  To a
 * step, which is known. */
bool replay_begin(struct engine *engine, struct line_profile *profile,
                  struct timeline *timeline, uint64_t end, c205_error *error);
/* As far as the slice allows; when all has been heard it is put, else there will be more by
 * `again`. */
bool replay_slice(struct engine *engine, struct json *reply, engine_slice *again,
                  engine_slice *put, c205_error *error);
/* Nobody listens any more, and the program is where it stood. */
void replay_drop(struct engine *engine);

#endif
