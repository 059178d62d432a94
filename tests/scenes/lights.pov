// Nine lights: coloured, black, shadowless, behind the plane, inside solids that are
// closed, transparent and cut open; and solids without a shadow.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb .08 }
camera { location <0, 6, -9> right 4/3*x angle 46 look_at <0, .4, 0> }
#default { finish { ambient .05 diffuse .7 specular .3 roughness .05 } }
light_source { <-7, 5, -4>, rgb <.6, .1, .1> }
light_source { <-5, 6, -6>, rgb <.1, .5, .1> }
light_source { <6, 5, -5>, rgb <.1, .1, .6> }
light_source { <0, 9, 6>, rgb .2 shadowless }
light_source { <3, 5, 5>, rgb 0 }
light_source { <0, -3, 0>, rgb 1 }
light_source { <-2.6, .8, .3>, rgb 1 }
light_source { <0, .8, .3>, rgb <.5, .45, .3> }
light_source { <2.6, .8, .3>, rgb <.5, .45, .3> }
plane { y, 0 pigment { rgb .7 } }
// closed, transparent, cut open
sphere { <-2.6, .8, .3>, .6 pigment { rgb <.7, .6, .5> } }
sphere { <0, .8, .3>, .6 pigment { rgbf <1, .8, .6, .8> } }
difference {
    sphere { 0, .6 } sphere { 0, .5 }
    cylinder { -x, x, .2 } cylinder { -z, z, .2 }
    rotate 20*y translate <2.6, .8, .3> pigment { rgb <.6, .7, .8> }
}
cylinder { <-1.3, 0, -1.6>, <-1.3, 1.3, -1.6>, .2 pigment { rgb .8 } }
cylinder { <0, 0, -1.6>, <0, 1.3, -1.6>, .2 pigment { rgb .8 } no_shadow }
// a leaf without a shadow does not remove the shadow of the tree
difference {
    box { <1, 0, -2>, <1.8, 1, -1.2> }
    sphere { <1.4, 1, -1.6>, .5 no_shadow }
    pigment { rgb .8 }
}
difference {
    box { <2.4, 0, -2>, <3.2, 1, -1.2> }
    sphere { <2.8, 1, -1.6>, .5 }
    pigment { rgb .8 } no_shadow
}
