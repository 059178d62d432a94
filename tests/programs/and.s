; AND: T := R AND S

        .include "scalar.inc"

        two     plain, AND, X'0F0F 0F0F 0F0F 0F0F', X'00FF 00FF 00FF 00FF'
; expect: [plain] = X'000F 000F 000F 000F'

        two     special, AND, X'7000 0000 0000 0001', X'8000 0000 0000 0001'
; expect: [special] = 1

        AND     left, r0, result        ; register 0 is 0
        keep    with_none
; expect: [with_none] = 0
        AND     left, right, r0
; expect: r0 = 0

        EXIT
; expect-flags: X'0000 0000 0000 0000'
