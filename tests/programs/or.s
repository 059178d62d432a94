; OR: T := R OR S

        .include "scalar.inc"

        two     plain, OR, X'0F0F 0F0F 0F0F 0F0F', X'00FF 00FF 00FF 00FF'
; expect: [plain] = X'0FFF 0FFF 0FFF 0FFF'

        two     special, OR, X'7000 0000 0000 0001', X'8000 0000 0000 0001'
; expect: [special] = X'F000 0000 0000 0001'

        OR      left, r0, result        ; register 0 is 0
        keep    with_none
; expect: [with_none] = X'7000 0000 0000 0001'
        OR      left, right, r0
; expect: r0 = 0

        EXIT
; expect-flags: X'0000 0000 0000 0000'
