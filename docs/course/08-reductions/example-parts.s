; example-parts.s - a sum of which a register alone would lose a part.

        .include "print.s"
        .regs   r16, total, lower
        .regs   r20, v, i, one, count, sum, element, text
        .data
        .vector xs, 4, 1e15, 1.0, -1e15, 0.5
        .code
        descriptor v, xs, 4
        SUMV    [v], total
        join_parts total, lower, total
        print_text "SUMV: ", text
        print_number total
        newline

        ES      i, 0
        ES      one, 1
        ES      count, 4
        ES      sum, 0
next:   LOD     [v, i], element
        ADDN    sum, element, sum
        IBXLT   i, one, count, next, i
        print_text "one ADDN after another: ", text
        print_number sum
        newline
        EXIT
; expect: total = 1.5
; expect-print: SUMV: 1.5
; expect-print: one ADDN after another: 0.5
