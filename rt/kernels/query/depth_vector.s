; depth_vector.s - counts the bodies that contain the queue's rays.
;
; Processes one column of crossings after another, from near to far, for the
; rays that have a crossing in the column. Each ray has a count of its bodies
; for every object and a count for all objects. RAY_HIT_CROSSING is added
; to the count of its object and to the total.
;
; In:  the queue's planes, in order; sort_count.  Out: RAY_HIT_OBJECT_DEPTH,
; RAY_HIT_SCENE_DEPTH.
; Source: derived here.

        .equ    DEPTH_SIZE, QUEUE       ; of an object: a count for each ray
        .regs   r223, depth_index, depth_column, depth_rays, depth_scene, depth_objects

        .data
        .align  64
depths_store:   .space 2 * QUEUE
        .code

; Sets depth_rays to the rays of the column, and [w1] to the index of each
; ray's count for the object that it crosses.
        .macro  find_objects
        describe near_bits, queue_bits, n
        CMPLTV  depth_index, [query_counts_at], [near_bits]
        CNTOB   [near_bits], s6
        set_near s6
        EX      depth_rays, depths_store
        describe s3, count_store, n
        CPSV    [s3], [depth_rays] ? [near_bits]
        ADDX    depth_column, query_stride, s2
        VXTOV   [depth_rays], [s2], [w1]
        find_records w1, w1, P_OBJECT, s1
        VXTOV   [w1], [s1], [w1]
        EX      s0, DEPTH_SIZE
        MPYLV   [w1], s0, [w1]
        ADDXV   [w1], [depth_rays], [w1]
        .endm

; Computes the address of a field's plane in the column.
        .macro  column_of field, address
        ES      s0, \field
        MPYX    query_stride, s0, \address
        ADDX    depth_column, \address, \address
        .endm

; Adds RAY_HIT_CROSSING [w2] to the counts at [index]. Stores the sums in
; `plane` too.
        .macro  add_crossings index, counts, plane
        VXTOV   [\index], [\counts], [w3]
        ADDXV   [w3], [w2], [w3]
        VTOVX   [\index], [w3], [\counts]
        VTOVX   [depth_rays], [w3], [\plane]
        .endm

        .macro  columns_begin
        RTOR    ray_hits_first, depth_column
        ES      depth_index, 0
        .endm

        .macro  columns_next again
        ADDX    depth_column, query_step, depth_column
        IBXNE   depth_index, one_index, sort_count, \again, depth_index
        .endm

        .kernel lines
count_depths:
        IBXEQ   sort_count, r0, r0, depths_counted
        load_word query_depths, depth_objects
        describe depth_scene, depths_store + 64 * QUEUE, n
        VTOV    r0, [depth_scene]
        columns_begin
depths_column:
        find_objects
        column_of RAY_HIT_CROSSING, s2
        VXTOV   [depth_rays], [s2], [w2]
        column_of RAY_HIT_OBJECT_DEPTH, s2
        add_crossings w1, depth_objects, s2
        ADDX    s2, query_stride, s2
        add_crossings depth_rays, depth_scene, s2
        columns_next depths_column
        columns_begin
depths_clear:
        find_objects
        VTOVX   [w1], r0, [depth_objects]
        columns_next depths_clear
depths_counted:
        BIM     0, link_kernel
        .endkernel
