// Rays along faces: the picture is so low that every ray is within 1e-7 of the plane
// y = 1, which contains faces, edges and tangents of these solids. The upper half of
// the rays is above the plane, the lower half is below it.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <.1, .12, .2> }
camera { location <0, 1, -10> direction 2*z right 2*x up 1e-8*y }
light_source { <-6, 9, -8>, rgb .9 shadowless }
#default { finish { ambient .3 diffuse .6 } }
#declare Low = box { <-.3, 0, -.3>, <.3, 1, .3> }
#declare High = box { <-.3, 1, -.3>, <.3, 2, .3> }
object { Low pigment { rgb <.8, .3, .2> } translate -4.5*x }
object { High pigment { rgb <.3, .7, .3> } translate -3.6*x }
merge { object { Low } object { High }
    pigment { rgb <.3, .4, .8> } translate -2.7*x }
difference { object { Low } object { High scale <.5, 1, 2> }
    pigment { rgb <.8, .7, .2> } translate -1.8*x }
difference { merge { object { Low } object { High } }
    box { <-.2, .5, -.5>, <.2, 1, .5> }
    pigment { rgb <.3, .8, .8> } translate -.9*x }
intersection { object { Low } object { High }
    pigment { rgb <.8, .3, .8> } }
cylinder { 0, y, .3 pigment { rgb <.5, .5, .5> } translate .9*x }
cylinder { <0, .7, -.3>, <0, .7, .3>, .3
    pigment { rgb <.9, .5, .3> } translate 1.8*x }
sphere { <2.7, .7, 0>, .3 pigment { rgb <.4, .6, .9> } }
difference { box { <-.3, 0, -.3>, <.3, 2, .3> } plane { y, 1 }
    pigment { rgb <.6, .9, .4> } translate 3.6*x }
cone { 0, .3, y, 0 pigment { rgb <.9, .9, .5> } translate 4.5*x }
