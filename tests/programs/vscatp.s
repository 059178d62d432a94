; VSCATP: C(i x A) := B(i)

        .include "vector.inc"

        .data
b:      .word   30.0, 31.0, 32.0, 33.0, X'7ABC 0123 4567 89AB', 35.0
        .bitvector z, n, "101100"
        .regs   r40, period, vz, twice
        .code

        .macro  scatter_into name, first = 0
        .data
\name:  .word   9.0, 9.0, 9.0, 9.0, 9.0, 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
        .code
        EX      to, \name + 64*\first   ; its length does not count
        .endm

        descriptor vb, b, n
        descriptor vz, z, n
        ES      period, 2
        ES      twice, 2
        scatter_into plain
        VSCATP  period, [vb], [to]
        scatter_into where_ones
        VSCATP  period, [vb], [to] ? [vz]
        scatter_into where_zeros
        VSCATP  period, [vb], [to] ?! [vz]
        scatter_into offset_source      ; the source is short by that
        VSCATP  period, [vb, twice], [to]
        scatter_into again              ; of all for one place the last stays
        VSCATP  r0, [vb], [to]
        ES      period, -1
        scatter_into backwards, 8
        VSCATP  period, [vb], [to]
        ELEN    vb, 0
        scatter_into nothing
        VSCATP  period, [vb], [to]
; expect: [plain] = 30.0, 9.0, 31.0, 9.0, 32.0, 9.0, 33.0, 9.0
; expect: [plain + 64*8] = X'7ABC 0123 4567 89AB', 9.0, 35.0
; expect: [where_ones] = 30.0, 9.0, 9.0, 9.0, 32.0, 9.0, 33.0, 9.0, 9.0, 9.0
; expect: [where_zeros] = 9.0, 9.0, 31.0, 9.0, 9.0, 9.0, 9.0, 9.0
; expect: [where_zeros + 64*8] = X'7ABC 0123 4567 89AB', 9.0, 35.0
; expect: [offset_source] = 32.0, 9.0, 33.0, 9.0, X'7ABC 0123 4567 89AB', 9.0
; expect: [offset_source + 64*6] = 35.0, 9.0, 9.0, 9.0, 9.0
; expect: [again] = 35.0, 9.0, 9.0
; expect: [backwards] = 9.0, 9.0, 9.0, 35.0, X'7ABC 0123 4567 89AB'
; expect: [backwards + 64*5] = 33.0, 32.0, 31.0, 30.0, 9.0, 9.0
; expect: [nothing] = 9.0, 9.0, 9.0

; The source lies in the result: what has been scattered is read again.
        .data
chain:  .word   5.0, 6.0, 7.0, 8.0, 9.0, 10.0
        .code
        descriptor vb, chain, 3
        EX      to, chain + 64
        ES      period, 1
        VSCATP  period, [vb], [to]
; expect: [chain] = 5.0, 5.0, 5.0, 5.0, 9.0, 10.0

        EXIT
; expect-flags: X'0000 0000 0000 0000'
; expect-warning: zero-length
