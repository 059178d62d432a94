// Two fogs, one of which tints the objects seen through it and transmits a part of
// all light; rays pass through fog before and after a mirror.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 }
camera { location <0, 2, -7> look_at <0, .6, 0> angle 50 }
light_source { <-5, 9, -6>, 1 }
background { rgb <.1, .2, .4> }
fog { distance 14 color rgb <.7, .75, .8> }
fog { distance 30 color rgbft <.9, .5, .3, .4, .25> fog_type 1 }
fog { color rgb 1 }                           // a fog without a distance is ignored
#default { finish { ambient .15 diffuse .7 } }
disc { 0, y, 20 pigment { checker rgb 1 rgb .3 } finish { reflection .2 } }
sphere { <-1.4, 1, 1>, 1 pigment { rgb <.8, .3, .2> } finish { reflection .5 } }
box { <.5, 0, 3>, <2, 2, 4> pigment { rgb <.2, .4, .8> } }
sphere { <3, .7, 8>, .7 pigment { rgb <.8, .8, .1> } }
sphere { <.2, .5, -1.5>, .5 pigment { rgb <.2, .8, .3> } finish { phong .8 } }
difference { cylinder { 0, 1.6*y, .7 } cylinder { .2*y, 2*y, .5 }
    pigment { rgb <.7, .3, .7> } translate <-3, 0, -1> }
