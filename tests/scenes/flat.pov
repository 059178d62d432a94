// Boxes without thickness or almost so, and shapes that are mirrored by a negative scale.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <.1, .1, .15> }
camera { location <.3, 1.7, -6> look_at <0, .1, 0> angle 45 }
light_source { <4, 9, -8>, rgb 1 }
light_source { <-7, 3, -6>, rgb <.3, .4, .5> }
#default { finish { ambient .1 diffuse .6 phong .4 phong_size 30 specular .3 } }
box { <-1, -1, 0>, <1, 1, 0> rotate <30, 40, 0> translate <-1.4, .3, .5>
    pigment { rgb <.9, .5, .2> } no_shadow }
box { <-.7, 0, -.5>, <.7, 1e-9, .5> rotate <-25, 10, 5> translate <1.2, .9, 0>
    pigment { rgb <.2, .7, .5> } no_shadow }
box { <.4, -.9, -1.5>, <1.3, -.9, -.8> pigment { rgb <.7, .2, .6> } no_shadow }
union {
    box { <.1, -.5, -.2>, <.8, .2, .5> rotate 20*x }
    cylinder { <-1.2, -.6, -1.1>, <-.5, -.1, -.9>, .25 }
    cylinder { <-.2, .6, -.7>, <.5, .9, -.2>, .2 open }
    sphere { <1.4, .1, .4>, .45 }
    scale <-1, 1.2, .9>
    translate .3*x
    pigment { rgb <.4, .5, .9> } no_shadow
}
plane { y, 1.1 scale <1, -1, 1> pigment { checker rgb .8, rgb .4 } no_shadow }
