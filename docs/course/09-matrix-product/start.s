; start.s - c := a b for matrices that are stored by columns.

        .include "core.s"

        .ifndef m                       ; the tests define it
        .equ    m, 3                    ; rows of a and c
        .equ    n, 2                    ; columns of a, rows of b
        .equ    p, 2                    ; columns of b and c
        .endif

        .data
a:      .rept   m * n                   ; column after column: 1, 2, 3; 4, 5, 6
        .word   1.0 + \+
        .endr
b:      .rept   n * p                   ; 10, 7; 4, 1
        .word   10.0 - \+ * 3
        .endr
c:      .space  m * p
        .code

        .regs   r10, one, word, column

        ES      one, 1
        ES      word, 64                ; bits of a word
        EX      column, 64 * m          ; bits of a column of a or c

        .kernel product
; your code here
        .endkernel
        EXIT
; expect: [c] = 38.0, 55.0, 72.0
; expect: [c + 64 * m] = 8.0, 13.0, 18.0
