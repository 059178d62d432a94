; example-three.s - a link that memory cannot feed: z := x y + z.

        .include "core.s"

        .data
        .vector x, 3, 1.0, 2.0, 3.0
        .vector y, 3, 1.0, 2.0, 3.0
        .vector z, 3, 1.0, 2.0, 3.0
        .code

        .regs   r10, xs, ys, zs, link

        descriptor xs, x, 3
        descriptor ys, y, 3
        descriptor zs, z, 3
        descriptor link, z, 3
        LINKV
        MPYSV   [xs], [ys], [link]
        ADDNV   [link], [zs], [zs]
        EXIT
; expect-trap: bad-link
