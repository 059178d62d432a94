; overlaps.s - the volumes that two parts claim both, pair by pair; what the two forms have
; in common.
;
; A ray comes into a part with the first of its objects and leaves it with the last.  Level
; l of a part is on while the ray is in at least LEVEL_LEAST of the part's objects; a pair
; of levels is on while both are: the levels of two parts, 1 and 1, where these overlap; of
; one part level 2, paired with itself, where its own objects do.  Where a pair comes on
; at s0 and goes off at s1 its volume has
;
;   V += a (s1 - s0)
;
; so each crossing where it changes adds w s, w = -1 where it comes on and 1 where it goes
; off; a is the area that belongs to a ray.
;
; In how many objects of each part a ray is are fields of words: part i has the field at bit
; f of group g, as wide as its number of objects needs, and 47 bits make a group.  Beginnings
; add 2^f, ends take it away; no field ever is below 0 or overflows, so that one addition
; counts for all parts of the group.  Behind a ray all of them are 0 again: so the sums over
; all crossings from the first on are those over each ray's own.
;
; In:  what stands in crossed.s, with as many sums as pairs, and below.
; Out: crossed_sums, for each pair one sum.
; Source: derived here.

        .include "mass/crossed.s"

        .record GROUP                   ; parts whose fields share a word
        .field  GROUP_STEPS             ; address of 2^f of each part, an integer; 0: it
                                        ; is of another group
        .field  GROUP_LEVELS            ; how many levels are of its parts
        .endrecord

        .record LEVEL                   ; group by group
        .field  LEVEL_MASK              ; the part's field
        .field  LEVEL_REACHED           ; LEVEL_LEAST in the field
        .field  LEVEL_LEAST             ; how many objects
        .field  LEVEL_ON                ; 1: it is on now; for the scalar form, as all below
        .field  LEVEL_PARTNERS          ; address of its pairs
        .field  LEVEL_PAIRS             ; how many they are
        .endrecord

        .record PAIR
        .field  PAIR_LEVELS, 2          ; numbers of levels, from 0 on
        .endrecord

        .record PARTNER                 ; for the scalar form
        .field  PARTNER_LEVEL           ; address of the other level of the pair
        .field  PARTNER_PAIR            ; number of the pair
        .endrecord

        .record PART                    ; for the scalar form
        .field  PART_LEVELS             ; address of its first level
        .field  PART_LEVEL_COUNT        ; it has 0, 1 or 2
        .field  PART_COUNT              ; in how many objects the ray is
        .endrecord

        .data
overlaps_given:
overlap_groups: .word 0                 ; how many there are
overlap_group:  .word 0                 ; address of the groups
overlap_levels: .word 0                 ; .. of the levels
overlap_pairs:  .word 0                 ; .. of the pairs
overlap_parts:  .word 0                 ; .. of the parts
overlap_carries: .word 0                ; .. of a word for each group: zeros
overlap_bits:   .word 0                 ; .. of LEVEL_BITS bits for each level
                .equ    OVERLAPS_GIVEN, 7
        .code

; Whether it is on behind each of LANES crossings, and before the first.
        .equ    LEVEL_BITS, LANES + 64

        .regs   r50, ovl_groups, ovl_group, ovl_levels, ovl_pairs, ovl_parts, ovl_carries, ovl_bits

        .macro  overlaps_begin
        crossed_begin
        EX      col_work0, overlaps_given
        ELEN    col_work0, OVERLAPS_GIVEN
        SWAP    [col_work0], ovl_groups, [r0]
        .endm
