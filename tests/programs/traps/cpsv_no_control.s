; The control vector of a compress may not be left out.
        .include "../vector.inc"
        six_words
        no_result
        .half   X'BC00 0014', X'0000 0012' ; CPSV [va], [to] ? [r0]
; expect-trap: bad-descriptor
