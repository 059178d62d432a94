; pieces.s - which piece of a surface a point lies on: one of T, the i-th with the
; probability p_i, by one look into a table.
;
;   i = floor (T u),  i = alias_i where T u - i is not below share_i
;
; The table has columns T words long: share, alias, and what the kernel wants of a
; piece.
;
; In:  draw4: u; emission_pieces: T, a number; emission_table: its address.
; Out: piece0 .., the words of the piece; toil0 .. toil3 are scratch.
; Source: A. J. Walker, "An efficient method for generating discrete random variables
; with general distributions" (1977).

        .macro  piece_word into
        each_pick toil1, piece_at, \into
        ADDX    piece_at, piece_stride, piece_at
        .endm

        .macro  pick_piece count
        RTOR    emission_table, piece_at
        each_scale draw4, emission_pieces, toil0
        each_floor toil0, toil1
        each_minus toil0, toil1, toil0
        piece_word toil2
        piece_word toil3
        each_choose toil0, toil2, toil1, toil3
        .rept   \count
        piece_word piece\+
        .endr
        .endm
