// Height fields as parts of solids: the region below the surface is the inside.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 6 }
camera { location <.4, 2.6, -8> look_at <0, .2, 0> right x*4/3 angle 42 }
light_source { <5, 9, -6>, rgb .9 }
light_source { <-7, 5, -4>, rgb <.3, .35, .4> }
background { color rgb <.35, .45, .6> }
plane { y, -1.2 pigment { checker rgb .9 rgb .45 } }
#declare Hills = height_field { function 17, 17 { .5 + .3*sin(9*x)*cos(7*y) }
    translate <-.5, -.5, -.5> scale <2, 1.2, 2> }
#declare Isles = height_field { function 13, 15 { .4 + .35*sin(9*x)*cos(7*y) }
    water_level .3 translate <-.5, -.5, -.5> scale <2, 1.2, 2> }
intersection { object { Hills } cylinder { -y, y, .8 } pigment { rgbf <.7,.95,.6,.8> } interior { ior 1.15 }
    translate <-2.6,.1,1> }
difference { box { -.8, .8 } object { Hills pigment { rgb <.9,.6,.3> } } pigment { rgb <.7,.7,.9> } rotate 20*y translate <0,.2,1.5> }
intersection { object { Isles } sphere { 0, .9 } pigment { rgb <.8,.5,.4> } translate <2.5,0,.6> }
merge { object { Isles scale .6 } sphere { <.1, .2, 0>, .3 } pigment { rgb <.5,.7,.8> } rotate <10,0,20> translate <-1.6,-.2,-2> }
sphere { 0, .8 clipped_by { object { Hills rotate <20,30,0> inverse } } pigment { rgb <.9,.9,.3> } translate <.4,-.3,-2> }
difference { sphere { 0, .7 pigment { rgbf <.9,1,.9,.8> } } object { Hills scale .8 } pigment { rgbf <.3,.6,.4,.5> } interior { ior 1.2 } translate <2.3,-.3,-2> }
// smooth; inverted together with another part; the region that the water level removes
intersection { height_field { function 9, 9 { .5 + .3*x*x } smooth translate <-.5, -.5, -.5> scale <1.4, 1.6, 1.4> }
    box { -.55, .5 pigment { rgb <.9, .6, .7> } } pigment { rgb <.5, .5, .9> } rotate -30*y translate <-.5, -.3, -.6> }
