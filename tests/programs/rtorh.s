; RTORH: T := R

        .include "half.inc"

        fetch   left, X'7ABC 0123'      ; all 32 bits, whatever they are
        EXH     h201, 7
        RTORH   left, h200              ; from left to left
        RTORH   h200, h203              ; to right, and the other half stays
        RTORH   h203, h205              ; from right to right
        RTORH   h205, h206              ; and to left
        RTORH   h206, h206
; expect: r100 = X'7ABC 0123 0000 0007'
; expect: r101 = X'0000 0000 7ABC 0123'
; expect: r102 = X'0000 0000 7ABC 0123'
; expect: r103 = X'7ABC 0123 0000 0000'
        RTORH   left, h0
        RTORH   left, h1
; expect: r0 = 0
        EXH     h208, 5
        EXH     h209, 5
        RTORH   h0, h208                ; as bits they are 0
        RTORH   h1, h209
; expect: r104 = 0

        EXIT
; expect-flags: X'0000 0000 0000 0000'
