// Objects that are invisible to the camera or in mirrors; nothing is transparent.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
background { rgb <.6, .5, .4> }
camera { location <.2, 2.2, -7> right 4/3*x angle 48 look_at <.013, .617, 0> }
light_source { <-4, 8, -7>, rgb .9 }
#default { finish { ambient .15 diffuse .65 } }

plane { y, 0 pigment { rgb <.6, .7, .6> } finish { reflection .35 } }
sphere { <0, 1, 1.5>, 1 pigment { rgb .05 } finish { reflection { .1, .9 falloff 2 } } }
box { <-3.2, .05, 2>, <-1.4, 2, 2.2> pigment { rgb .1 } finish { reflection .6 } no_reflection }
plane { -z, 12 pigment { checker rgb <.9, .3, .2>, rgb <.2, .3, .9> scale 2 } no_image }
sphere { <-1.1, .5, -.4>, .5 pigment { rgb <.9, .8, .2> } no_image }
cone { <1.2, .05, -.4>, .5, <1.3, 1.2, -.2>, .1 pigment { rgb <.3, .8, .7> } no_reflection }
box { <2, .1, 0>, <2.7, .8, .8> pigment { rgb <.8, .4, .6> } no_image no_reflection }
cylinder { <-2.4, .1, -.6>, <-2, 1.2, 0>, .25 pigment { rgb <.7, .7, .8> } }
