; There is no code in page 0.
        BIM     64
; expect-trap: unmapped-address
