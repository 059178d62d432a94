; calls.s - functions with arguments. One calls another, and one calls itself.
;
; Arguments are in f_x and f_y, and the result is in f_r. call sets f_link to
; the return address. A function saves the registers below 208 that it uses on
; the stack, and restores them. It also saves f_link if it calls functions.

        .include "print.s"
        .include "stack.s"
        .include "exp.s"

        .regs   r10, a, b, c
        .regs   r20, n, k, part, link   ; saved by binomial

        begin_stack 200

        load_constant a, 3.0
        load_constant b, 4.0
        apply_two hypotenuse, a, b, c
        print_number c
        newline
        load_constant a, 0.5
        apply   sinh, a, c
        print_number c
        newline
        ES      a, 10
        ES      b, 4
        apply_two binomial, a, b, c
        print_integer c
        newline
        EXIT

; Computes sqrt(x^2 + y^2). It calls no function.
hypotenuse:
        MPYS    f_x, f_x, f_0
        MPYS    f_y, f_y, f_1
        ADDN    f_0, f_1, f_0
        SQRT    f_0, f_r
        return  f_link

; Computes (e^x - e^-x) / 2. exp may change registers from 208 on.
sinh:   push    n, 4
        RTOR    f_link, link
        apply   exp, f_x, part
        load_constant f_x, 1.0
        DIVS    f_x, part, n
        SUBN    part, n, part
        load_constant f_x, 0.5
        MPYS    part, f_x, f_r
        RTOR    link, f_link
        pop     n, 4
        return  f_link

; C(n, k) = C(n-1, k-1) + C(n-1, k) for integers; 1 if k is 0 or n.
binomial:
        ES      f_r, 1
        IBXEQ   f_y, r0, r0, binomial.edge
        IBXEQ   f_y, r0, f_x, binomial.edge
        push    n, 4
        RTOR    f_x, n
        RTOR    f_y, k
        RTOR    f_link, link
        IS      n, -1
        IS      k, -1
        apply_two binomial, n, k, part
        IS      k, 1
        apply_two binomial, n, k, f_r
        ADDX    f_r, part, f_r
        RTOR    link, f_link
        pop     n, 4
binomial.edge:
        return  f_link

; expect-print: 5
; expect-print: 0.52109530549375
; expect-print: 210
