; test: another limit

; The limit is near that of a test: the numbers below a limit are no new data.
        .ifdef  test_limit
        .equ    limit, test_limit + 1 + draw % (test_limit / 10 + 3)
        .else
        .equ    limit, 3 + draw % 1000
        .endif

        .warm
        .data
        .bitvector want_prime, limit
want_count:
        .space  1
