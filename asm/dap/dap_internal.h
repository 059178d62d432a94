/* dap_internal.h - the internals of a session. Not public.
 *
 * A request is a function that reads the arguments of the session and writes the body
 * of its response. It reports an error by dap_fault or by debug_fault of the debugger,
 * and returns false. Work that must follow the response, such as an execution request,
 * is assigned to `then`.
 *
 * A request may arrive while an earlier request runs the program. After the nested
 * request, the session has the arguments and the body of the earlier request again.
 */
#ifndef ASM_DAP_DAP_INTERNAL_H
#define ASM_DAP_DAP_INTERNAL_H

#include "asm/dap/dap.h"
#include "asm/debug/debugger_engine.h"
#include "asm/view/vector_view.h"
#include "base/json.h"
#include "base/json_read.h"
#include "vm/error.h"

/* The states of a session, in the order in which it passes them. Each is a bit, so sets
 * of states can be combined with |. */
enum dap_state {
    DAP_NEW = 1,
    DAP_GREETED = 2,  /* after initialize */
    DAP_LAUNCHED = 4, /* after launch, while breakpoints are set */
    DAP_STANDING = 8, /* after configurationDone, and at each stop */
    DAP_RUNNING = 16, /* the program runs */
    DAP_ENDED = 32    /* the program has ended, or was terminated */
};

/* A request of the client that ends the current execution. */
enum pending_request {
    PENDING_NONE,
    PENDING_PAUSE,
    PENDING_TERMINATE,
    PENDING_RESTART
};

struct dap {
    struct dap_setup setup;
    struct text_buffer input; /* received bytes that are not handled yet */
    uint64_t sent;            /* number of messages sent */
    enum dap_state state;
    bool over; /* the client has disconnected, or its input has ended */
    bool failed;
    c205_error *error; /* why the session failed */

    struct text_buffer said;    /* reports of the debugger and of dap_fault */
    struct text_buffer printed; /* unsent output of the program */
    struct arena launched;      /* owns the texts of the following fields */
    const char *path;
    struct object *object;
    c205_model *model;
    struct debugger *debugger;
    size_t file_count;
    const char **files; /* source files, named as in the object */

    const struct json_value *arguments; /* arguments of the current request, or NULL */
    struct json *body;                  /* body of its response */

    bool stop_on_entry, stop_on_end, stop_at_traps;
    bool exit_reported;  /* the client was notified that the program has ended */
    bool client_redraws; /* the client supports the event invalidated */
    int64_t first_line, first_column; /* number of the first line or column at the
                                         client: 0 or 1 */
    enum pending_request pending;
    enum execution_end (*move)(struct debugger *debugger);
    const char *reason; /* reason for the event `stopped` if the execution completes as
                           requested */
    void (*then)(struct dap *dap); /* called after the response, or NULL */
};

typedef bool dap_request(struct dap *dap);

enum {
    ALWAYS = DAP_NEW | DAP_GREETED | DAP_LAUNCHED | DAP_STANDING | DAP_RUNNING
             | DAP_ENDED,
    WITH_PROGRAM = DAP_LAUNCHED | DAP_STANDING | DAP_RUNNING | DAP_ENDED,
    NOT_RUNNING = DAP_LAUNCHED | DAP_STANDING | DAP_ENDED
};

/* The requests, and the states in which each is permitted. */
/* clang-format off */
#define DAP_REQUESTS(ROW) \
    ROW("initialize", request_initialize, DAP_NEW) \
    ROW("launch", request_launch, DAP_GREETED) \
    ROW("configurationDone", request_configuration_done, DAP_LAUNCHED) \
    ROW("restart", request_restart, DAP_STANDING | DAP_RUNNING | DAP_ENDED) \
    ROW("terminate", request_terminate, WITH_PROGRAM) \
    ROW("disconnect", request_disconnect, ALWAYS) \
    ROW("setBreakpoints", request_breakpoints, WITH_PROGRAM) \
    ROW("setFunctionBreakpoints", request_function_breakpoints, WITH_PROGRAM) \
    ROW("setInstructionBreakpoints", request_instruction_breakpoints, WITH_PROGRAM) \
    ROW("setDataBreakpoints", request_data_breakpoints, WITH_PROGRAM) \
    ROW("setExceptionBreakpoints", request_exception_breakpoints, WITH_PROGRAM) \
    ROW("dataBreakpointInfo", request_data_breakpoint_info, NOT_RUNNING) \
    ROW("breakpointLocations", request_breakpoint_locations, WITH_PROGRAM) \
    ROW("continue", request_continue, DAP_STANDING) \
    ROW("next", request_next, DAP_STANDING) \
    ROW("stepIn", request_step_in, DAP_STANDING) \
    ROW("stepOut", request_step_out, DAP_STANDING) \
    ROW("stepBack", request_step_back, DAP_STANDING) \
    ROW("reverseContinue", request_reverse_continue, DAP_STANDING) \
    ROW("pause", request_pause, DAP_STANDING | DAP_RUNNING) \
    ROW("goto", request_goto, DAP_STANDING) \
    ROW("gotoTargets", request_goto_targets, WITH_PROGRAM) \
    ROW("exceptionInfo", request_exception_info, NOT_RUNNING) \
    ROW("threads", request_threads, WITH_PROGRAM) \
    ROW("stackTrace", request_stack_trace, NOT_RUNNING) \
    ROW("source", request_source, WITH_PROGRAM) \
    ROW("loadedSources", request_loaded_sources, WITH_PROGRAM) \
    ROW("scopes", request_scopes, NOT_RUNNING) \
    ROW("variables", request_variables, NOT_RUNNING) \
    ROW("setVariable", request_set_variable, NOT_RUNNING) \
    ROW("evaluate", request_evaluate, NOT_RUNNING) \
    ROW("setExpression", request_set_expression, NOT_RUNNING) \
    ROW("readMemory", request_read_memory, NOT_RUNNING) \
    ROW("writeMemory", request_write_memory, NOT_RUNNING) \
    ROW("disassemble", request_disassemble, NOT_RUNNING)
