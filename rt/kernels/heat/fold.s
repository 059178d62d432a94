; fold.s - adds up words by halves, in both forms.
;
; Of m words, the last m / 2 are added to the first, until one is left, so the
; sum depends only on the words.
;
;       fold address, m, one, low       the word at the address = the sum of the
;                                       m words there, which change
;
; m, 1 or more, and one = 1 are registers with integers; m becomes 1. low
; changes.

        .regs   r70, fold_half, fold_upper, fold_word, fold_i

        .macro  fold address, m, one, low
        BIM     fold_whole\@
fold_halve\@:
        ADDX    \m, \one, fold_half
        SHIFTI  fold_half, -1, fold_half        ; words that remain
        SUBX    \m, fold_half, \m
        SHIFTI  fold_half, 6, fold_word
        .ifdef  SCALAR
        ADDX    \address, fold_word, fold_upper
        ES      fold_i, 0
fold_next\@:
        LOD     [\address, fold_i], \low
        LOD     [fold_upper, fold_i], fold_word
        ADDN    \low, fold_word, \low
        STO     [\address, fold_i], \low
        IBXNE   fold_i, \one, \m, fold_next\@, fold_i
        .else
        ADDLEN  \address, \m, \low
        ADDX    \low, fold_word, fold_upper
        ADDNV   [\low], [fold_upper], [\low]
        .endif
        RTOR    fold_half, \m
fold_whole\@:
        IBXNE   \m, r0, \one, fold_halve\@
        .endm
