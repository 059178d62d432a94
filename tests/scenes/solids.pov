// Solids of every kind of primitive, nested and cut, under two lights with shadows.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <.05, .07, .1> }
camera { location <1, 7, -13> right 4/3*x angle 52 look_at <.4, .6, 0> }
light_source { <-9, 14, -10>, rgb <.8, .8, .7> }
light_source { <10, 8, -6>, rgb <.25, .3, .4> }
#default { finish { ambient .1 diffuse .8 } }

#declare Warm = pigment { rgb <.9, .5, .2> }
#declare Cool = pigment { rgb <.2, .5, .9> }
#declare Leaf = pigment { rgb <.4, .8, .3> }

plane { y, -1 pigment { checker rgb .9 rgb .5 scale 1.5 } }

// A die: box and sphere, three bores of another colour.
difference {
    intersection { box { -1, 1 } sphere { 0, 1.35 } pigment { Warm } }
    cylinder { -2*x, 2*x, .5 }
    cylinder { -2*y, 2*y, .5 }
    cylinder { -2*z, 2*z, .5 }
    pigment { Cool }
    rotate <0, 30, 0>
    translate <-4.5, 0, 1>
}

// A ring minus a box and a cone.
difference {
    torus { 1, .4 }
    box { <0, -1, -2>, <2, 1, 0> pigment { Warm } }
    cone { <-1, -.5, -1>, .1, <-1, .6, -1>, .7 pigment { Cool } }
    pigment { Leaf }
    rotate -50*x
    translate <-1.2, .2, -1.5>
}

// A merge has no inner faces, also where it is cut open.
difference {
    merge {
        sphere { -.6*x, .9 pigment { Warm } }
        sphere { .6*x, .9 pigment { Cool } }
        cylinder { -1.2*y, 1.2*y, .35 pigment { Leaf } }
    }
    plane { z, -.25 pigment { rgb .8 } }
    rotate 20*y
    translate <2, .2, -2.5>
}

// A wall with a window: the volume inside of an open cylinder is cut away, and its
// missing disks are not visible.
difference {
    box { <-1, -1, -.3>, <1, 1, .3> pigment { Leaf } }
    cylinder { -.4*z, .1*z, .7 open pigment { Warm } }
    translate <4.6, 0, 0>
}

// Quadrics: the outside of a hyperboloid, within a ball.
intersection {
    sphere { 0, 1 }
    quadric { <1, -1, 1>, <0, 0, 0>, <0, 0, 0>, -.1 inverse pigment { Cool } }
    pigment { Warm }
    rotate 25*z
    translate <2.5, .3, 2>
}

// A quartic, a rounded cube, that is cut in half by a slanted plane.
intersection {
    quartic {
        <1, 0,0,0, 0,0,0, 0,0,0, 0,0,0,0,0,0,0,0,0,0,
         1, 0,0,0,0,0,0,0,0,0, 1, 0, 0, 0, -1>
    }
    plane { <1, 1, -2>, .2 pigment { Leaf } }
    pigment { Cool }
    scale .9
    translate <-1.6, .1, 3>
}

// Nested differences: the hole of the inner one remains as a peg.
difference {
    box { <-.8, -1, -.8>, <.8, .4, .8> pigment { Warm } }
    difference {
        cylinder { <0, -.4, 0>, <0, 1, 0>, .6 }
        cylinder { <0, -2, 0>, <0, 2, 0>, .3 }
        pigment { Cool }
    }
    translate <5.2, 0, -3.2>
}
