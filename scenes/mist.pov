// Morning mist on a road: posts that fade in a fog, a sky with a gradient, hills
// defined by a function, and a sign with letters.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1.3, 1.7, -8> right 4/3*x angle 50 look_at <-.3, 1.4, 10> }
sky_sphere { pigment { gradient y color_map { [0 rgb <.95, .8, .65>] [.15 rgb <.85, .8, .8>] [.6 rgb <.4, .55, .8>] } } }
fog { distance 36 rgb <.85, .78, .72> }
light_source { <-60, 50, 40>, rgb <.9, .75, .6> }
#default { finish { ambient .25 diffuse .6 } }

plane { y, 0 pigment { rgb <.35, .4, .22> } }
// The road and its centre line.
box { <-2, -.1, -20>, <2, .01, 90> pigment { rgb <.42, .4, .4> } }
#for (I, -4, 20) box { <-.07, 0, 3*I>, <.07, .02, 3*I + 1.5> pigment { rgb .9 } } #end
// Posts with caps.
#declare Post = union {
    cylinder { 0, 1*y, .09 pigment { gradient y color_map { [.5 rgb .9] [.5 rgb .15] } scale .8 } }
    sphere { 1.02*y, .12 pigment { rgb <.8, .2, .1> } }
}
#for (I, 0, 14)
    object { Post translate <-2.5, 0, 3.2*I - 3> }
    object { Post translate <2.5, 0, 3.2*I - 3> }
#end
// Hills.
height_field {
    function 80, 50 { sin(pi*x)*sin(pi*y)*(.5 + .25*sin(9*x + 1)*sin(7*y + 2*x) + .15*cos(17*x + 3*y)) }
    smooth
    translate <-.5, -.02, 0>
    scale <190, 16, 60>
    translate 48*z
    pigment { rgb <.3, .38, .25> }
}
// A sign.
union {
    cylinder { <-.9, 0, 0>, <-.9, 2.5, 0>, .06 }
    cylinder { <.9, 0, 0>, <.9, 2.5, 0>, .06 }
    box { <-1.15, 1.6, -.05>, <1.15, 2.4, .02> pigment { rgb <.15, .3, .5> } }
    text { ttf "crystal.ttf" "PURDUE 84" .04, 0 pigment { rgb .95 } scale .42 translate <-.98, 1.87, -.09> }
    pigment { rgb .5 }
    rotate 12*y
    translate <-3.4, 0, 3.4>
}
// Trees.
#for (I, 0, 5)
    union {
        cylinder { 0, 1.2*y, .15 pigment { rgb <.35, .25, .18> } }
        cone { 1*y, 1.1, 3.6*y, 0 pigment { rgb <.15, .3, .18> } }
        cone { 2.2*y, .85, 4.5*y, 0 pigment { rgb <.17, .34, .2> } }
        translate <(mod(I, 2) ? 5.5 : -6.5) + .6*sin(3*I), 0, 3 + 6*I>
    }
#end
