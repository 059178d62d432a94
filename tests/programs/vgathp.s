; VGATHP: C(i) := B(i x A)

        .include "vector.inc"

        .data
table0: .word   20.0, 21.0, 22.0, 23.0, X'7ABC 0123 4567 89AB', 25.0, 26.0
        .word   27.0, 28.0, 29.0, 30.0, 31.0, 32.0, 33.0, 34.0, 35.0
        .bitvector z, n, "101100"
        .regs   r40, vtable, period, vz
        .code

        ES      by, 1
        descriptor vz, z, n
        EX      vtable, table0          ; its length does not count
        ES      period, 3
        into    plain
        VGATHP  period, [vtable], [to]
        into    where_ones
        VGATHP  period, [vtable], [to] ? [vz]
        into    where_zeros
        VGATHP  period, [vtable], [to] ?! [vz]
        into    offset_result           ; and of the control vector
        VGATHP  period, [vtable], [to, by] ? [vz]
        into    short_result, 2
        VGATHP  period, [vtable], [to]
        into    again                   ; r0 is a period of 0
        VGATHP  r0, [vtable], [to]
        into    nothing, 0
        VGATHP  period, [vtable], [to]
; expect: [plain] = 20.0, 23.0, 26.0, 29.0, 32.0, 35.0
; expect: [where_ones] = 20.0, 9.0, 26.0, 29.0, 9.0, 9.0
; expect: [where_zeros] = 9.0, 23.0, 9.0, 9.0, 32.0, 35.0
; expect: [offset_result] = 9.0, 9.0, 23.0, 26.0, 9.0, 9.0
; expect: [short_result] = 20.0, 23.0, 9.0, 9.0, 9.0, 9.0
; expect: [again] = 20.0, 20.0, 20.0, 20.0, 20.0, 20.0
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0

; Backwards; of the period 48 bits count.
        .data
back:   .word   X'1234 FFFF FFFF FFFE'
        .code
        EX      place, back
        LOD     [place], period
        EX      vtable, table0 + 64*14
        into    backwards
        VGATHP  period, [vtable], [to]
; expect: [backwards] = 34.0, 32.0, 30.0, 28.0, 26.0, X'7ABC 0123 4567 89AB'

; The result lies over the table: what has been stored is gathered again.
        .data
chain:  .word   5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 11.0
        .code
        ES      period, 2
        EX      vtable, chain
        descriptor to, chain + 64, 4
        VGATHP  period, [vtable], [to]
; expect: [chain] = 5.0, 5.0, 7.0, 9.0, 11.0, 10.0, 11.0

        EXIT
; expect-flags: X'0000 0000 0000 0000'
; expect-warning: zero-length
