; test: 122 is the last number, 121 is the square of 11
        .equ    limit, 123
        .warm
        .data
        .bitvector want_prime, limit, "0011010100 0101000101 0001000001 0100000100 0101000100 0001000001 0100000100 0101000001 0001000001 0000000100 0101000101 0001000000 000"
want_count:
        .word   30
