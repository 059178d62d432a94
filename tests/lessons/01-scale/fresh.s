; test: other numbers of elements
        .ifdef  test_n
        .equ    n, test_n
        .else
        .equ    n, 2 + draw % 500
        .endif
        .warm
        .data
x:
        .rept   n
        .word   float((\+ * 7919 + draw * 104729) % 2003) - 0.5
        .endr
want_y: .space  n
want_above:
        .space  1
