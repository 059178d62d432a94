; VXTOV: C(i) := B(A(i))

        .include "vector.inc"

        .data
a:      .word   3, 0, -1, 2, 2, X'7123 0000 0000 0001'
table0: .word   X'7ABC 0123 4567 89AB'
table:  .word   20.0, 21.0, 22.0, 23.0
scalars:
        .word   1, 1
        .bitvector z, n, "101100"
        .regs   r40, vtable
        .code

        operands
        EX      vtable, table           ; its length does not count
        into    plain
        VXTOV   [va], [vtable], [to]
        into    where_ones
        VXTOV   [va], [vtable], [to] ? [vz]
        into    where_zeros
        VXTOV   [va], [vtable], [to] ?! [vz]
        into    offset_result           ; and of the control vector
        VXTOV   [va], [vtable], [to, by] ? [vz]
        into    short_list              ; as many as there are indices
        VXTOV   [short_a], [vtable], [to]
        into    short_result, 2
        VXTOV   [va], [vtable], [to]
        into    nothing, 0
        VXTOV   [va], [vtable], [to]
        into    offset_list             ; the list is short by that
        VXTOV   [va, twice], [vtable], [to]
; expect: [offset_list] = X'7ABC 0123 4567 89AB', 22.0, 22.0, 21.0, 9.0, 9.0
; expect: [plain] = 23.0, 20.0, X'7ABC 0123 4567 89AB', 22.0, 22.0, 21.0
; expect: [where_ones] = 23.0, 9.0, X'7ABC 0123 4567 89AB', 22.0, 9.0, 9.0
; expect: [where_zeros] = 9.0, 20.0, 9.0, 9.0, 22.0, 21.0
; expect: [offset_result] = 9.0, 9.0, 20.0, X'7ABC 0123 4567 89AB', 9.0, 9.0
; expect: [short_list] = 23.0, 20.0, X'7ABC 0123 4567 89AB', 22.0, 9.0, 9.0
; expect: [short_result] = 23.0, 20.0, 9.0, 9.0, 9.0, 9.0
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0

; The result lies over the table: what has been stored is gathered again.
        .data
chain:  .word   5.0, 6.0, 7.0, 8.0
next:   .word   1, 2, 0
        .code
        descriptor va, next, 3
        EX      vtable, chain
        descriptor to, chain, 3
        VXTOV   [va], [vtable], [to]
; expect: [chain] = 6.0, 7.0, 6.0, 8.0

        EXIT
; expect-flags: X'0000 0000 0000 0000'
; expect-warning: zero-length
