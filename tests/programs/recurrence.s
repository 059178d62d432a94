; Results and clocks are compared with those worked out by hand from the timing of
; docs/timing.md.
; Results overlap the unread part of a source: each element is computed from the one
; before it and waits until that one has passed through the pipe.
        .equ    n, 6
        .regs   r10, counted, next, one, few, further
        .data
count:  .word   1
        .space  n
        .code
        EX      counted, count          ; at 0
        ELEN    counted, n
        EX      next, count + 64
        ELEN    next, n
        ES      one, 1
        ADDXV   [counted], one, [next]  ; at 5
        EX      few, count
        ELEN    few, n - 2
        EX      further, count + 3*64
        ELEN    further, n - 2
        ADDXV   [few], [few], [further]
        EXIT
; expect: [count] = 1, 2, 3, 2, 4, 6, 4
; expect-flags: X'0000 0000 0000 0000'
; expect-warning: recurrence
; Clocks: start-up 51, page 30 + 1,000, six elements on two pipes 3, and five of them
; wait 51 each.  Then 51, of which 10 overlap the stream before, and 2 for four
; elements, one of which waits.
; expect-clocks: 5 + 51 + 1030 + 3 + 5 * 51 + 51 - 10 + 2 + 51
; expect-model: cyber205-2pipe-prior
