; test: below 6 only 4 is struck out
        .equ    limit, 6
        .warm
        .data
        .bitvector want_prime, limit, "001101"
want_count:
        .word   3
