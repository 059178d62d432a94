; order.s - the order in which pixels form queues: rows or tiles.
;
; In order of rows, the pixels of a band form queues row after row. In order of
; tiles, the band is cut into strips, about as high as a square of QUEUE pixels.
; Within a strip, pixels are counted column by column, so a queue is a nearly
; square tile of the picture and its rays hit the same objects.
;
;   strips = floor(rows / sqrt(QUEUE) + 1/2), at least 1
;   strip t, from 0 on, begins with row floor(t rows / strips)
;   pixel k of a strip h rows high:  column floor(k / h), row k - h column
;
; A queue continues in the next strip. The position of a pixel in the band's
; planes does not depend on the order. For a queue of the first level,
; queue_order is a list of these positions, or 0 if they are consecutive.
;
; In:  scene_tiles, scene_band, half.  Out: strip_count.
; Source: derived here. It is well known that neighbouring rays hit the same
; objects.

        .data
scene_tiles:    .word 0                 ; 1: tiles, written by the host
queue_order:    .word 0                 ; descriptor: places in the planes, or 0
strips_done:    .word 0                 ; rows above the strip in which the last
                                        ; queue begins, for the host
strip_state:                            ; strip_number .. strip_at, integers
                .space 4
strip_count:    .word 0                 ; a number
        .align  64
order_store:    .space QUEUE
        .code

; Advances to the next strip. `rows` is the number of rows of the band.
        .macro  next_strip rows, count, work
        ADDX    strip_row, strip_height, strip_row
        IX      strip_number, 1
        ADDN    strip_number, r0, \work
        MPYS    \work, \rows, \work
        DIVS    \work, \count, \work    ; truncates towards zero
        FLR     \work, \work
        SUBX    \work, strip_row, strip_height
        ES      strip_at, 0
        .endm

        .kernel frame
begin_order:
        load_word scene_tiles, s0
        IBXEQ   s0, r0, r0, order_begun
        load_words scene_band, 2, s1, s0
        SUBN    s2, s1, s1
        EX      s3, QUEUE
        ADDN    s3, r0, s3
        SQRT    s3, s3
        DIVS    s1, s3, s1
        ADDN    s1, half, s1
        FLR     s1, s1
        ADDN    s1, r0, s1
        CFPGE   s1, one, order_strips
        RTOR    one, s1
order_strips:
        store_word s1, strip_count, s0
order_begun:
        BIM     0, link
        .endkernel
