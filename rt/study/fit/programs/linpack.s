; linpack.s - the LINPACK benchmark: SGEFA and SGESL solve a system of ORDER
; equations (default 100) and call the BLAS (sgefa.inc, blas.inc).
;
; The matrix is that of the published program: J := 3125 J mod 65536 from 1325,
; A := (J - 32768) / 16384, column by column, in an array of LDA = 201 rows.  B
; is the sum of the columns, so the solution consists of ones.  The figure of
; the benchmark is the time of both routines, which are the named regions, for
; 2/3 n^3 + 2 n^2 operations.  The solution is checked by the residual
;
;       max |A x - b| / (n max |A| max |x| eps),  eps = 2^-46
;
; which must be below n (32 for n = 100).  A machine that rounds has a residual
; of a few units; this machine truncates all sums in the same direction.
; Published for the CYBER 205 with two pipes: 17 Mflop/s; 113 Mflop/s for
; ORDER = 1000, where the rules allow the program to be rewritten.
; Source: Dongarra, Performance of Various Computers Using Standard Linear
; Equations Software in a FORTRAN Environment (1983 and later).

        .include "frame/linkage.s"
        .include "blas.inc"
        .include "sgefa.inc"

        .ifndef ORDER
        .equ    ORDER, 100
        .equ    LDA, 201
        .endif
        .ifndef LDA
        .equ    LDA, ORDER + 1
        .endif
        .equ    MATRIX, LDA * ORDER
; Floating-point operations of the routines; ALLOWED = 2^-46.
        .equ    FLOPS, (2 * ORDER * ORDER * ORDER + 6 * ORDER * ORDER) / 3
        .equ    ALLOWED, 1.42e-14

        .data
a:              .space MATRIX
b:              .space ORDER
x:              .space ORDER
ipvt:           .space ORDER
info:           .word 0
order:          .word ORDER
lda:            .word LDA
sgefa_list:     .word a, lda, order, ipvt, info
sgesl_list:     .word a, lda, order, ipvt, x
unit:           .word 1.0
figure_text:    .text " Mflop/s\n"
        .code

        .share  main
        .regs   r12, seed, step, mask, half, scale, number
        .regs   r18, at, next, rows, columns, minus, factor, back
        .regs   r25, begun, ended, clocks, failed
        .endshare
        .regs   r160, residual, residual_at, norm_a, norm_a_at, norm_x
        .regs   r165, norm_x_at, allowed, vector, solution, column, sum, linked

        .macro  number register, value
        EX      \register, bits(\value) & 0xFFFFFFFFFFFF
        ELEN    \register, bits(\value) >> 48 & 0xFFFF
        .endm

        .macro  vector register, address, length
        EX      \register, \address
        ELEN    \register, \length
        .endm

; B := B + the sum over the columns A(.,J) of A(.,J) F(J).  F(J + 1) is step
; words after F(J).
        .macro  add_columns first, step
        EX      factor, \first
        vector  column, a, ORDER
        vector  sum, b, ORDER
        RTOR    sum, linked
        ES      columns, ORDER
next\@:
        LOD     [factor], number
        LINKV
        MPYSV   [column], number, [linked]
        ADDNV   [linked], [sum], [sum]
        IX      factor, 64 * \step
        IX      column, 64 * LDA
        IBXNE   columns, minus, r0, next\@, columns
        .endm

; norm: the greatest magnitude of a vector; norm_of_matrix: that of the matrix.
        .macro  norm result, address, length
        vector  vector, \address, \length
        MAXV    |[vector]|, r0, \result
        .endm

        .macro  norm_of_matrix result
        vector  column, a, ORDER
        ES      columns, ORDER
        MAXV    |[column]|, r0, \result
next\@:
        MAXV    |[column]|, r0, number
        CFPLE   number, \result, less\@
        RTOR    number, \result
less\@:
        IX      column, 64 * LDA
        IBXNE   columns, minus, r0, next\@, columns
        .endm

        .entry  linpack
linpack:
        ES      minus, -1
        EX      target, generate
        BSAVE   back, [target]
        add_columns unit, 0
        vector  solution, x, ORDER
        vector  vector, b, ORDER
        VTOV    [vector], [solution]

        CLOCK   begun
        call    sgefa, sgefa_list
        call    sgesl, sgesl_list
        CLOCK   ended

        EX      target, generate
        BSAVE   back, [target]
        add_columns unit, 0             ; B, then A x - B
        vector  vector, b, ORDER
        VTOV    -[vector], [vector]
        add_columns x, 1
        norm    residual, b, ORDER
        norm_of_matrix norm_a
        norm    norm_x, x, ORDER

        EX      allowed, ORDER
        ADDN    allowed, r0, allowed
        number  number, ALLOWED
        MPYS    allowed, allowed, allowed
        MPYS    allowed, number, allowed
        MPYS    allowed, norm_a, allowed
        MPYS    allowed, norm_x, allowed
        ES      failed, 0
        CFPLT   residual, allowed, solved
        ES      failed, 1
solved:
        SUBX    ended, begun, clocks    ; unit 20 ns: rate = FLOPS 50 / clocks
        ADDN    clocks, r0, clocks
        EX      number, FLOPS * 50
        ADDN    number, r0, number
        DIVS    number, clocks, number
        EXIT    number, r0, 1
        vector  vector, figure_text, length(" Mflop/s\n")
        EXIT    vector, r0, 4
        EXIT    failed

; Generates A and sets B to 0.
generate:
        ES      seed, 1325
        ES      step, 3125
        EX      mask, 65535
        number  half, 32768.0
        number  scale, 6.103515625e-5   ; 1/16384
        EX      next, a
        ES      columns, ORDER
generate_column:
        RTOR    next, at
        ES      rows, ORDER
generate_row:
        MPYX    seed, step, seed
        AND     seed, mask, seed
        SUBN    seed, half, number
        MPYS    number, scale, number
        STO     [at], number
        IX      at, 64
        IBXNE   rows, minus, r0, generate_row, rows
        IX      next, 64 * LDA
        IBXNE   columns, minus, r0, generate_column, columns
        vector  vector, b, ORDER
        VTOV    r0, [vector]
        BIM     0, back
; expect: failed = 0
