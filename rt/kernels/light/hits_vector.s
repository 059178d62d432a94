; hits_vector.s - the vectors of the hits of a queue: their registers, their
; memory, and the parts that belong to one material.
;
; The descriptors of all vectors are in the registers from at on (queue.s); a
; table has their addresses.  The hits of one material (records.s, P_MATERIAL)
; form a part; parts are contiguous.  The kept vectors of a part are slices of
; those of all hits; its other vectors begin where those of all hits begin
; (surface_vector.s).

        .share  phase
        .reg    part_at, r188
        .reg    ndotl, r168             ; N.L, the last of HIT_VECTORS
        .reg    part_offset, r169
        .endshare

        .record PART
        .field  PART_PRIMITIVE
        .field  PART_FIRST              ; its first hit,
        .field  PART_HITS               ; the number of its hits
        .field  PART_SHARED             ; 1: several primitives of one material
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

; Computes the hit points and the directions of their rays.
        .macro  point o, d, p, hd
        VXTOV   [at], [\d], [\hd]
        MPYSV   [v0], [\hd], [v1]
        VXTOV   [at], [\o], [\p]
        ADDNV   [\p], [v1], [\p]
        .endm

; Computes the hit points and directions of rays that start at one point.
        .macro  point_of_view o, d, p, hd
        VXTOV   [at], [\d], [\hd]
        MPYSV   [v0], [\hd], [v1]
        ADDNV   [\o], [v1], [\p]
        .endm

; [into] = the offsets of the records of the primitives [numbers], in words.
; table = the address to which an offset is added to get the field.
        .macro  find_records numbers, into, field, table
        EX      s0, P_SIZE
        MPYLV   [\numbers], s0, [\into]
        load_word scene_primitives, \table
        IX      \table, 64 * (\field - P_SIZE)
        .endm
