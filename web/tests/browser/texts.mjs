// texts.mjs - programs that several tests use.

export const PRINTS = `        .include "print.s"
        .reg    x, r16
        ES      x, 42
        print_integer x
        newline
        EXIT
`;

export const LOOP = `        .reg    i, r16
        ES      i, 0
loop:   IS      i, 1
        BIM     loop
`;

/** A loop that computes a sum in 10 iterations. */
export const SUM = `        .regs   r16, i, one, count, sum
        ES      i, 0
        ES      one, 1
        ES      count, 10
        ES      sum, 0
loop:   ADDX    sum, i, sum
        IBXLT   i, one, count, loop, i
        EXIT
`;
export const SUM_LOOP = 6; // line of the first instruction in the loop

export const WRONG = `        .reg    x, r16
        ADNV    x, x, x
        ES      y, 1
        EXIT
`;

/** A loop of n iterations without floating-point arithmetic. */
export const COUNTS = `        .include "core.s"
        .ifndef n
        .equ    n, 10
        .endif
        .regs   r16, i, one, most
        ES      i, 0
        ES      one, 1
        EX      most, n
again:  IBXLT   i, one, most, again, i
        EXIT
`;

/** Prints TEXT 20,000 times. */
export const PRINTS_MUCH = `        .include "print.s"
        .regs   r16, i, one, most, text
        ES      i, 0
        ES      one, 1
        EX      most, 20000
again:  print_text "TEXT", text
        IBXLT   i, one, most, again, i
        EXIT
`;
