/* dap_internal.h - the inside of a session.  Not public.
 *
 * A request is a function that reads its arguments and writes the body of its
 * response.  What is wrong it tells by dap_fault or by a debug_fault of the engine,
 * and returns false.  What is to be done when the client has its response, as a motion,
 * it leaves in `then`.
 */
#ifndef ASM_DAP_DAP_INTERNAL_H
#define ASM_DAP_DAP_INTERNAL_H

#include "asm/dap/dap.h"
#include "asm/debug/engine.h"
#include "asm/vector_view.h"
#include "base/json.h"
#include "base/json_read.h"

/* What a session has come to, in order. */
enum dap_state {
    DAP_NEW = 1,
    DAP_GREETED = 2,  /* initialize */
    DAP_LAUNCHED = 4, /* launch; breakpoints are set */
    DAP_STANDING = 8, /* configurationDone, and at each stop */
    DAP_RUNNING = 16, /* in a motion */
    DAP_ENDED = 32    /* the program, or what was asked of it */
};

/* What the client wants of a program that runs. */
enum pending_request {
    PENDING_NONE,
    PENDING_PAUSE,
    PENDING_TERMINATE,
    PENDING_RESTART
};

struct dap {
    struct dap_setup setup;
    struct text_buffer input; /* read, and not done with */
    uint64_t sent;            /* messages */
    enum dap_state state;
    bool over; /* the client has said goodbye, or can say nothing more */
    bool failed;
    c205_error *error; /* why */

    struct text_buffer said;    /* by the engine, and of faults */
    struct text_buffer printed; /* by the program, not sent yet */
    struct arena launched;      /* the texts of what follows */
    const char *path;
    struct object *object;
    c205_model *model;
    struct debugger *debugger;
    size_t file_count;
    const char **files; /* of the source lines, as the object calls them */

    bool stop_on_entry, stop_on_end, stop_at_traps;
    bool exit_reported;  /* the program is at its end, and the client knows */
    bool client_redraws; /* it takes the event invalidated */
    int64_t first_line, first_column; /* as the client counts: 0 or 1 */
    enum pending_request pending;
    enum execution_end (*move)(struct debugger *debugger);
    const char *reason; /* of the stop, if the motion ends where it was to */
    void (*then)(struct dap *dap);
};

typedef bool dap_request(struct dap *dap, const struct json_value *arguments,
                         struct json *body);

/* launch.c */
dap_request request_initialize, request_launch, request_configuration_done,
    request_restart, request_terminate, request_disconnect;
/* breakpoints.c */
dap_request request_breakpoints, request_function_breakpoints,
    request_instruction_breakpoints, request_data_breakpoints,
    request_data_breakpoint_info, request_exception_breakpoints,
    request_breakpoint_locations;
/* movement.c */
dap_request request_continue, request_next, request_step_in, request_step_out,
    request_step_back, request_reverse_continue, request_pause, request_goto,
    request_goto_targets, request_exception_info;
/* frames.c */
dap_request request_threads, request_stack_trace, request_source,
    request_loaded_sources;
/* variables.c, elements.c */
dap_request request_scopes, request_variables, request_set_variable;
/* evaluate.c */
dap_request request_evaluate, request_set_expression;
/* memory.c */
dap_request request_read_memory, request_write_memory, request_disassemble;

/* ---- What is asked (arguments.c) --------------------------------------------- */

/* Whether the members of an object have the types that a request's arguments have, or those of a
 * type of the protocol; false after a fault. */
bool dap_check(struct dap *dap, const char *owner, const struct json_value *object);

/* ---- What is said (respond.c) --------------------------------------------------- */

/* One sentence; false. */
bool dap_fault(struct dap *dap, const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 2, 3)))
#endif
    ;
/* What was told since, to be freed, NULL for nothing: without "error: " and the last
 * newline. */
char *dap_take_said(struct dap *dap);
/* A sink to what is said. */
struct sink dap_output_sink(struct dap *dap);

/* An event's body is written between them.  NULL: no memory, and the session is over. */
struct json *event_begin(struct dap *dap, struct text_buffer *body);
void event_end(struct dap *dap, const char *name, struct json *json,
               struct text_buffer *body);
void event_bare(struct dap *dap, const char *name);
/* The event output: of a category, if there is a text. */
void send_output(struct dap *dap, const char *category, const char *text);
/* What the program has printed until now. */
void send_printed(struct dap *dap);
/* request: what it answers.  body: JSON. */
void send_response(struct dap *dap, const struct json_value *request, const char *body);
void send_refusal(struct dap *dap, const struct json_value *request, const char *why);

/* Hear what the client says while a program runs (session.c): shall it stop? */
bool dap_listen(void *dap);

/* ---- Numbers and addresses (respond.c) -------------------------------------------- */

/* An address as the protocol has them, "0x4001C0": the machine's own, of a bit. */
enum { DAP_ADDRESS_SIZE = 24 };
void dap_put_address(struct json *json, const char *key, uint64_t address);
/* Of a member, and so many bytes behind it as another one says; false after telling. */
bool dap_address(struct dap *dap, const struct json_value *arguments,
                 const char *reference, uint64_t *address);
/* A member that is an integer, or stays; false after telling. */
bool dap_whole(struct dap *dap, const struct json_value *arguments, const char *key,
               int64_t *value);

/* ---- Groups of stops ------------------------------------------------------------ */

/* Each kind of request replaces those that it made; of lines each file has its own. */
enum dap_group {
    GROUP_FUNCTIONS = 1,
    GROUP_INSTRUCTIONS,
    GROUP_DATA,
    GROUP_FILES /* and its number */
};

/* ---- Sources (frames.c) ----------------------------------------------------------- */

/* The files of the object; false: no memory. */
bool sources_find(struct dap *dap);
/* The file that a Source names, NULL: the program has none such. */
const char *source_file(const struct dap *dap, const struct json_value *source);
/* The member source of an object; and what is in it. */
void put_source(struct dap *dap, struct json *json, const char *file);
void put_source_members(struct dap *dap, struct json *json, const char *file);
/* A line of ours, from what the client calls it; and back. */
size_t line_of(const struct dap *dap, int64_t line);
void put_line(const struct dap *dap, struct json *json, const char *key, size_t line);

/* ---- Motions (movement.c) ---------------------------------------------------------- */

/* From the beginning: with a stop there, or to the first one. */
void dap_begin(struct dap *dap);
/* The client is told that all is over. */
void dap_finish(struct dap *dap);
/* .. that the program stands. */
void dap_stopped(struct dap *dap, const char *reason);

/* ---- Elements (elements.c) ----------------------------------------------------------- */

/* A value as variables show it: a number and the bits. */
void put_bits(c205_word word, unsigned width, const struct sink *sink);
void put_elements(struct dap *dap, struct json *json, const struct vector_view *vector,
                  size_t first, size_t count);
/* "[12]"; false: it has no such element. */
bool element_number(const struct vector_view *vector, const char *name, size_t *number);

/* ---- Variables (variables.c) ------------------------------------------------------------ */

/* The vector that a reference stands for; false: none. */
bool vector_of(struct dap *dap, int64_t reference, struct vector_view *vector);
/* The members of a value that is a word of a register: its vector, if it is one. */
void put_word_members(struct dap *dap, struct json *json, struct register_of named);

#endif
