/* test_debugger_lines.c - the debugger's output for command lines is compared with a
 * table: values, invalid lines, output of the program, calls, links, macros and ends. A
 * value of another register, or an output that is printed twice, fails here. */
#include <inttypes.h>

#include "tests/unit/debugger_session.h"
#include "tests/unit/draw.h"

/* ---- Values --------------------------------------------------------------- */

static const char text[] = "        .include \"vectors.s\"\n"
                           "        .regs r16, a, b, count\n"
                           "        .equ  n, 4\n"
                           "        words a, 1.5, -2.0, 3.0\n"
                           "        words b\n"
                           "        .regs r20, bits\n"
                           "        .data\n"
                           "mask:   .word X'A000 0000 0000 0000'\n"
                           "third:  .halfword 0.5, 2\n"
                           "        .code\n"
                           "        descriptor bits, mask, n\n"
                           "        ES    count, 7\n"
                           "here:   ADDNV [a], [a], [b] ? [bits]\n"
                           "        LODH  [r0], h99\n"
                           "        EXIT\n";

TEST(values)
{
    static const struct line_said lines[] = {
        { "print n * 2 + 1", "9  X'9'" },
        { "until here", "here:" },
        { "print count", "number 7  address 7" },
        { "p count.i % 4", "3" },
        { "p a.length == n && !(count < 7)", "1" },
        { "p r18 - 0.5", "6.5" },
        { "p [a + 0] * 2", "is not an address; the address of a descriptor is NAME.i" },
        { "p [-64]", "error: no memory word at FFFFFFFFFFC0" },
        { "p [X'FFFFFFFFFFFFFFC0']", "error: no memory word at" },
        { "p [a.i] * 2", "3" },
        { "p [a.i+64] < -1 || 0", "1" },
        { "p X'FFD2 4000 0000 0000'", "number 1" },
        { "p -(2 - 5) / 2", "1" },
        { "p 7 / 2.0", "3.5" },
        { "x /2x a", "FFD2 6000 0000 0000" },
        { "x a ? bits", "  1             1.5  0              -2  1" },
        { "x/3b mask", "101" },
        { "step", "LODH" },
        { "step", "trap unmapped-address" },
        { "why", "vector start-up" },
        { "x b", "3" },
        { "set r18 = 9", "" },
        { "p count", "number 9" },
        { "set h37 = 2.5", "" },
        { "p h37", "number 2.5" },
        { "p (h37)", "number 2.5" },
        { "set r30 = h37", "" },
        { "p r30", "number 2.5" },
        { "set h50 = X'EC500000'", "" },
        { "p h50 == X'EC500000' && h50 == 5 && h50 + 1 == 6", "1" },
        { "set r31 = 5", "" },
        { "set r32 = 5.0", "" },
        { "p r31 == r32", "1" },
        { "set [b.i] = X'0000000500000005'", "" },
        { "x/2hi b.i", "             5               5" },
        { "set [b.i] = 3.0", "" },
        { "p 010 + 08", "18" },
        { "p h36", "number 0" },
        { "set [b.i + 64] = -4", "" },
        { "p [b.i + 64]", "number -4" },
        { "rs", "here:" },
        { "why", "ES r18, 7" },
        { "p count", "number 7" },
        { "info breaks", "no breakpoints or watchpoints" },
        { "tbreak insn ADDNV if count == 8", "break 1: insn ADDNV if" },
        { "info breaks", "1 break insn ADDNV if count == 8, once, hit 0" },
        { "info pages", "read and written" },
        { "info symbols", "a.words, 4 words" },
        { "x mask", "1 at mask" },
        { "x third", "             0.5               2" },
        { "x/2b mask", "10" },
        { "info operands", "[bits (r20)]: bits from" },
        { "list here, 1", "here:" },
        { "disassemble here, 2", "LODH" },
        { "help", "reverse-continue" },
    };
    check_session(text, lines, COUNT(lines), 3);
}

