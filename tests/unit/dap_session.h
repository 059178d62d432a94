/* dap_session.h - debug sessions of a client, and queries of the program's state. */
#ifndef TESTS_DAP_SESSION_H
#define TESTS_DAP_SESSION_H

#include "tests/unit/asm_helper.h"
#include "tests/unit/dap_client.h"

/* A program with library macros, a region, a loop, a call and exit status 3. The
 * constants are the addresses of some of its instructions, and of its data. */
extern const char client_program[];
enum {
    AGAIN = 0x400120,
    CALL = 0x400160,
    BSAVE = 0x4001A0,
    DBNZ = 0x4001C0,
    DOUBLE = 0x400260,
    WORDS_A = 0x800000,
    WORDS_B = 0x800100
};

/* The path of the last program that was written, and its file name. */
extern char client_path[];
void client_write(const char *text);
const char *client_file_name(void);

/* Starts a session up to the point where breakpoints are set. Returns the adapter's
 * capabilities. `more`: further members of the request, each after a comma. */
const struct json_value *client_launch(struct dap_client *client, const char *text,
                                       const char *more);
const struct json_value *client_launch_file(struct dap_client *client,
                                            const char *more);
/* Starts a session, and runs it to the first instruction. */
void client_enter(struct dap_client *client, const char *text);
/* Runs the program to the end of the session. */
void client_leave(struct dap_client *client);

/* Executes a request until a stop for `reason`. client_go_finely steps instructions. */
void client_go(struct dap_client *client, const char *request, const char *reason);
void client_go_finely(struct dap_client *client, const char *request);
/* Sets the only breakpoint of the file; "" removes it. */
void client_stop_at(struct dap_client *client, const char *stop);

/* ---- Program state --------------------------------------------------------------- */

const struct json_value *client_frames(struct dap_client *client);
uint64_t client_pc(struct dap_client *client);
uint64_t client_step(struct dap_client *client);
/* client_variables returns the variables of a scope. client_inside returns the
 * variables of a reference, for further arguments. */
const struct json_value *client_variables(struct dap_client *client, const char *scope);
const struct json_value *client_inside(struct dap_client *client, int reference,
                                       const char *more);
const char *value_of(const struct json_value *list, const char *name);
int reference_of(const struct json_value *list, const char *name);
/* Returns the bits of a value that is shown as "2  X'FFD3 4000 0000 0000'  ..". */
c205_word word_in(const char *value);
/* Evaluates an expression and returns the text of its value. */
const char *client_print(struct dap_client *client, const char *expression);
const struct json_value *client_disassembled(struct dap_client *client,
                                             uint64_t address, int from, int count);

#endif
