/* check_site.h - the check sites of a program, each an instruction with its run-time
 * checks, and the state of the runtime checker. Not public. */
#ifndef ASM_CHECK_SITE_H
#define ASM_CHECK_SITE_H

#include "asm/check/precision.h"
#include "asm/check/runtime_check.h"
#include "asm/check/storage_map.h"
#include "asm/view/unwritten.h"
#include "vm/error.h"

struct site;
typedef void site_check(struct runtime_checker *watch, const c205 *machine,
                        struct site *site);

/* A check site: an instruction of the program and its checks before and after
 * execution. */
struct site {
    struct instruction_view view;
    site_check *before, *after; /* NULL: no check */
    enum precision_rule rule;
    uint64_t executions;
    /* The register through which the first instruction of a linked pair passes its
     * result, which is not stored, to the second; 0: not linked. hands_over is set in
     * the first instruction, is_handed in the second. */
    uint8_t hands_over, is_handed;
};

enum { CHECK_SITES = 1 << 12, MAX_REPORTED = 200 };

struct reported {
    const char *file; /* "": number is an address */
    uint64_t number;
    enum warning warning;
};

struct runtime_checker {
    const struct object *object;
    const char *name;
    const struct warning_choice *choice;
    const struct sink *report; /* NULL: the reports are not printed */
    struct storage_map *storage;
    struct diagnostics found; /* one for each item of reported */
    warning_set meant, warned;
    size_t reported_count;
    struct reported reported[MAX_REPORTED];
    /* entered: the word that ES or EX entered in a register. emptied: the word of the
     * register after ELEN had set its length to 0. If the register still contains this
     * word, no other length was set. */
    bool is_entered[C205_REGISTERS], is_emptied[C205_REGISTERS];
    c205_word entered[C205_REGISTERS], emptied[C205_REGISTERS];
    struct register_set written; /* registers that were written, or found unwritten */
    bool is_straight;            /* the assembler has checked the first reads so far */
    struct site sites[CHECK_SITES]; /* indexed by address */
    /* A copy of `pc` and `before` of the sites, without their other members, because it
     * is read at every instruction. Most instructions have no check. The registers that
     * an instruction reads are checked when it becomes a site, because a register that
     * was written once remains written. */
    struct {
        uint64_t pc;
        site_check *before;
    } direct[CHECK_SITES];
};

/* Chooses the checks of an instruction: site->before and site->after (check_site.c). */
void site_choose(struct site *site);
void runtime_recurrence(struct runtime_checker *watch, const c205 *machine,
                        struct site *site, size_t elements);

/* runtime_site returns the struct site of the instruction at address pc. runtime_report
 * reports a warning about the instruction of a site, unless the same warning was
 * reported before for the same source line (runtime_check.c). */
struct site *runtime_site(struct runtime_checker *watch, const c205 *machine,
                          uint64_t pc);
void runtime_report(struct runtime_checker *watch, const struct site *site,
                    enum warning warning, const char *format, ...) PRINTF_FORMAT(4, 5);

#endif
