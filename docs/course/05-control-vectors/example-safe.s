; example-safe.s - quotients, but not where the divisor is zero.

        .include "print.s"

        .equ    n, 4

        .data
        .vector way, n, 10.0, 20.0, 30.0, 40.0
        .vector time, n, 2.0, 0.0, 4.0, 0.0
        .vector speed, n
        .bitvector moving, n
        .code

        .regs   r10, ways, times, speeds, zs, flags

        descriptor ways, way, n
        descriptor times, time, n
        descriptor speeds, speed, n
        descriptor zs, moving, n

        CMPNEV  [times], r0, [zs]
        DIVSV   [ways], [times], [speeds] ? [zs]
        print_vector speeds
        newline
        LSDFR   r0, flags               ; what the arithmetic has to report
        print_hex flags
        newline
        DIVSV   [ways], [times], [speeds]
        print_vector speeds
        newline
        LSDFR   r0, flags
        print_hex flags
        newline
        EXIT
; expect-print: 5 0 7.5 0
; expect-print: 0000 0000 0000 0000
; expect-print: 5 indefinite 7.5 indefinite
; expect-print: 0000 0000 0042 0000
