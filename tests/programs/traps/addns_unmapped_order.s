; A sparse addition without memory for an order vector: nothing is stored.
        .include "../sparse.inc"
        sparse_operands
        into_sparse nothing
        EX      vy, 0x7FFFFFFFFF00
        ELEN    vy, 6
        ADDNS   [va, vx], [vb, vy], [to], [order]
; expect-trap: unmapped-address
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
; expect: [nothing_order] = X'FFFF FFFF FFFF FFFF'
