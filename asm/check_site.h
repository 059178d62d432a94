/* check_site.h - what the files of the watch share.  Not public. */
#ifndef ASM_CHECK_SITE_H
#define ASM_CHECK_SITE_H

#include "asm/operand_view.h"
#include "asm/precision.h"
#include "asm/storage_map.h"
#include "asm/runtime_check.h"

struct site;
typedef void spot_look(struct runtime_checker *watch, const c205 *machine,
                       struct site *site);

/* An instruction of the program, and what there is to look at before it is
 * executed, and after it. */
struct site {
    struct instruction_view view;
    spot_look *before, *after; /* NULL: nothing */
    enum precision_rule rule;
    uint64_t looks; /* so many times */
    /* Of a linked pair the first hands its result to the second and stores
     * none; the second finds it under this register.  0: not linked. */
    uint8_t hands_over, is_handed;
};

enum { SPOTS = 1 << 12, MAX_REPORTED = 200 };

struct reported {
    const char *file; /* "": the number is an address */
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
    /* What ES or EX entered in a register, and what was there when ELEN gave
     * it the length 0: a register that still holds it got no other length. */
    bool is_entered[C205_REGISTERS], is_emptied[C205_REGISTERS];
    c205_word entered[C205_REGISTERS], emptied[C205_REGISTERS];
    bool is_written[C205_REGISTERS]; /* by any instruction */
    struct site spots[SPOTS];        /* found by their address .. */
    /* .. and what is looked at there, alone, as most often it is nothing. */
    struct {
        uint64_t pc;
        spot_look *before;
    } quick[SPOTS];
};

/* check_site.c: set before and after. */
void spot_choose(struct site *site);
void runtime_recurrence(struct runtime_checker *watch, const c205 *machine,
                        struct site *site, size_t elements);

/* runtime_check.c */
struct site *runtime_site(struct runtime_checker *watch, const c205 *machine,
                          uint64_t pc);
void runtime_report(struct runtime_checker *watch, const struct site *site,
                    enum warning warning, const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 4, 5)))
#endif
    ;

#endif
