; test: below 6 nothing is struck out but 4
        .equ    limit, 6
        .warm
        .data
        .bitvector want_prime, limit, "001101"
want_count:
        .word   3
