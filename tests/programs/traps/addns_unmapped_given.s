; A sparse addition with an order vector of the result that is not there.
        .include "../sparse.inc"
        sparse_operands
        into_sparse nothing
        EX      vz, 0x7FFFFFFFFF00
        ELEN    vz, 6
        ADDNS   [va, vx], [vb, vy], [to] ? [vz]
; expect-trap: unmapped-address
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
