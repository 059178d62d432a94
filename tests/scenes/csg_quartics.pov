// Quartic surfaces in trees: up to two intervals along a ray, or three if the inside
// is the unbounded region.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <.14, .1, .16> }
camera { location <.5, 4.5, -9> look_at <0, .8, 0> angle 44 }
light_source { <-6, 9, -8>, rgb .9 }
#default { finish { ambient .13 diffuse .7 } }
#declare A = pigment { rgb <.8, .4, .25> }
#declare B = pigment { rgb <.3, .55, .8> }
// x^4 + y^4 + z^4 - x^2 - y^2 - z^2 + c
#macro Tangle(S, C)
    quartic { <S, 0,0,0, 0,0,0, 0,0,-S, 0,0,0,0,0,0,0,0,0,0,
        S, 0,0,0,0,-S,0,0,0,0, S, 0, -S, 0, S*C> sturm }
#end
#declare Cushion = quartic { <1, 0,0,0, 0,0,0, 0,0,0, 0,0,0,0,0,0,0,0,0,0,
    1, 0,0,0,0,0,0,0,0,0, 1, 0, 0, 0, -1> sturm }
difference { object { Cushion pigment { A } }
    sphere { <0, .6, -.6>, .8 pigment { B } }
    rotate 25*y translate <-2.6, 1, .6> }
intersection { Tangle(1, .4) plane { <-.2, .3, -1>, .35 inverse pigment { B } }
    pigment { A } scale 1.1 rotate 25*y translate <0, 1.2, 0> }
difference { box { -1, 1 pigment { A } } Tangle(1, .45)
    plane { z, -.2 } pigment { B } rotate -15*y translate <2.8, 1, .8> }
intersection { sphere { 0, .8 pigment { A } } Tangle(-1, .4)
    plane { x, .3 } pigment { B } rotate -35*y translate <-1.2, .8, -2> }
difference { cylinder { -.9*y, .9*y, .7 pigment { A } }
    object { Cushion scale .6 translate -.4*z pigment { B } }
    translate <1.2, .9, -2> }
plane { y, 0 pigment { checker rgb .6, rgb .45 } }
