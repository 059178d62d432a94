// Mirrors: a floor, balls that reflect each other, the inside of a half pipe.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 7 adc_bailout 1/100 }
background { rgb <.3, .4, .6> }
camera { location <0, 3, -10> right 4/3*x angle 48 look_at <0, .8, 0> }
light_source { <-5, 8, -7>, rgb .7 }
light_source { <6, 5, -3>, rgb <.3, .25, .2> }
#default { finish { ambient .1 diffuse .5 } }

plane {
    y, -1
    pigment { checker rgb <.9, .9, .8> rgb <.3, .2, .2> }
    finish { reflection .3 }
}
sphere { <-1.8, 0, 0>, 1 pigment { rgb .1 }
         finish { reflection rgb <.9, .8, .6> specular .6 roughness .02 } }
sphere { <1.2, .2, 1>, 1.2 pigment { rgb <.1, .1, .3> }
         finish { reflection .6 phong .8 phong_size 60 } }
// An open half pipe, a mirror on both sides.
intersection {
    cylinder { <4, -1, -1>, <4, 1.5, -1>, 1.4 open }
    plane { <.4, 0, -1>, -2 inverse }
    pigment { rgb <.2, .5, .2> }
    finish { reflection .5 }
}
difference {
    box { <-5, -1, -.5>, <-3.4, 1.6, 2> }
    sphere { <-4, .6, -.7>, .7 pigment { rgb .05 } finish { reflection .8 } }
    pigment { rgb <.7, .3, .2> }
    rotate -10*y
}
sphere { <0, -.6, -2>, .4 pigment { rgb <.9, .3, .3> } }
