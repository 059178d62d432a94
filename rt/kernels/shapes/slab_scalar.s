; slab_scalar.s - cuts the segment of one ray to the part between two parallel
; planes (slab_vector.s).  Branches to miss as soon as the segment is empty.

        .macro  slab o, d, low, high, miss
        ABS     \d, t0
        CFPLT   t0, tiny, slab_parallel\@
        DIVS    one, \d, t0
        SUBN    \low, \o, t1
        SUBN    \high, \o, t2
        MPYS    t1, t0, t1
        MPYS    t2, t0, t2
        CFPGE   t2, t1, slab_ordered\@
        RTOR    t1, t3
        RTOR    t2, t1
        RTOR    t3, t2
slab_ordered\@:
        CFPGE   tin, t1, slab_far\@
        RTOR    t1, tin
slab_far\@:
        CFPGE   t2, tout, slab_cut\@
        RTOR    t2, tout
slab_cut\@:
        CFPLT   tout, tin, \miss
        BIM     slab_end\@
slab_parallel\@:
        CFPLT   \o, \low, \miss
        CFPLT   \high, \o, \miss
slab_end\@:
        .endm
