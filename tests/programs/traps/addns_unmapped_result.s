; A sparse addition without memory for the result: nothing is stored.
        .include "../sparse.inc"
        sparse_operands
        into_sparse nothing
        EX      to, 0x7FFFFFFFFFC0
        ADDNS   [va, vx], [vb, vy], [to], [order]
; expect-trap: unmapped-address
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
; expect: [nothing_order] = X'FFFF FFFF FFFF FFFF'
