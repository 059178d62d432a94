// Colours in a working space that is not linear, and an ambient light.
#version 3.7;
global_settings { assumed_gamma 2.2 ambient_light rgb <1, .8, .6> }
background { rgb <.2, .3, .5> }
camera { location <0, 2, -7> look_at <0, .5, 0> angle 40 }
light_source { <5, 8, -6>, rgb <1, .9, .8> }
light_source { <-7, 3, -4>, rgb .3 shadowless }
#default { finish { ambient .2 diffuse .7 phong .6 phong_size 25 } }
sphere { <-1, .8, 0>, .8 pigment { rgb <.8, .3, .2> } no_shadow }
box { <.3, 0, -.5>, <1.5, 1.2, .7> rotate 20*y pigment { rgb <.2, .6, .4> } no_shadow }
plane { y, 0 pigment { checker rgb <.9, .8, .3>, rgb .3 scale .7 } no_shadow }
