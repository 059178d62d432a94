// Empty solids, alone and within other solids.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <.12, .1, .16> }
camera { location <0, 3.5, -9> look_at <0, .6, 0> angle 42 }
light_source { <-6, 9, -8>, rgb .9 }
#default { finish { ambient .12 diffuse .7 } }
#declare Nothing = difference { sphere { 0, .7 } box { -1, 1 } }
#declare Apart = intersection { sphere { -x, .6 } sphere { x, .6 } }
object { Nothing pigment { rgb <1, 0, 0> } translate .8*y }
object { Apart pigment { rgb <1, 0, 0> } translate <0, .8, -1> }
intersection { object { Nothing } object { Apart } plane { y, 5 }
    pigment { rgb <1, 0, 0> } }
// empty solids that are subtracted, merged and inverted
difference { box { <-.7, 0, -.7>, <.7, 1.4, .7> } object { Nothing }
    object { Apart } pigment { rgb <.3, .6, .8> }
    rotate 30*y translate -2.4*x }
merge { object { Nothing } cylinder { 0, 1.4*y, .6 } object { Apart }
    pigment { rgb <.8, .6, .3> } }
difference {
    object { Nothing inverse }
    merge { sphere { .8*y, .8 inverse } box { <0, -1, -2>, <2, 3, 0> } }
    pigment { rgb <.5, .8, .4> } translate 2.4*x
}
intersection { plane { y, -.5 } plane { -y, .4 } pigment { rgb <1, 0, 0> } }
plane { y, 0 pigment { checker rgb .6, rgb .45 } }
