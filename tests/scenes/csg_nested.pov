// Trees of depth five, with every operation inside every other one.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <.1, .12, .18> }
camera { location <1, 4.5, -9> look_at <0, .7, 0> angle 44 }
light_source { <-6, 9, -8>, rgb .9 }
#default { finish { ambient .13 diffuse .7 } }
#declare A = pigment { rgb <.8, .35, .2> }
#declare B = pigment { rgb <.25, .5, .8> }
#declare C = pigment { rgb <.8, .75, .3> }
#declare D = pigment { rgb <.4, .75, .4> }
// shells in shells, open at the front
difference {
    sphere { 0, 1.2 pigment { A } }
    difference {
        sphere { 0, 1.1 pigment { B } }
        difference {
            sphere { 0, .9 pigment { C } }
            difference {
                sphere { 0, .8 pigment { D } }
                difference { sphere { 0, .5 pigment { A } } sphere { 0, .3 } }
            }
        }
    }
    box { <0, 0, -2>, <2, 2, 0> pigment { rgb .8 } }
    rotate 20*y translate <-2.3, 1.2, 0>
}
intersection {
    union {
        difference {
            merge {
                intersection { box { -1, 1 } sphere { 0, 1.3 } pigment { A } }
                union { cylinder { -1.3*y, 1.3*y, .3 }
                        cylinder { -1.3*x, 1.3*x, .3 } pigment { B } }
            }
            union {
                cylinder { -2*z, 2*z, .4 }
                intersection { sphere { <.8, .8, -.8>, .8 }
                               plane { y, .9 inverse } }
            }
            pigment { C }
        }
        box { <-.15, -1.2, -1.2>, <.15, -.4, 1.2> pigment { D } }
    }
    merge { plane { z, .5 } sphere { <.5, 0, .5>, .6 } pigment { rgb .6 } }
    rotate 25*y translate <1.1, 1.3, 0>
}
difference {
    union { box { -.5, .5 pigment { A } }
            box { -.5, .5 pigment { B } rotate <45, 0, 45> } }
    union {
        union { union { sphere { <0, .5, -.5>, .4 } cylinder { 0, y, .1 } }
                sphere { .5*y, .3 } }
        box { <-.6, -.1, -.6>, <0, .1, 0> } }
    pigment { C } scale .9 translate <3, .8, -1.2>
}
plane { y, 0 pigment { checker rgb .6, rgb .45 } }
