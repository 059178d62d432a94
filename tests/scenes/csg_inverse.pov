// inverse: of leaves, of trees, twice, and of objects whose inside has no effect.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <.1, .14, .12> }
camera { location <1, 4, -9.5> look_at <0, .6, 0> angle 44 }
light_source { <-6, 9, -8>, rgb .9 }
light_source { <8, 5, -4>, rgb <.2, .25, .35> }
#default { finish { ambient .12 diffuse .7 } }
#declare Bitten = difference {
    box { <-.7, 0, -.7>, <.7, 1.4, .7> }
    sphere { <.5, 1.2, -.5>, .8 pigment { rgb <.9, .8, .3> } }
}
object { Bitten pigment { rgb <.7, .3, .3> } translate -3.2*x }
object { Bitten inverse pigment { rgb <.3, .3, .7> } translate <-1.4, 0, 1> }
intersection { cylinder { 0, 1.6*y, .8 } object { Bitten inverse }
    pigment { rgb <.3, .7, .4> } translate <.4, 0, 0> }
difference { sphere { .7*y, .9 } object { Bitten inverse }
    pigment { rgb <.7, .5, .8> } translate <2.4, 0, .6> }
object { Bitten inverse inverse pigment { rgb <.4, .7, .8> }
    scale .7 rotate 70*y translate <-.6, 0, -2.2> }
intersection {
    plane { -y, 0 inverse inverse }
    plane { y, 0 translate .6*y }
    cylinder { -y, 2*y, .7 }
    torus { .7, .3 inverse translate .3*y }
    pigment { rgb <.8, .6, .4> } translate <2, 0, -2.4>
}
sphere { <3.8, .5, -.4>, .5 inverse pigment { rgb <.6, .6, .6> } }
plane { -y, 0 inverse pigment { checker rgb .6, rgb .45 } }
