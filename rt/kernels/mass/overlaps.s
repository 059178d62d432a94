; overlaps.s - the volumes in which parts overlap, pair by pair.
;
; A ray enters a part with the first of its objects and leaves it with the last.
; Level l of a part is on while the ray is in at least LEVEL_MIN of the part's
; objects. A pair of levels is on while both are on. A pair of the first levels
; of two parts measures their overlap. Level 2 of one part, paired with itself,
; measures the overlap of the part's own objects. Where a pair turns on at s0
; and off at s1, its volume grows:
;
;   V += a (s1 - s0)
;
; So each crossing where it changes adds w s, with w = -1 where it turns on and
; 1 where it turns off. a is the area of a ray.
;
; The numbers of objects that contain the ray are fields of words. Part i has
; the field at bit f of group g. The width of a field follows from the number of
; objects. A group has 47 bits. An entry adds 2^f and an exit subtracts it. No
; field becomes negative or overflows, so one addition counts for all parts of
; the group. After a ray all counts are 0 again, so the sums over all crossings
; from the first on equal those over the ray's own crossings.
;
; In:  the words of crossed.s, with a sum for each pair, and below.
; Out: crossed_sums, one sum for each pair.
; Source: derived here.

        .include "mass/crossed.s"

        .record GROUP                   ; parts whose fields share a word
        .field  GROUP_STEPS             ; address of 2^f of each part, integers;
                                        ; 0: the part is in another group
        .field  GROUP_LEVELS            ; number of levels of its parts
        .endrecord

        .record LEVEL                   ; in the order of groups
        .field  LEVEL_MASK              ; the part's field
        .field  LEVEL_REACHED           ; LEVEL_MIN in the field
        .field  LEVEL_MIN             ; number of objects
        .field  LEVEL_ON                ; 1: it is on; scalar form from here on
        .field  LEVEL_PARTNERS          ; address of its pairs
        .field  LEVEL_PAIRS             ; number of its pairs
        .endrecord

        .record PAIR
        .field  PAIR_LEVELS, 2          ; numbers of levels, from 0
        .endrecord

        .record PARTNER                 ; scalar form only
        .field  PARTNER_LEVEL           ; address of the other level of the pair
        .field  PARTNER_PAIR            ; number of the pair
        .endrecord

        .record PART                    ; scalar form only
        .field  PART_LEVELS             ; address of its first level
        .field  PART_LEVEL_COUNT        ; number of its levels: 0, 1 or 2
        .field  PART_COUNT              ; objects of it that contain the ray
        .endrecord

        .data
overlaps_arguments:
overlap_groups: .word 0                 ; number of groups
overlap_group:  .word 0                 ; address of the groups
overlap_levels: .word 0                 ; address of the levels
overlap_pairs:  .word 0                 ; address of the pairs
overlap_parts:  .word 0                 ; address of the parts
overlap_carries: .word 0                ; address of a word per group, zeros
overlap_bits:   .word 0                 ; address of LEVEL_BITS bits per level
                .equ    OVERLAPS_ARGUMENTS, 7
        .code

; Bits of a level: before the first of LANES crossings, and after each of them.
        .equ    LEVEL_BITS, LANES + 64

        .regs   r50, ovl_groups, ovl_group, ovl_levels, ovl_pairs, ovl_parts, ovl_carries, ovl_bits

        .entry  overlaps
        .kernel overlaps
overlaps:
        crossed_begin
        load_words overlaps_arguments, OVERLAPS_ARGUMENTS, ovl_groups, col_work0
        by_hand mass/overlaps
        .endkernel