/* An invalid line is reported and does not change the position. */
TEST(faults)
{
    static const struct line_said lines[] = {
        { "stpe", "unknown verb 'stpe'; did you mean 'step'?" },
        { "!", "unknown verb '!'" },
        { "step 1 2", "expected the end of the line, found '2'" },
        { "step -1", "-1 is not a count" },
        { "break", "expected a label, a line" },
        { "break nowhere", "unknown name 'nowhere'" },
        { "break 1000", "has no code at line 1000" },
        { "break other.s:3", "other.s has no code at line 3" },
        { "break here if", "expected a value" },
        { "break here when 3", "expected the end of the line, found 'when 3'" },
        { "break insn ADD", "unknown instruction 'ADD'" },
        { "break region none", "unknown region 'none'" },
        { "watch *8000000000", "no memory words at" },
        { "watch mask, 65", "a watchpoint must cover between 1 and 64 words" },
        { "delete 3", "unknown breakpoint or watchpoint 3" },
        { "print", "expected a value" },
        { "print (1", "expected ')'" },
        { "print [mask", "expected ']'" },
        { "print 1 / 0", "division by zero" },
        { "print 1z", "'1z' is not a number" },
        { "print X'12G'", "expected up to 16 hex digits" },
        { "print [1]", "no memory word at 1" },
        { "x/3q mask", "expected a count, f, i, x, h or b after /" },
        { "x mask ? 3", "expected the register of a control vector" },
        { "x/4 8000000000", "not all of this memory is mapped" },
        { "info colours", "expected registers, operands" },
        { "set count", "expected REGISTER = VALUE" },
        { "set 3 = 4", "expected REGISTER = VALUE" },
        { "set [1] = 4", "no memory word at 1" },
        { "set r0 = 4", "register 0 cannot be changed" },
        { "set r9 = 140737488355328", "does not fit in the 48 bits of an integer" },
        { "set r9 = 1e400", "is too large" },
        { "p 99999999999999999999", "is too large" },
        { "x/100000000 mask", "the count must be at most 65535" },
        { "disassemble , 100001", "at most 100000 instructions are shown" },
        { "why", "no instruction has been executed: step first" },
        { "assert 1 == 2", "assertion failed: 1 == 2" },
        { "goto nowhere", "unknown name 'nowhere'" },
        { "until *1.5", "1.5 is not an address" },
    };
    enum { LINES = COUNT(lines) };
    FREED_BY(session_end) struct debug_session session;

    session_begin(&session, good(text), "-");
    session_check(&session, lines, LINES);
    assert_int_equal(debugger_faults(session.debugger), LINES);
    assert_int_equal(c205_history_step(session.debugger->history), 0);
    assert_int_equal(session.debugger->breakpoint_count, 0);
    assert_false(debugger_obey(session.debugger, "quit"));
}

/* ---- Sessions ------------------------------------------------------------- */

#define ONE_NUMBER "        ES  r10, 5\n        EXIT r10, r0, 2\n        EXIT\n"

enum { MAX_LINES = 20 };

static const struct {
    const char *program;
    struct line_said lines[MAX_LINES];
    size_t faults;
} sessions[] = {
    /* Output of the program is printed once, however often it is executed again. */
    { "        ES  r10, 5\n"
      "        EXIT r10, r0, 2\n"
      "        EXIT r0, r0, 5\n"
      "        ES  r10, 6\n"
      "        EXIT\n",
      { { "step 3", "5\n" },
        { "goto 0", "" },
        { "step 4", "!5\n" },
        { "", "ended with status 0" } },
      0 },
    /* A report first ends an incomplete line of the program's output, once. */
    { ONE_NUMBER, { { "step 2", "5\nstep " }, { "account", "!\n\n" } }, 0 },
    { ONE_NUMBER, { { "continue", "5\nstep " }, { "account", "!\n\n" } }, 0 },
    { ONE_NUMBER, { { "goto 2", "5\nstep " }, { "account", "!\n\n" } }, 0 },
    /* `next` executes a call as one instruction. A breakpoint at an instruction of a
     * linked pair moves to its LINKV. */
    { "        .include \"vectors.s\"\n"
      "        .regs r16, a, link\n"
      "        .code\n"
      "        EX   r20, routine\n"
      "        ES   r22, 3\n"
      "        BSAVE link, [r20]\n"
      "        words a, 1.0, 2.0, 3.0, 4.0\n"
      "linked: LINKV\n"
      "first:  MPYSV [a], [a], [a]\n"
      "second: ADDNV [a], [a], [a]\n"
      "        EXIT\n"
      "routine: ES  r21, 1\n"
      "        ES   r21, 2\n"
      "        BIM  0, link\n",
      { { "next 2", "BSAVE" },
        { "next", "=> 400080" },
        { "print step", "6" },
        { "break first", "break 1" },
        { "break second", "break 2" },
        { "run", "break 1: first" },
        { "print pc == linked", "1" },
        { "delete 1", "" },
        { "run", "break 2: second" },
        { "print pc == linked", "1" },
        { "step", "EXIT" } },
      0 },
    /* The branch of a loop is not a call: `next` follows the branch. */
    { "        .regs r16, turns, to, count\n"
      "        ES   turns, 3\n"
      "        EX   to, again\n"
      "again:  DBNZ turns, [to]\n"
      "        EXIT\n",
      { { "next 2", "DBNZ" },
        { "next", "=> 400060" },
        { "print step", "3" },
        { "break again if [turns * 0] == 1 / (turns - turns)", "break 1" },
        { "delete", "" },
        { "break again if turns ==", "expected a value" } },
      1 },
    /* A program that has ended does not continue, whatever the command is. */
    { "        ES  r10, 5\n"
      "        ES  r11, 6\n"
      "        DIVS r10, r11, r12\n"
      "        EXIT\n",
      { { "run", "ended with status 0" },
        { "step", "ended with status 0" },
        { "rs 0", "ended with status 0" },
        { "goto 4", "ended with status 0" },
        { "c", "ended with status 0" },
        { "until *0x400000", "ended with status 0" },
        { "goto clock 100000", "ended with status 0" },
        { "set r10 = 3", "go back first" },
        { "why", "and until all work in flight was finished" },
        { "why", "operand wait" } },
      1 },
    /* A run whose state was changed prints its own output. */
    { ONE_NUMBER,
      { { "run", "5\n" }, { "goto 1", "" }, { "set r10 = 77", "" }, { "c", "77\n" } },
      0 },
    /* Breakpoints at lines. At a macro call, the breakpoint is at the macro's first
     * instruction. At a line in a macro, it is at each call of the macro. At data, it
     * is at the next code. All breakpoints at the same step are reported. */
    { "        .data\n"
      "datum:  .word 1.0\n"
      "        .macro twice r\n"
      "        ADDX \\r, r9, \\r\n"
      "        ADDX \\r, r9, \\r\n"
      "        .endm\n"
      "        .code\n"
      "        ES   r9, 1\n"
      "        ES   r10, 5\n"
      "        ES   r11, 5\n"
      "        twice r10\n"
      "        twice r11\n"
      "here:   DIVS r10, r11, r12\n"
      "        EXIT\n",
      { { "break 9", "break 1: 9" },
        { "break 11", "break 2: 11" },
        { "break test.s:4", "break 3: test.s:4" },
        { "run", "break 1: 9" },
        { "print $step", "1" },
        { "c", "break 2: 11\nbreak 3: test.s:4" },
        { "print $step", "3" },
        { "c", "break 3: test.s:4" },
        { "print $step", "5" },
        { "delete", "" },
        { "tbreak insn DIVS", "break 4" },
        { "tbreak here", "break 5" },
        { "run", "break 4: insn DIVS\nbreak 5: here" },
        { "info breaks", "no breakpoints or watchpoints" },
        { "tbreak *here", "break 6" },
        { "goto 0", "" },
        { "c 2", "ended" },
        { "info breaks", "no breakpoints or watchpoints" } },
      0 },
    /* An endless program does not block a script. */
    { "        .include \"vectors.s\"\n"
      "        .data\n"
      "v:      .space 65000\n"
      "        .code\n"
      "        descriptor r10, v, 65000\n"
      "loop:   DIVSV [r10], [r10], [r10]\n"
      "        BIM loop\n",
      { { "c", "stopped after 1000000000 clocks" } },
      0 },
};

