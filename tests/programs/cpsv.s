; CPSV: C := those A where Z has ones; length of C := their number

        .include "vector.inc"

        .regs   r40, ones, zeros, empty, moved, scalar, zero_bits
        .regs   r48, short, in_place, room

        .data
a:      .word   1.0, 2.0, X'7ABC 0123 4567 89AB', 4.0, 5.0, 6.0
scalars:
        .word   8.0, -0.5
        .bitvector second, n, "010000"
        .bitvector z, n, "101100"
        .bitvector none, n, "000000"
        .code

        operands
        into    plain, 0                ; the length is that of Z
        CPSV    [va], [to] ? [vz]
        LTOR    to, ones
; expect: [plain] = 1.0, X'7ABC 0123 4567 89AB', 4.0, 9.0, 9.0, 9.0
; expect: r40 = 3

        into    where_zeros, 2          ; that of C is not looked at
        CPSV    [va], [to] ?! [vz]
        LTOR    to, zeros
; expect: [where_zeros] = 2.0, 5.0, 6.0, 9.0, 9.0, 9.0
; expect: r41 = 3

        into    broadcast
        CPSV    x, [to] ? [vz]
        LTOR    to, scalar
; expect: [broadcast] = 8.0, 8.0, 8.0, 9.0, 9.0, 9.0
; expect: r44 = 3

        into    offset_source
        CPSV    [va, twice], [to] ? [vz]
; expect: [offset_source] = X'7ABC 0123 4567 89AB', 5.0, 6.0, 9.0, 9.0, 9.0

        into    short_source            ; continued with machine zeros
        CPSV    [short_a], [to] ?! [vz]
        LTOR    to, short
; expect: [short_source] = 2.0, 0.0, 0.0, 9.0, 9.0, 9.0
; expect: r48 = 3

; no ones: the address of C stays, its length is 0
        descriptor vz, none, n
        into    nothing
        CPSV    [va], [to] ? [vz]
        LTOR    to, empty
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
; expect: r42 = 0

; an empty Z
        descriptor vz, z, 0
        CPSV    [va], [to] ? [vz]
        LTOR    to, zero_bits
; expect: r45 = 0

; in place
        descriptor vz, z, n
        .data
place0: .word   1.0, 2.0, 3.0, 4.0, 5.0, 6.0
        .code
        descriptor to, place0, n
        descriptor from, place0, n
        CPSV    [from], [to] ? [vz]
        LTOR    to, in_place
; expect: [place0] = 1.0, 3.0, 4.0, 4.0, 5.0, 6.0
; expect: r49 = 3

; room for those that are kept is enough: C is the last word of its page
        .data
        .org    0xBFFFC0
edge:   .word   0
        .code
        EX      to, edge
        descriptor vz, second, n
        CPSV    [va], [to] ? [vz]
; expect: [edge] = 2.0

        EXIT
; expect-flags: X'0000 0000 0000 0000'
