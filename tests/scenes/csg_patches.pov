// Steiner patches, which have no inside, and elliptical tori in trees. Of a patch,
// the part remains where the operation would keep a surface.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <.1, .12, .16> }
camera { location <0, 4, -8> look_at <0, .7, 0> angle 44 }
light_source { <-6, 9, -8>, rgb .9 }
#default { finish { ambient .13 diffuse .7 } }
#declare A = pigment { rgb <.8, .4, .25> }
#declare B = pigment { rgb <.3, .55, .8> }
#declare Leaf = steiner_patch { <-1.2, .6, -.8>, <0, .9, 1.2>, <1.2, .3, -.7>,
    <-1, 1.6, .2>, <1, 1.4, .4>, <0, -.4, -1.2> pigment { B } }
intersection { object { Leaf } cylinder { -y, 3*y, .7 pigment { A } }
    translate <-2.4, 0, .4> }
difference { sphere { .7*y, .8 pigment { A } } object { Leaf }
    plane { z, -.3 pigment { rgb .7 } } translate -.1*x }
difference { object { Leaf } cylinder { -y, 3*y, .5 pigment { A } }
    translate <2.3, 0, .5> }
merge { object { Leaf } box { <-.5, 0, -.5>, <.5, .9, .5> pigment { A } }
    scale .7 translate <-1.2, 0, -2> }
difference { elliptical_torus { .7, .15, .4 pigment { A } }
    elliptical_torus { .7, .08, .3 pigment { B } }
    box { <0, -1, -2>, <2, 1, 0> rotate 25*y } rotate -25*x
    translate <1.4, .5, -1.8> }
plane { y, 0 pigment { checker rgb .6, rgb .45 } }