TEST(sessions)
{
    for (size_t i = 0; i < COUNT(sessions); i++) {
        size_t count = 0;
        while (count < MAX_LINES && sessions[i].lines[count].line)
            count++;
        check_session(sessions[i].program, sessions[i].lines, count,
                      sessions[i].faults);
    }
}

/* ---- Expressions --------------------------------------------------------- */

static void put_expression(const struct sink *sink, unsigned depth)
{
    static const char *const operators[] = { "+",  "-",  "*",  "/",  "%",  "&",
                                             "|",  "^",  "<<", ">>", "<",  ">",
                                             "<=", ">=", "==", "!=", "&&", "||" };
    bool brackets = below(2);
    if (depth == 0 || below(4) == 0) {
        sink_print(sink, "%" PRIu64, below(4) ? below(70) : below(INT64_MAX));
        return;
    }
    sink_put(sink, brackets ? "(" : "");
    if (below(4) == 0) {
        sink_print(sink, "%c", "-~!"[below(3)]);
    } else {
        put_expression(sink, depth - 1);
        sink_print(sink, " %s ", operators[below(COUNT(operators))]);
    }
    put_expression(sink, depth - 1);
    sink_put(sink, brackets ? ")" : "");
}

/* An expression has the value, or the error, that the assembler reports. */
TEST(expressions)
{
    struct debug_session session;
    size_t faults = 0;
    session_begin(&session, good("        EXIT\n"), "test.s");
    for (size_t i = 0; i < 2000; i++) {
        SCOPED_VALUE(text_buffer) made = { .text = NULL };
        SCOPED_VALUE(diagnostics) errors = { 0 };
        struct sink sink = text_buffer_sink(&made);
        put_expression(&sink, 4);
        SCOPED(object) *object =
            assemble_text("test.s",
                          formatted("        .equ e, %s\n        EXIT\n", made.text),
                          NULL, &errors);
        session_obey(&session, formatted("print %s", made.text));
        const char *expected = object
                                   ? formatted("%" PRId64 "  X'",
                                               object_symbol(object, "e")->value)
                                   : formatted("error: %s\n", errors.items[0].message);
        faults += !object;
        FAIL_IF(strncmp(session.said.text, expected, strlen(expected)) != 0,
                "%s: %s, not %s", made.text, session.said.text, expected);
    }
    assert_in_range(faults, 50, 1950);
    session_end(&session);
}