/* clang-format on */
#define DECLARE(name, answer, states) dap_request answer;
DAP_REQUESTS(DECLARE)
#undef DECLARE

/* Frees the program, even if it is only partly open (launch.c). */
void close_program(struct dap *dap);

/* ---- Arguments (arguments.c) --------------------------------------------- */

/* Checks the types of the members of an object. `owner` is the request or the type of
 * the protocol to which the object belongs. Reports an error and returns false if a
 * type is wrong. */
bool dap_check(struct dap *dap, const char *owner, const struct json_value *object);

/* ---- Reports and messages (respond.c) ------------------------------------ */

/* Reports an error as one sentence to dap->said, and returns false. */
bool dap_fault(struct dap *dap, const char *format, ...) PRINTF_FORMAT(2, 3);
/* Writes the reports since the last call as a member of an object. */
void dap_put_said(struct dap *dap, struct json *json, const char *key);
/* Returns a sink that appends to dap->said, the reports of the current request. */
struct sink dap_output_sink(struct dap *dap);

/* The body of an event or response is written between event_begin and event_end.
 * event_begin returns NULL if memory is exhausted; the session is then over. */
struct json *event_begin(struct dap *dap, struct text_buffer *body);
void event_end(struct dap *dap, const char *name, struct json *json,
               struct text_buffer *body);
/* Sends an event. body is JSON text, or NULL. */
void send_event(struct dap *dap, const char *name, const char *body);
/* Sends an `output` event with a category, unless the text is empty. */
void send_output(struct dap *dap, const char *category, const char *text);
/* Sends the unsent output of the program. */
void send_printed(struct dap *dap);
/* Responds to a request. text is the body as JSON, or the reason of a failure. */
void send_response(struct dap *dap, const struct json_value *request, bool success,
                   const char *text);

/* Handles the input of the client while a program runs. Returns true if the program
 * must stop (session.c). */
bool dap_listen(void *dap);

/* ---- Numbers and addresses (respond.c) ----------------------------------- */

/* Writes an address of the machine, in bits, in the form of the protocol:
 * "0x4001C0". */
enum { DAP_ADDRESS_SIZE = 24 };
void dap_put_address(struct json *json, const char *key, uint64_t address);
/* Reads an address from a member and adds the member `offset`, in bytes. Reports an
 * error and returns false if it is not an address. */
bool dap_address(struct dap *dap, const struct json_value *arguments,
                 const char *reference, uint64_t *address);
/* Reads an integer member. The value is unchanged if the member is absent. Reports an
 * error and returns false if it is not an integer. */
bool dap_whole(struct dap *dap, const struct json_value *arguments, const char *key,
               int64_t *value);

/* ---- Groups of breakpoints ----------------------------------------------- */

/* The groups of breakpoints. A request replaces all breakpoints of its group. Each
 * source file has a group. */
enum dap_group {
    GROUP_FUNCTIONS = 1,
    GROUP_INSTRUCTIONS,
    GROUP_DATA,
    GROUP_FILES /* the index of a file is added */
};

/* ---- Sources (frames.c) -------------------------------------------------- */

/* Lists the source files of the object. Returns false if memory is exhausted. */
bool sources_find(struct dap *dap);
/* Returns the index of a file by its name, or file_count if the name is NULL or not
 * listed. */
size_t file_index(const struct dap *dap, const char *file);
/* Returns the file of a Source, a type of the protocol. NULL: the program has no such
 * file. */
const char *source_file(const struct dap *dap, const struct json_value *source);
/* put_source writes the member `source` of an object. put_source_members writes only
 * the content of this member. */
void put_source(struct dap *dap, struct json *json, const char *file);
void put_source_members(struct dap *dap, struct json *json, const char *file);
/* line_of converts a line number of the client to a line number of the debugger.
 * put_line writes a line number for the client. */
size_t line_of(const struct dap *dap, int64_t line);
void put_line(const struct dap *dap, struct json *json, const char *key, size_t line);

/* ---- Execution (execution.c) --------------------------------------------- */

/* Starts the program and stops it before its first instruction or at the first
 * breakpoint. */
void dap_begin(struct dap *dap);
/* Sends the event terminated. */
void dap_finish(struct dap *dap);
/* Sends the event "stopped". Its description is what the debugger has reported. met:
 * breakpoints stopped the program. */
void dap_stopped(struct dap *dap, const char *reason, bool met);

/* ---- Elements (elements.c) ----------------------------------------------- */

/* put_bits prints a value as a number and its bits. put_elements writes elements of a
 * vector as variables. */
void put_bits(c205_word word, unsigned width, const struct sink *sink);
void put_elements(struct dap *dap, struct json *json, const struct vector_view *vector,
                  size_t first, size_t count);
/* Parses an element such as "[12]". Returns false if the vector has no such element. */
bool element_number(const struct vector_view *vector, const char *name, size_t *number);

/* ---- Variables (variables.c) --------------------------------------------- */

/* Sets *vector to the vector whose elements a variable reference denotes. Returns false
 * if the reference denotes no vector. */
bool vector_of(struct dap *dap, int64_t reference, struct vector_view *vector);
/* Writes the members for the value of a register: its word, and the vector that the
 * word describes, if any. */
void put_word_members(struct dap *dap, struct json *json, struct register_of named);

#endif
