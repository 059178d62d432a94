; pieces.s - selects a random piece of a surface with one table access.
;
; Piece i of the T pieces has the probability p_i:
;
;   i = floor (T u),  then i = alias_i if T u - i is not below share_i
;
; The table has columns of T words: share, alias, and the kernel's words.
;
; In:  draw4: u; emission_pieces: T, a number; emission_table: its address.
; Out: piece0 .., the words of the piece; toil0 .. toil3 are scratch.
; Source: A. J. Walker, "An efficient method for generating discrete random
; variables with general distributions" (1977).

        .macro  piece_word into
        gather  temp1, piece_at, \into
        ADDX    piece_at, piece_stride, piece_at
        .endm

        .macro  pick_piece count
        RTOR    emission_table, piece_at
        scale   draw4, emission_pieces, temp0
        floor   temp0, temp1
        minus   temp0, temp1, temp0
        piece_word temp2
        piece_word temp3
        if_not_less temp0, temp2, choose\@
        then_copy temp3, temp1
        end_if  choose\@
        .rept   \count
        piece_word piece\+
        .endr
        .endm
