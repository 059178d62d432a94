; The control vector lies in page 0.
        .include "../vector.inc"
        six_words
        descriptor vz, 64, n
        no_result
        ADDNV   [va], [va], [to] ? [vz]
; expect-trap: unmapped-address
