; span_scalar.s - the part of one ray on which a tree can be seen.
;
; Some parts of a tree are needed (N_NEEDED): where a ray is outside of one of
; them it is outside of the tree.  A ray that misses one sees nothing of the
; tree, and so does the ray before it enters and behind where it leaves one;
; with surfaces nearer than delta as one that leaves
;
;   in - 2 delta < E < out + 2 delta
;
; Parts of those that walk (bound_scalar.s), as macros: the span is
; w_least .. w_end.
; Source: derived here.

        .macro  load_two_delta
        EX      w_at, k_delta
        LOD     [w_at], w_two_delta
        ADDN    w_two_delta, w_two_delta, w_two_delta
        .endm

; What is left of the span in a primitive that is needed, segments (1 or more)
; of which stand from crossing on, apart words between two crossings; the first
; in is w_in.  To nothing, if nothing is left.
        .macro  narrow_span crossing, segments, apart, nothing
        SUBN    w_in, w_two_delta, w_in
        CFPGE   w_least, w_in, narrow_end\@
        RTOR    w_in, w_least
narrow_end\@:
        RTOR    m_minus_big, w_t1
narrow_later\@:
        LOD     [\crossing, \apart], w_out
        IX      \crossing, 2 * STRIDE
        CFPGE   w_t1, w_out, narrow_earlier\@
        RTOR    w_out, w_t1
narrow_earlier\@:
        IBXNE   \segments, m_index_minus_one, r0, narrow_later\@, \segments
        ADDN    w_t1, w_two_delta, w_t1
        CFPGE   w_t1, w_end, narrow_least\@
        RTOR    w_t1, w_end
narrow_least\@:
        CFPGE   w_least, w_end, \nothing
        .endm
