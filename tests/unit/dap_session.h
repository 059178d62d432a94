/* dap_session.h - sessions of a client of c205 debug --dap with a program, and what they
 * look at.
 */
#ifndef TESTS_DAP_SESSION_H
#define TESTS_DAP_SESSION_H

#include "tests/unit/asm_helper.h"
#include "tests/unit/dap_client.h"

/* A program with macros of the library, a region, a loop, a call, and the exit status 3; and
 * where some of its instructions are, and its data. */
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

/* The file of the last program that was written, and its name without the folder. */
extern char client_path[];
void client_write(const char *text);
const char *client_file_name(void);

/* To where breakpoints are set; what the adapter is capable of.  more: further members of
 * launch, each behind a comma. */
const struct json_value *client_launch(struct dap_client *client, const char *text,
                                       const char *more);
const struct json_value *client_launch_file(struct dap_client *client,
                                            const char *more);
/* To the first instruction. */
void client_enter(struct dap_client *client, const char *text);
/* To the end of the session. */
void client_leave(struct dap_client *client);

/* A motion, and why it ends; by instructions, where it was to. */
void client_go(struct dap_client *client, const char *request, const char *reason);
void client_go_finely(struct dap_client *client, const char *request);
/* All that stops in the file: a breakpoint, or "". */
void client_stop_at(struct dap_client *client, const char *stop);

/* ---- Where it stands ---------------------------------------------------------- */

const struct json_value *client_frames(struct dap_client *client);
uint64_t client_pc(struct dap_client *client);
uint64_t client_step(struct dap_client *client);
/* The variables of a scope; of a reference, with further arguments. */
const struct json_value *client_variables(struct dap_client *client, const char *scope);
const struct json_value *client_inside(struct dap_client *client, int reference,
                                       const char *more);
const char *value_of(const struct json_value *list, const char *name);
int reference_of(const struct json_value *list, const char *name);
/* Its bits: "2  X'FFD3 4000 0000 0000'  .." */
c205_word word_in(const char *value);
/* What an expression is. */
const char *client_print(struct dap_client *client, const char *expression);
const struct json_value *client_disassembled(struct dap_client *client,
                                             uint64_t address, int from, int count);

#endif
