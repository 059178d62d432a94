; test: below 3 there is one prime
        .equ    limit, 3
        .warm
        .data
        .bitvector want_prime, limit, "001"
want_count:
        .word   1
