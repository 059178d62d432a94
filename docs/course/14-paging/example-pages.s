; example-pages.s - one word in each of some pages, ten times.

        .ifndef pages
        .equ    pages, 17
        .endif
        .ifndef back
        .equ    back, 0                 ; 1: every second pass backwards
        .endif

        .data
store:  .space  pages * 65536
        .code
        .regs   r10, at, step, left, times, each_time, each_page, x
        EX      at, store
        EX      step, 64 * 65536
        ES      times, 10
        EX      each_time, time
        EX      each_page, page
time:   ES      left, pages
page:   LOD     [at], x
        ADDX    at, step, at
        DBNZ    left, [each_page]
        .if     back
        SUBX    at, step, at            ; start with the last page
        SUBX    r0, step, step          ; in the other direction
        .else
        EX      at, store
        .endif
        DBNZ    times, [each_time]
        EXIT
