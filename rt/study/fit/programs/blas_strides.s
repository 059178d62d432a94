; blas_strides.s - the routines of blas.inc with increments other than 1, which
; linpack.s does not use: on every second or third word of an array.

        .include "frame/linkage.s"
        .include "blas.inc"

        .data
n:              .word 3
factor:         .word 2.0
near:           .word 1
next_but:       .word 2
third_increment: .word 3
x:              .word 1.0, 0, -5.0, 0, 3.0
y:              .word 10.0, 0, 0, 20.0, 0, 0, 30.0
z:              .word 1.0, 7.0, 2.0, 7.0, 3.0
saxpy_list:     .word n, factor, x, next_but, y, third_increment
sscal_list:     .word n, factor, z, next_but
isamax_list:    .word n, x, next_but
saxpy_near:     .word n, factor, x, next_but, w, near
w:              .space 3
        .code
        .share  main
        .regs   r12, greatest
        .endshare
        .entry  strides
strides:
        call    saxpy, saxpy_list
        call    sscal, sscal_list
        call    saxpy, saxpy_near
        call    isamax, isamax_list
        RTOR    function_value, greatest
        EXIT
; expect: greatest = 2
; expect: [y] = 12.0, 0, 0, 10.0, 0, 0, 36.0
; expect: [z] = 2.0, 7.0, 4.0, 7.0, 6.0
; expect: [w] = 2.0, -10.0, 6.0
