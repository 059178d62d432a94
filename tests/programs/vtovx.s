; VTOVX: C(A(i)) := B(i)

        .include "vector.inc"

        .data
a:      .word   3, 0, -1, 2, 2, X'7123 0000 0000 0001'
b:      .word   30.0, 31.0, 32.0, 33.0, 34.0, 35.0
scalars:
        .word   8.0, 1
        .bitvector z, n, "101100"
        .code

        .macro  scatter_into name
        .data
\name:  .word   9.0, 9.0, 9.0, 9.0, 9.0, 9.0
        .code
        EX      to, \name + 64          ; its length does not count
        .endm

        operands_of_two
        scatter_into plain              ; of two for one place the last stays
        VTOVX   [va], [vb], [to]
        scatter_into broadcast
        VTOVX   [va], x, [to]
        scatter_into where_ones
        VTOVX   [va], [vb], [to] ? [vz]
        scatter_into where_zeros
        VTOVX   [va], [vb], [to] ?! [vz]
        scatter_into offset_source      ; the source is short by that
        VTOVX   [va], [vb, twice], [to]
        scatter_into offset_list        ; the list is short by that
        VTOVX   [va, twice], [vb], [to]
        scatter_into short_list
        VTOVX   [short_a], [vb], [to]
        scatter_into short_source       ; continued with machine zeros
        VTOVX   [va], [short_b], [to]
        ELEN    va, 0
        scatter_into nothing
        VTOVX   [va], [vb], [to]
; expect: [plain] = 32.0, 31.0, 35.0, 34.0, 30.0, 9.0
; expect: [broadcast] = 8.0, 8.0, 8.0, 8.0, 8.0, 9.0
; expect: [where_ones] = 32.0, 9.0, 9.0, 33.0, 30.0, 9.0
; expect: [where_zeros] = 9.0, 31.0, 35.0, 34.0, 9.0, 9.0
; expect: [offset_source] = 34.0, 33.0, 0.0, 0.0, 32.0, 9.0
; expect: [offset_list] = 30.0, 9.0, 33.0, 32.0, 9.0, 9.0
; expect: [short_list] = 32.0, 31.0, 9.0, 33.0, 30.0, 9.0
; expect: [short_source] = 0.0, 31.0, 0.0, 0.0, 30.0, 9.0
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0

; The source lies in the result: what has been scattered is read again.
        .data
chain:  .word   5.0, 6.0, 7.0, 8.0
next:   .word   1, 2, 3
        .code
        descriptor va, next, 3
        descriptor vb, chain, 3
        EX      to, chain
        VTOVX   [va], [vb], [to]
; expect: [chain] = 5.0, 5.0, 5.0, 5.0

; The control vector lies in the result: its later bits are the new ones.
        .data
        .bitvector own, 3, "110"
        .space  2
places: .word   0, 1, 2
values: .word   X'2000 0000 0000 0000', 5.0, 6.0
        .code
        descriptor va, places, 3
        descriptor vb, values, 3
        EX      vz, own
        EX      to, own
        VTOVX   [va], [vb], [to] ? [vz]
; expect: [own] = X'2000 0000 0000 0000', 0, 6.0

        EXIT
; expect-flags: X'0000 0000 0000 0000'
; expect-warning: zero-length
