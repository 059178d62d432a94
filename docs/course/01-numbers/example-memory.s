; example-memory.s - load a number from memory and store one.

        .include "core.s"
        .regs   r10, address, x, twice

        .data
given:  .word   1.25
result: .space  1

        .code
        EX      address, given
        LOD     [address], x            ; x := the word at given
        ADDN    x, x, twice
        EX      address, result
        STO     [address], twice        ; the word at result := twice
        EXIT
; expect: [result] = 2.5
