/* test_register_owners.c - the reports of the check of shared registers are compared
 * with expected lines and names. A program that loses a register to another name has
 * one report. A program that saves the register, or names it by number, has no report.
 * A write that is missed, or a report about a register that was restored, fails here.
 */

#include "tests/oracle/register_owners.h"
#include "tests/unit/prior_model.h"
#include "tests/unit/saved_machine.h"

/* Runs a program to its end, and compares the reports: "file:line" of each. */
static void check(const char *text, size_t count, const char *expected)
{
    SCOPED(object) *program = good(text);
    SCOPED(register_owners) *owners = register_owners_new(program);
    SCOPED_VALUE(text_buffer) printed = { NULL, 0, 0, false };
    struct sink sink = text_buffer_sink(&printed);
    SCOPED(c205) *machine = machine_with(&program->program, prior_model);
    assert_non_null(owners);
    assert_true(c205_listen(machine, register_owners_listen, owners));
    assert_int_equal(c205_run(machine, 100000).trap, C205_TRAP_NONE);
    register_owners_print(owners, &sink);
    FAIL_IF(register_owners_found(owners) != count
                || (count > 0 && !strstr(printed.text, expected)),
            "%s%s", text, printed.text ? printed.text : "");
}

/* a and b are r5. u and p are r20. v and q are r21. */
#define NAMES \
    " .include \"core.s\"\n .regs r4, z, a\n .regs r20, u, v\n" \
    " .share\n .reg b, r5\n .regs r20, p, q\n .endshare\n" \
    " .data\ndata: .word 1, 2\nkept: .space 2\nbits: .space 1\n .code\n"
#define FIRST 13 /* the line after NAMES */

#define A_OF_B "r5 is read as 'a', but it is 'b'"
#define U_OF_P "r20 is read as 'u', but it is 'p'"
#define V_OF_Q "r21 is read as 'v', but it is 'q'"

struct lost {
    const char *text;       /* text after NAMES */
    unsigned read, written; /* line numbers, counted from 0 */
    const char *names;      /* the register, its name and its owner; NULL: A_OF_B */
};

