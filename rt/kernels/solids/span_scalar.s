; span_scalar.s - the span of a ray in which a tree can be visible.
;
; span_vector.s gives the formula. A ray that misses a required part does not
; see the tree. These macros are parts of the walks (bound_scalar.s). w_least
; and w_end are the ends of the span.

        .macro  load_two_delta
        load_word k_delta, w_two_delta
        ADDN    w_two_delta, w_two_delta, w_two_delta
        .endm

; Narrows the span to a required primitive with one or more segments. Its
; crossings start at `crossing`, and `apart` words are between two of them. The
; first in is w_in. Branches to `nothing` if the span is empty.
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
