; stride.s - adds every STRIDE-th element of a vector in two ways.
;
; With a control vector all elements stream, STRIDE elements for each useful
; one.  With an index list the useful elements are gathered and then added
; without gaps.  FORTRAN for this machine used the first way for a stride of 2
; and the second way from 3 on.  With one pipe, where an addition takes a clock
; per element, this implies
;
;       2 < 1 + g   and   3 > 1 + g,   g = clocks of a gathered element.

        .ifndef STRIDE
        .equ    STRIDE, 2
        .endif
        .equ    COUNT, 10000
        .equ    SPAN, COUNT * STRIDE

        .data
numbers:        .space SPAN
results:        .space SPAN
packed:         .space COUNT
places:         .space COUNT
        .bitvector which, SPAN
        .code

        .regs   r10, numbers_at, results_at, packed_at, places_at, which_at
        .regs   r15, step, flags, table, first

        EX      places_at, places
        ELEN    places_at, COUNT
        ES      step, STRIDE
        INTVLV  r0, step, [places_at]
        EX      which_at, which
        ELEN    which_at, SPAN
        EX      numbers_at, numbers
        ELEN    numbers_at, SPAN
        EX      results_at, results
        ELEN    results_at, SPAN
        EX      packed_at, packed
        ELEN    packed_at, COUNT
        EX      table, numbers
        EX      first, bits(1.0) & 0xFFFFFFFFFFFF
        ELEN    first, bits(1.0) >> 48 & 0xFFFF
        VTOVX   [places_at], first, [table]
        CMPNEV  [numbers_at], r0, [which_at]

        .kernel control
        ADDNV   [numbers_at], [numbers_at], [results_at] ? [which_at]
        .endkernel
        STO     [table], first          ; waits until the addition has ended
        .kernel gather
        VXTOV   [places_at], [table], [packed_at]
        ADDNV   [packed_at], [packed_at], [packed_at]
        .endkernel
        EXIT
; expect: [results] = 2.0
; expect: [results + 64 * STRIDE] = 2.0
; expect: [packed] = 2.0, 2.0
