/* check_site.h - shared by the files of the runtime checks. Not public. */
#ifndef ASM_CHECK_SITE_H
#define ASM_CHECK_SITE_H

#include "asm/check/precision.h"
#include "asm/check/runtime_check.h"
#include "asm/check/storage_map.h"
#include "asm/view/operand_view.h"
#include "vm/error.h"

struct site;
typedef void site_check(struct runtime_checker *watch, const c205 *machine,
                        struct site *site);

/* A check site: an instruction of the program, and the checks before and
 * after its execution. */
struct site {
    struct instruction_view view;
    site_check *before, *after; /* NULL: nothing */
    enum precision_rule rule;
    uint64_t executions;
    /* In a linked pair the first instruction passes its result to the second and stores
     * none. hands_over in the first and is_handed in the second are the register of
     * that result; 0: not linked. */
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
    struct sink report;
    struct storage_map *storage;
    warning_set meant, warned;
    size_t errors, reported_count;
    struct reported reported[MAX_REPORTED];
    /* entered: the word that ES or EX entered in a register. emptied: the
     * word when ELEN set the length to 0. If a register still holds it, no
     * other length was set. */
    bool is_entered[C205_REGISTERS], is_emptied[C205_REGISTERS];
    c205_word entered[C205_REGISTERS], emptied[C205_REGISTERS];
    bool is_written[C205_REGISTERS]; /* by any instruction */
    struct site sites[CHECK_SITES];  /* a table by address */
    /* The checks before execution alone: usually there are none, and
     * this test must be fast. */
    struct {
        uint64_t pc;
        site_check *before;
    } direct[CHECK_SITES];
};

/* Sets before and after (check_site.c). */
void site_choose(struct site *site);
void runtime_recurrence(struct runtime_checker *watch, const c205 *machine,
                        struct site *site, size_t elements);

/* runtime_check.c */
struct site *runtime_site(struct runtime_checker *watch, const c205 *machine,
                          uint64_t pc);
void runtime_report(struct runtime_checker *watch, const struct site *site,
                    enum warning warning, const char *format, ...) PRINTF_FORMAT(4, 5);

#endif
