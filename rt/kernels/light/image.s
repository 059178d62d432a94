; image.s - pigments that are images, as both forms of the program have them
; (IMAGES = 1, and PATTERNS).
;
; An image lies from 0 to 1 along u, from 0 to 1 along v, which is up.  A point
; x, y, z of the pigment's space has the place
;
;   planar       u = x,        v = y
;   spherical    u = t(x, z),  v = 1/2 + 2 (angle of the point above y = 0)
;   cylindrical  u = t(x, z),  v = y
;   torus        u = t(x, z),  v = t(1 - r, -y),   r = sqrt(x^2 + z^2)
;
; where t(a, b) is the angle from a towards b; all angles in turns, of the radial
; pattern's routine (pattern.s).  With {c} = c - floor(c), which is below 1, as
; differences are cut, and e = k_checker, of an image of W columns and H rows, row 0
; on top, the place is
;
;   column c = W {u + e},   row d = H {-(v + e)}
;
; Shown once, a planar one is outside where u + e or v + e is not from 0 to 1, a
; cylindrical one by v alone: it is P_COLOR's second colour then, as of a checker's
; odd cell.  The colour of all other places is
;
;   nearest      that of the pixel floor(c), floor(d)
;   bilinear     with i = floor(c + 1/2), p = c + 1/2 - i, and j, q of d likewise
;                p q of the pixel i, j, and (1-p) q of i-1, j, p (1-q) of i, j-1,
;                (1-p) (1-q) of i-1, j-1
;   by distance  of the same four 1 / ((1-p)^2 + (1-q)^2 + k_tiny), with p in
;                place of 1-p for i-1, q for j-1; over the sum of the four
;
; Beyond the last column comes the first one, or, of one that is shown once, the
; last itself; likewise before the first, and of rows.
; Source: POV-Ray 3.7's image maps, measured by its pictures.
;
; P_MAP has of them: the routine for the place, that for the colour; as numbers W, H,
; what shows that a place is outside (0: nothing is, 1: v does, 2: u, too), and 1 if
; it is shown once; the address of the pixels: red, green, blue, row by row; and
; no stops.
        .equ    PIXEL_SIZE, 3
