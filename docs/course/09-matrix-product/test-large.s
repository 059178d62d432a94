; test: 100 rows and 20 columns times 20 rows and 20 columns
; tolerance: c 1e-6
; goals: gold 65500, silver 75000, bronze 90000
        .equ    m, 100
        .equ    n, 20
        .equ    p, 20
        .warm
        .data

; a(i, k) = i + k, b(k, j) = j - k: their product is the sum of i j + k (j - i) - k k.
        .equ    sum_k, n * (n - 1) / 2
        .equ    sum_kk, n * (n - 1) * (2 * n - 1) / 6

a:      .rept   m * n
        .word   float(\+ % m + \+ / m)
        .endr
b:      .rept   n * p
        .word   float(\+ / n - \+ % n)
        .endr
want_c: .rept   m * p
        .word   float(n * (\+ % m) * (\+ / m) + sum_k * (\+ / m - \+ % m) - sum_kk)
        .endr
