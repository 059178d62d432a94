; image.s - the formulas of pigments that are images, for the scalar and the
; vector form (IMAGES = 1, and PATTERNS).
;
; An image extends from 0 to 1 along u and along v, which points up.  A point x,
; y, z of the pigment's space has the coordinates
;
;   planar       u = x,        v = y
;   spherical    u = t(x, z),  v = 1/2 + 2 (angle of the point above y = 0)
;   cylindrical  u = t(x, z),  v = y
;   torus        u = t(x, z),  v = t(1 - r, -y),   r = sqrt(x^2 + z^2)
;
; where t(a, b) is the angle from a towards b.  All angles are in turns and
; computed by the routine of the radial pattern (pattern.s).  Let {c} =
; c - floor(c), which is below 1 because differences are truncated, and
; e = k_checker.  In an image of W columns and H rows, row 0 at the top, the
; point is in
;
;   column c = W {u + e},   row d = H {-(v + e)}
;
; If the image is shown once, some points are outside of it: for a planar image
; those whose u + e or v + e is not in 0 .. 1, for a cylindrical image those
; whose v + e is not.  Their colour is the second one of P_COLOR, as in a
; checker's odd cell.  The colour of all other points is
;
;   nearest      that of the pixel floor(c), floor(d)
;   bilinear     with i = floor(c + 1/2), p = c + 1/2 - i, and j, q for d,
;                p q of the pixel i, j, and (1-p) q of i-1, j, p (1-q) of i,
;                j-1, (1-p) (1-q) of i-1, j-1
;   by distance  of the same four 1 / ((1-p)^2 + (1-q)^2 + k_tiny), with p
;                instead of 1-p for i-1, q for j-1; divided by their sum
;
; The neighbour of the last column is the first column, and the reverse.  If the
; image is shown once, a column at an edge is its own neighbour.  The same
; applies to rows.
; Source: POV-Ray 3.7's image maps, verified by its pictures.
;
; P_MAP contains the address of the routine for the coordinates, the address of
; the routine for the colour, the numbers W and H, the test for points outside
; (0: none, 1: v, 2: u and v), 1 if the image is shown once, and the address of
; the pixels (red, green, blue, row by row).  It has no stops.
        .equ    PIXEL_SIZE, 3
