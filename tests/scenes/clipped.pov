// Clipped objects: the part inside of the clipping shapes remains, and these shapes
// are not visible themselves; alone, in trees, and inverted.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <.1, .1, .2> }
camera { location <0, 3.2, -8.5> look_at <0, .35, 0> angle 60 }
light_source { <-5, 9, -6>, rgb .9 }
#default { finish { ambient .15 diffuse .7 } }
#declare Clay = pigment { rgb <.8, .4, .25> }
#declare Slate = pigment { rgb <.35, .45, .6> }
// a bowl, a box in a ball and a tube, half of a ring
sphere { 0, .9 clipped_by { plane { <1, 1, .4>, .2 } } pigment { Clay } translate <-3.2, .9, 0> }
box { -.8, .8 rotate <20, 30, 0>
    clipped_by { sphere { 0, 1 } cylinder { -.55*y, .55*y, .95 open } }
    pigment { Slate } translate <-1.1, .9, 0> }
torus { .8, .2 clipped_by { box { -1, 1 translate x } } rotate 60*x
    pigment { Clay } translate <.9, .8, .3> }
// a union whose parts are all clipped, twice, by the outside of a shape
union { sphere { 0, .6 } cylinder { -x, x, .25 } clipped_by { plane { z, 0 inverse } }
    clipped_by { sphere { .6*y, .3 inverse } } pigment { Slate } translate <3, .7, 0> }
// clipping also applies to a subtracted object, and inversion does not change it
difference { box { -.7, .7 } sphere { 0, .85 clipped_by { plane { y, .3 } } }
    pigment { Clay } rotate 30*y translate <-2.4, .7, -2.6> }
object { intersection { box { -.7, .7 }
        object { merge { sphere { -.3*x, .6 clipped_by { plane { x, -.1 } } } sphere { .4*x, .5 } }
            inverse } }
    pigment { Slate } rotate -25*y translate <-.1, .7, -2.6> }
// clipped by a solid; an unbounded quadric and an unbounded plane
quadric { <1, 0, 1>, 0, 0, -.16
    clipped_by { difference { box { <-1, 0, -1>, <1, 1.6, 1> } sphere { <0, 1.2, -.4>, .35 } } }
    pigment { Clay } translate <1.9, 0, -2.4> }
plane { z, 1 clipped_by { box { <-1, -1, 0>, <1, 1, 2> rotate 45*z } }
    pigment { Slate } translate <0, 1.5, 2> }
prism { 0, 1.2, 5, <-.5, -.5>, <.5, -.5>, <.4, .5>, <-.4, .3>, <-.5, -.5>
    clipped_by { plane { <0, 1, -.7>, .5 } }
    clipped_by { torus { .5, .32 translate .6*y } } pigment { Slate } translate <3.4, .1, -2.2> }
plane { y, 0 pigment { checker rgb .65, rgb .45 } }
