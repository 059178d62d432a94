; The control vector of a mask may not be left out.
        .include "../string.inc"
        descriptor va, first, 100
        into_string nothing, 8
        .half   X'1600 0014', X'0014 0012' ; MASKB [va], [va], [to] ? [r0]
; expect-trap: bad-descriptor
; expect-bits: [nothing] = 11111111
