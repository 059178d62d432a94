// Copies of one solid: translated, rotated, mirrored, scaled, sheared, and copies of copies.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <.1, .13, .17> }
camera { location <-1, 5.5, -10> look_at <0, .8, 0> angle 46 }
light_source { <-6, 9, -8>, rgb .9 }
light_source { <8, 7, -4>, rgb <.2, .25, .3> }
#default { finish { ambient .13 diffuse .7 specular .3 } }
#declare Bead = difference {
    intersection { box { -.5, .5 } sphere { 0, .65 }
        pigment { checker rgb <.8, .4, .25>, rgb <.9, .7, .4> scale .25 } }
    cylinder { -x, x, .25 }
    cone { -z, .5, 0, 0 }
    pigment { rgb <.3, .5, .8> }
}
#declare Pair = union {
    object { Bead translate -.6*x }
    object { Bead scale <-1, 1, 1> rotate 30*y translate .6*x }
}
object { Pair translate <-3, .6, 1> }
object { Pair scale <.5, 2, .8> rotate 20*y translate <-.8, 1, .8> }
object { Pair matrix <1, .3, 0, 0, 1, .2, .4, 0, 1, 2.4, .9, 1.2> }
merge { object { Bead } object { Bead rotate <40, 10, 0> translate .3*y }
    rotate 40*y translate <-2.4, .7, -1.8> }
difference { object { Pair scale 1.3 } object { Bead scale 1.2 rotate 30*z
    pigment { rgb <.4, .7, .4> } } translate <.2, .8, -2> }
object { Bead no_shadow scale <1, -1, 1.5> rotate <20, 50, 10>
    translate <2.4, 1.4, -1.6> }
plane { y, 0 pigment { checker rgb .6, rgb .45 } }
