// Height fields: an island in water; one from a function, which is on its side and is
// also seen from below; one that is cut by its water level; and smooth ones, whose
// heights are constant along one axis, because then both programs have the same
// normals between corners.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 6 }
camera { location <1, 4.5, -9> look_at <0, .2, 0> angle 42 }
light_source { <6, 12, -9>, rgb .9 }
light_source { <-8, 5, -4>, rgb <.2, .25, .4> }
background { color rgb <.15, .2, .3> }

plane { y, -1.25 pigment { checker color rgb .85 color rgb .4 scale .7 } }

height_field {
    pgm "height_field.pgm"
    pigment { color rgb <.5, .65, .3> } finish { specular .3 roughness .05 }
    translate -.5 scale <3.1, 1.3, 2.7> rotate 24*y translate <-2.2, .13, .9> }

height_field {
    function 17, 12 { .5 + .3*sin(11*x)*cos(7*y) + .15*(x - y) }
    pigment { checker color rgb <.9, .5, .2> color rgb <.9, .8, .6> scale .37 }
    finish { phong .5 }
    translate -.5 scale <2.3, 1.1, 2.1>
    rotate <-70, 20, 15> translate <1.9, .65, 1.3> }

#declare Cut = height_field {
    "height_field.pgm" water_level .45 hierarchy off
    translate -.5 scale <2.1, 1.4, 1.7>
}
object { Cut pigment { color rgb <.8, .25, .2> }
    rotate -15*y translate <-1.5, -.1, -2.1> }
object { Cut pigment { color rgb <.3, .35, .8> } finish { reflection .3 }
    rotate <160, 40, 0> translate <3.1, 1.9, -.9> }

height_field {
    function 12, 4 { .4 + .35*sin(9*x) }
    smooth pigment { color rgb <.8, .7, .3> } finish { phong .4 }
    scale <2.4, .9, 1.3> rotate <-20, -30, 10> translate <.3, -.9, -2.7> }
height_field {
    function 3, 15 { .5 + .2*sin(13*y) + .3*y }
    smooth pigment { color rgb <.4, .7, .7> }
    scale <1.2, 1.5, 2> rotate <-15, 60, 0> translate <-1.2, .9, 2.6> }
