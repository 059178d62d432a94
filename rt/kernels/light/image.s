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
; where t(a, b) is the angle from a towards b; all angles are in turns and
; computed by the routine of the radial pattern (pattern.s).  With {c} =
; c - floor(c), which is below 1 because differences are truncated, and
; e = k_checker, a point of an image of W columns and H rows, row 0 at the top,
; has
;
;   column c = W {u + e},   row d = H {-(v + e)}
;
; If the image is shown once, a point is outside of a planar one if u + e or
; v + e is not in 0 .. 1, and of a cylindrical one by v alone.  Outside, the
; colour is the second one of P_COLOR, as in a checker's odd cell.  Elsewhere
; the colour is
;
;   nearest      that of the pixel floor(c), floor(d)
;   bilinear     with i = floor(c + 1/2), p = c + 1/2 - i, and j, q for d,
;                p q of the pixel i, j, and (1-p) q of i-1, j, p (1-q) of i,
;                j-1, (1-p) (1-q) of i-1, j-1
;   by distance  of the same four 1 / ((1-p)^2 + (1-q)^2 + k_tiny), with p
;                instead of 1-p for i-1, q for j-1; divided by their sum
;
; The last column is followed by the first one, or, if the image is shown once,
; by itself.  The first column and the rows are treated in the same way.
; Source: POV-Ray 3.7's image maps, verified by its pictures.
;
; P_MAP contains: the routine for the coordinates and that for the colour; the
; numbers W, H, the test for points outside (0: none, 1: v, 2: u and v), and 1
; if the image is shown once; the address of the pixels: red, green, blue, row
; by row; and no stops.
        .equ    PIXEL_SIZE, 3
