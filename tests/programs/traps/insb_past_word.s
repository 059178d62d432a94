; A field that reaches past the end of the word.
        .include "../scalar.inc"
        fetch   left, 1.0
        fetch   right, X'0009 0000 0000 0038'
        ES      result, 5
        INSB    left, right, result
; expect-trap: bad-descriptor
; expect: result = 5
