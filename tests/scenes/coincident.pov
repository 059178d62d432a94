// Coincident faces within one solid: they vanish or become one surface. In POV-Ray
// they depend on rounding, so this scene is not compared with it.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
background { rgb <.2, .3, .4> }
camera { location <1, 5, -11> right 4/3*x angle 50 look_at <.2, .4, 0> }
light_source { <-7, 9, -8>, rgb .8 }
#default { finish { ambient .15 diffuse .7 } }

plane { y, -1.5 pigment { checker rgb .9 rgb <.4, .5, .4> } }

// A hole that ends exactly at both faces of a plate.
difference {
    box { <-1, -1, -.3>, <1, 1, .3> pigment { rgb <.9, .6, .2> } }
    box { <-.5, -.5, -.3>, <.5, .5, .3> pigment { rgb <.2, .4, .9> } }
    rotate <0, 25, 0>
    translate <-4, 0, 0>
}
// Two halves, and a third part that overlaps both: one block of glass.
merge {
    box { <-1, -1, -1>, <0, 1, 1> }
    box { <0, -1, -1>, <1, 1, 1> }
    box { <-.5, -1, -1>, <.5, 1, 1> }
    pigment { rgbf <.8, 1, .9, .9> }
    interior { ior 1.3 }
    scale .8
    rotate <0, 30, 0>
    translate <-1.3, 0, -2>
}
// A ball minus itself: nothing remains. A torus minus one of its halves: the other remains.
difference { sphere { <0, 2.5, 0>, 1 } sphere { <0, 2.5, 0>, 1 } }
difference {
    torus { 1, .4 }
    difference { torus { 1, .4 } box { <0, -1, -2>, <2, 1, 2> } }
    pigment { rgb <.8, .3, .3> }
    rotate -60*x
    translate <1.4, .2, 1>
}
// The intersection of a cone with itself.
intersection {
    cone { -y, 1, y, .4 }
    cone { -y, 1, y, .4 }
    pigment { rgb <.5, .8, .4> }
    translate <3.4, -.5, -1>
}
// Stairs of boxes that share faces and edges.
merge {
    box { <0, 0, 0>, <1, .5, 1> }
    box { <.5, .5, 0>, <1, 1, 1> }
    box { <0, 0, 1>, <1, .5, 2> }
    box { <1, 0, 0>, <1.5, 1.5, 2> }
    pigment { rgb <.7, .7, .9> }
    finish { reflection .2 }
    rotate 40*y
    translate <3, -1.5, -4>
}
// A slab thinner than the tolerance, and an intersection without volume.
intersection {
    plane { y, 1e-9 } plane { -y, 0 } box { -1, 1 }
    translate <0, 1.5, -3>
}
intersection {
    box { 0, 1 } plane { <-1, 1, 0>, 0 } plane { <1, -1, 0>, 0 }
    translate <-1, 1.5, 0>
}
