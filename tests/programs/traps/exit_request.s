; The monitor knows no request 200.
        EXIT    r0, r0, 200
; expect-trap: bad-request
