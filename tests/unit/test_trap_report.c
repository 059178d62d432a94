/* test_trap_report.c - reports of traps are compared with expected parts: the line, the
 * violated rule, and the values of the operands. A wrong operand or line fails here. */
#include "tests/unit/saved_machine.h"

#include "asm/view/trap_report.h"

static void check(const char *text, bool lines, const char *const *said)
{
    SCOPED(c205_model) *model = c205_model_find("cyber205-2pipe", &failure);
    SCOPED_VALUE(text_buffer) report = { NULL, 0, 0, false };
    struct sink sink = text_buffer_sink(&report);
    SCOPED(object) *object = good(text);
    SCOPED(c205) *machine = machine_with(&object->program, model);
    c205_stop stop = c205_run(machine, 100000);
    assert_int_not_equal(stop.trap, C205_TRAP_NONE);
    trap_report(lines ? object : NULL, "test.o", machine, &stop, &sink);
    for (; *said; said++)
        FAIL_IF(!strstr(report.text, *said), "%s\nexpected '%s', found\n%s", text,
                *said, report.text);
}

#define CHECK(text, ...) check(text, true, (const char *const[]){ __VA_ARGS__, NULL })

#define DATA \
    " .include \"core.s\"\n .data\n .vector x, 3, 1.0, 2.0, 3.0\n" \
    " .halfvector h, 3, 1.0, 2.0, 3.0\n .code\n .regs r10, a, b, c, o, z\n" \
    " descriptor a, x, 3\n descriptor b, x, 3\n descriptor c, x, 3\n" \
    " ES o, -1\n descriptor z, x, 3\n"

TEST(rules)
{
    CHECK(" .half 0\n", "test.s:1:2: error: trap undefined-instruction at",
          ": 00000000: no instruction has this code");
    CHECK(" .half X'F080 0000', 0\n",
          "the fields or G bits of the instruction are invalid");
    CHECK(" ES r1, 64\n LOD [r1], r2\n", "test.s:2:2: error",
          "address 40: no memory is mapped there", "\n     LOD [r1], r2\n",
          "    r1 = X'0000 0000 0000 0040' (64)\n");
    CHECK(DATA " MPYSV [a, o], [b], [c]\n", "test.s:12:2: error: trap bad-descriptor",
          "an offset must not be negative",
          "    [a (r10), o (r13)]: its offset is negative\n",
          "    [b (r11)]: 3 words from 800000 on\n");
    CHECK(DATA " ES b, -1\n EXTB a, b, c\n", "must end within its word");
    CHECK(DATA " SWAP [a], r254, [r0]\n", "must end at r255 or below");
    CHECK(DATA " MRKO a, r0, [c]\n", "at least one bit");
    CHECK(" .half X'DA00 000A', 11\n", "trap undefined-instruction",
          "a sum in two registers must begin with an even register");
    CHECK(DATA " EX c, x + 32\n ELEN c, 2\n VTOV [a], [c]\n", "trap misaligned-operand",
          "words must be at multiples of 64 bits", "[c (r12)]: 2 words from 800020 on");
    CHECK(DATA " EX a, x + 1\n BSAVE b, [a]\n",
          "instructions must be at multiples of 32 bits");
    CHECK(DATA " EX a, x + 32\n ELEN a, 2\n EXIT a, r0, 6\n",
          "printed words at multiples of 64");
    CHECK(" EXIT r1, r2, 99\n", "trap bad-request",
          "a monitor request must be between 0 and 7");
    CHECK(DATA " EX c, 64\n ES c, 64\n MPYSV [a, o], [b], [c]\n",
          "an offset must not be negative",
          "    [c (r12)]: 0 words from 40 on; its length was not set\n");
    CHECK(DATA " BIM .\n", "trap clock-limit");
}

#define LINK(first, second) DATA " LINKV\n " first "\n " second "\n"

TEST(links)
{
    CHECK(LINK("ES a, 1", "ADDNV [c], [b], [c]"),
          "the prefix must be followed by two vector instructions");
    CHECK(LINK("MPYSV [a], o, [c]", "SUMV [c], z"),
          "the prefix must be followed by two vector instructions");
    CHECK(LINK("SQRTV [a], [c]", "DIVSV [c], [b], [c]"), "must use different units");
    CHECK(LINK("CMPGEV [a], [b], [c]", "MPYSV [c], o, [c]"),
          "must be numbers, not bits");
    CHECK(LINK("MPYSV,H [a], h40, [c]", "ADDNV [c], [b], [c]"), "or both half words");
    CHECK(LINK("MPYSV [a], o, [c] ? [z]", "ADDNV [c], [b], [c]"),
          "must have no control vector");
    CHECK(LINK("MPYSV [a], o, [c, o]", "ADDNV [c], [b], [c]"),
          "must have no result offset");
    CHECK(LINK("MPYSV [a], o, [c]", "ADDNV [a], [b], [c]"),
          "must be the result of the first", "    MPYSV:\n", "    ADDNV:\n",
          "    o (r13) = X'0000 FFFF FFFF FFFF' (-1)\n");
    CHECK(LINK("MPYSV [a], o, [c]", "ADDNV [c, o], [b], [c]"),
          "the linked source must have no offset");
    CHECK(LINK("MPYSV [a], [b], [c]", "ADDNV [c], [b], [c]"),
          "at most two vectors from memory");
    CHECK(DATA " ELEN b, 2\n LINKV\n MPYSV [a], o, [c]\n ADDNV [c], o, [b]\n",
          "must have the same length");
}

TEST(without_lines)
{
    static const char *const said[] = {
        "test.o: error: trap unmapped-address at 400020: LOD: address 40", NULL
    };
    check(" ES r1, 64\n LOD [r1], r2\n", false, said);
}