TEST(lost)
{
    static const struct lost cases[] = {
        /* The register is a source, modified, an index, an address or a link. */
        { " ES a, 1\n ES b, 2\n ADDX a, r8, r8\n", 2, 1, NULL },
        { " ES b, 1\n IS a, 2\n", 1, 0, NULL },
        { " ES b, 0\n EX r9, data\n LOD [r9, a], r9\n", 2, 0, NULL },
        { " EX b, data\n LOD [a], r9\n", 1, 0, NULL },
        { " EX b, data\n STO [a], r9\n", 1, 0, NULL },
        { " EX b, data\n STO [b], b\n EX r9, data\n STO [r9], a\n", 3, 0, NULL },
        { " EX b, on\n BIM 0, a\non:\n", 1, 0, NULL },
        { " EX b, on\n IBXEQ r0, r0, r0, [a], r9\non:\n", 1, 0, NULL },
        { " EX r9, on\n ES b, 0\n IBXEQ r0, r0, r0, [r9, a], r9\non:\n", 2, 1, NULL },
        /* A vector instruction reads the register. */
        { " EX b, data\n ELEN b, 2\n VTOV [a], [a]\n", 2, 1, NULL },
        { " ES b, 2\n EX r9, data\n ELEN r9, 2\n ADDNV a, [r9], [r9]\n", 3, 0, NULL },
        { " ES b, 0\n EX r9, data\n ELEN r9, 2\n VTOV [r9, a], [r9]\n", 3, 0, NULL },
        { " EX b, bits\n ELEN b, 2\n EX r9, data\n ELEN r9, 2\n"
          " VTOV [r9], [r9] ? [a]\n",
          4, 1, NULL },
        { " EX z, data\n ELEN z, 1\n ES b, 1\n VTOV [z], [z, a]\n", 3, 2, NULL },
        /* Other instructions write the register. */
        { " EX r9, on\n BSAVE b, [r9]\non: ADDX a, r8, r8\n", 2, 1, NULL },
        { " EX r9, data\n ELEN r9, 2\n PRODV [r9], b\n ADDX a, r8, r8\n", 3, 2, NULL },
        { " EX r9, data\n ELEN r9, 2\n SUMV [r9], p\n ADDX u, r8, r8\n", 3, 2, U_OF_P },
        { " EX r9, data\n ELEN r9, 2\n SUMV [r9], p\n ADDX v, r8, r8\n", 3, 2, V_OF_Q },
        { " EX r9, data\n ELEN r9, 2\n MAXV [r9], b, p\n ADDX a, r8, r8\n", 3, 2,
          NULL },
        { " EX r9, data\n ELEN r9, 2\n MAXV [r9], p, b\n ADDX a, r8, r8\n", 3, 2,
          NULL },
        { " EX r9, data\n ELEN r9, 2\n SWAP [r9], p, [r0]\n"
          " ADDX v, r8, r8\n",
          3, 2, V_OF_Q },
        /* The register was saved, but another name owns it when it is read. */
        { " ES v, 7\n EX r9, kept\n ELEN r9, 2\n SWAP [r0], u, [r9]\n"
          " ES q, 8\n ADDX v, r8, r8\n SWAP [r9], r20, [r0]\n",
          5, 4, V_OF_Q },
        /* The restored words are not the saved words. */
        { " ES v, 7\n EX r9, kept\n ELEN r9, 2\n SWAP [r0], u, [r9]\n"
          " IX r9, 64\n STO [r9], r9\n IX r9, -64\n SWAP [r9], p, [r0]\n"
          " ADDX v, r8, r8\n",
          8, 7, V_OF_Q },
    };
    for (size_t i = 0; i < COUNT(cases); i++) {
        const struct lost *lost = &cases[i];
        char text[1000], expected[200];
        snprintf(text, sizeof text, NAMES "%s EXIT\n", lost->text);
        snprintf(expected, sizeof expected, "test.s:%u: %s since test.s:%u\n",
                 FIRST + lost->read, lost->names ? lost->names : A_OF_B,
                 FIRST + lost->written);
        check(text, 1, expected);
    }
}

TEST(left_alone)
{
    static const char *const texts[] = {
        " ES a, 1\n ADDX a, r8, r8\n ES b, 2\n ADDX b, r8, r8\n",
        /* An instruction has two names. A name is an alias. */
        " ES b, 1\n ADDX a, b, r8\n",
        " .reg c, a\n ES c, 1\n ADDX a, r8, r8\n ES a, 1\n ADDX c, r8, r8\n",
        " ES a, 1\n .reg a, r5\n ADDX a, r8, r8\n",
        /* The register is named by number. */
        " ES r5, 1\n ADDX a, r8, r8\n ES b, 1\n ADDX r5, r8, r8\n",
        /* The register was never written. */
        " ADDX a, r8, r8\n",
        /* The register was saved and restored. */
        " ES u, 6\n ES v, 7\n EX r9, kept\n ELEN r9, 2\n SWAP [r0], p, [r9]\n"
        " ES p, 8\n ES q, 9\n ADDX p, q, q\n SWAP [r9], p, [r0]\n"
        " ADDX u, v, v\n",
        " ES v, 7\n EX r9, kept\n ELEN r9, 2\n SWAP [r0], r20, [r9]\n"
        " ES q, 9\n SWAP [r9], r20, [r0]\n ADDX v, r8, r8\n",
        /* The value is passed through memory. */
        " ES u, 6\n ES v, 7\n EX r9, kept\n ELEN r9, 2\n SWAP [r0], u, [r9]\n"
        " SWAP [r9], b, [r0]\n ADDX b, r8, r8\n",
        /* The register is loaded again. */
        " ES v, 7\n EX r9, data\n ELEN r9, 2\n SWAP [r9], p, [r0]\n"
        " ADDX q, r8, r8\n SWAP [r9], u, [r0]\n ADDX v, r8, r8\n",
    };
    for (size_t i = 0; i < COUNT(texts); i++)

        check(formatted(NAMES "%s EXIT\n", texts[i]), 0, "");
}
