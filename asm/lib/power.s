; power.s - power and vpower: f_r = f_x ^ f_y.
;
;   x^y = e^(y ln x)
;
; by the formulas of log.s and exp.s.  0 to a power above 0 is machine zero; else of what is
; not above 0, and of indefinite, the result is indefinite.
; Source: textbook.

        .ifndef power

        .include "exp.s"
        .include "log.s"

        .macro  power_formula form, x, y, r, s
        \form\()_normal \y, f_9
        \form\()_normal \x, f_8
        log_formula \form, f_8, f_8, f_7, f_7
        \form\()_times f_7, f_9, f_7
        exp_formula \form, f_7, f_7, \r, \r
        \form\()_clear f_6
        \form\()_if_equal_number f_8, r0, power_zero\@
        \form\()_then_copy f_9, f_6
        \form\()_end_if power_zero\@
        \form\()_if_above_number f_6, r0, power_none\@
        \form\()_then_clear \r
        \form\()_end_if power_none\@
        .endm

        routines power, power_formula

        .endif
