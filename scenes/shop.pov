// A shop: one image on tins, on a ball, along a ring, on a poster, and on a jar that is
// transparent outside of the image.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
camera { location <0, 2.1, -7.5> right 4/3*x angle 42 look_at <0, 1.15, 0> }
light_source { <-6, 8, -7>, rgb .75 }
light_source { <5, 5, -4>, rgb .25 shadowless }
#default { finish { ambient .2 diffuse .65 } }

#declare Planks = pigment {
    gradient x color_map { [0 rgb <.5, .33, .2>] [.96 rgb <.6, .42, .27>] [.96 rgb .15] } scale .7
}
plane { y, 0 pigment { Planks } }
plane { -z, -2.4 pigment { rgb <.62, .66, .6> } }
// The poster and its frame.
box { <-1.66, 1.5, 2.3>, <1.66, 3.2, 2.4> pigment { rgb <.2, .13, .08> } }
box { <-1.6, 1.56, 2.29>, <1.6, 3.14, 2.31>
      pigment { image_map { png "label.png" once interpolate 2 } scale <3.2, 1.58, 1> translate <-1.6, 1.56, 0> } }
// Tins.
#macro Tin (Turn, Place)
    union {
        cylinder { 0, 1.1*y, .52
                   pigment { image_map { png "label.png" map_type 2 interpolate 2 } scale <1, 1.1, 1> rotate Turn*y } }
        torus { .5, .035 translate 1.1*y }
        torus { .5, .035 }
        disc { 1.112*y, y, .5 }
        pigment { rgb .75 } finish { phong .5 reflection .15 } translate Place
    }
#end
Tin (20, <-2.3, .035, .5>)
Tin (120, <-1.1, .035, .9>)
Tin (-60, <-1.7, 1.22, .7>)
// The ring and the ball.
torus { 1, .34 pigment { image_map { png "label.png" map_type 5 interpolate 2 } rotate 70*y }
        finish { phong .6 } scale .75 rotate <-70, 0, 15> translate <.15, .93, .6> }
sphere { 0, .62 pigment { image_map { png "label.png" map_type 1 interpolate 4 } rotate <0, 120, 25> }
         finish { phong .7 } translate <-.5, .62, -1.3> }
// The jar and its contents.
cylinder { 0, 1.5*y, .7
           pigment { image_map { png "label.png" map_type 2 once interpolate 2 } scale <1, .8, 1> rotate 150*y translate .35*y }
           interior { ior 1.1 } finish { specular .6 reflection .06 } translate <2, .01, .2> }
cylinder { <2, 1.51, .2>, <2, 1.66, .2>, .74 pigment { rgb <.7, .15, .1> } }
#for (I, 0, 11)
    sphere { <2 + .4*cos(2.4*I), .2 + .1*I, .2 + .4*sin(2.4*I)>, .18
             pigment { rgb <.9, .75 - .05*mod(I, 7), .1*mod(I, 5)> } finish { phong .4 } }
#end
