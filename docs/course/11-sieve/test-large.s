; test: below 20,000 there are 2,262 primes
; goals: gold 13000, silver 22500, bronze 95000
        .equ    limit, 20000
        .warm
        .data
        .bitvector want_prime, 100, "0011010100 0101000101 0001000001 0100000100 0101000100 0001000001 0100000100 0101000001 0001000001 0000000100"
want_count:
        .word   2262
