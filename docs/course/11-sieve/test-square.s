; test: 25 is the last number, and struck out by 5 alone
        .equ    limit, 26
        .warm
        .data
        .bitvector want_prime, limit, "0011010100 0101000101 000100"
want_count:
        .word   9
