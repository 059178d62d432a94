; hits_vector.s - vectors of what rays of a queue hit: where they stand, which part
; of them belongs to which primitive.
;
; All have their registers from at on (queue.s); a table has where they begin.
; What belongs to one look (records.s, P_MATERIAL) is a part, one behind the other;
; of a part the vectors that are kept stand in those of all, the others at their
; beginning (surface_vector.s).

        .share  phase
        .reg    part_at, r188
        .reg    ndotl, r168             ; N.L, of HIT_VECTORS the last
        .reg    part_offset, r169
        .endshare

        .record PART
        .field  PART_PRIMITIVE
        .field  PART_FIRST              ; of its hits,
        .field  PART_HITS               ; how many
        .field  PART_SHARED             ; 1: of several primitives that look alike
        .endrecord

        .data
shade_bases:
        vector_bases SHADE_VECTORS - 4, shade_store, 4, shade_bits
shade_descriptors:
        .space  SHADE_VECTORS
hit_part_count: .word 0
hit_parts:      .space PART_SIZE * QUEUE
shade_bits:     .space 4 * QUEUE_BIT_WORDS
        .align  64
shade_store:    .space (SHADE_VECTORS - 3) * QUEUE
order_hit_store: .space QUEUE
        .code
        .equ    NDOTL_STORE, shade_store + 64 * QUEUE * (SHADE_VECTORS - 4)

; The points where the rays hit, and their directions.
        .macro  point o, d, p, hd
        VXTOV   [at], [\d], [\hd]
        MPYSV   [v0], [\hd], [v1]
        VXTOV   [at], [\o], [\p]
        ADDNV   [\p], [v1], [\p]
        .endm

; .. of rays that start at one point.
        .macro  point_of_view o, d, p, hd
        VXTOV   [at], [\d], [\hd]
        MPYSV   [v0], [\hd], [v1]
        ADDNV   [\o], [v1], [\p]
        .endm

; [into] = where the records of primitives stand by their numbers, in words from
; table on, which is the place of a field.
        .macro  find_records numbers, into, field, table
        EX      s0, P_SIZE
        MPYLV   [\numbers], s0, [\into]
        load_word scene_primitives, \table
        IX      \table, 64 * (\field - P_SIZE)
        .endm
