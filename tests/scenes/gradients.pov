// Gradients of skies and of surfaces; maps with steps, maps that begin after 0 and end
// before 1, named maps, the oldest syntax; translated, rotated, and transformed by a matrix.
// Values of surfaces are above 0, because POV-Ray takes 1.00001 for 1 in values below -1.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 5 }
camera { location <1, 2.2, -9> look_at <.2, .9, 0> angle 46 }
light_source { <6, 12, -9>, rgb .9 }
light_source { <-8, 5, -4>, rgb <.2, .25, .4> }
background { color rgb <1, 0, 0> }            // hidden by the sky

sky_sphere {
    pigment {
        gradient <.2, 1, .1>
        color_map { [0 rgb <.7, .8, 1>] [.3 rgb <.2, .4, .9>] [.31 rgb <.9, .9, .8>]
            [.36 rgb <.2, .4, .9>] [.7 rgb <.1, .1, .4>] [1 rgb <.7, .8, 1>] }
        scale 2
    }
    rotate <10, 0, 15>
}

#declare Steps = color_map { [.2 rgb <.9, .4, .2>] [.4 rgb <.9, .8, .3>] [.4 rgb <.2, .3, .6>]
    [.7 rgb <.3, .7, .5>] }

plane { y, -1.2
    pigment { gradient x + z color_map { [0, .5 color rgb .85 color rgb .6] [.5, 1 color rgb .3 color rgb .4] } scale 1.7 translate -340*x } }
sphere { <-2, .1, 0>, 1.1 pigment { gradient y color_map { Steps } scale .6 translate -1.9*y } finish { phong .6 } }
box { -.8, .8 pigment { gradient <1, 2, -1> translate <-9, -9, 0> scale <.7, .5, .9> rotate 30*y } rotate <20, 40, 0> translate <.6, 0, -.4> }
sphere { <2.9, .4, .5>, 1.2 pigment { color rgb .1 } finish { reflection .7 } }
merge {
    sphere { <1.4, -.3, -2.8>, .6 }
    cylinder { <1.4, -.3, -2.8>, <1.4, .9, -2.8>, .25 }
    pigment { gradient z color_map { Steps } translate -30*z matrix <.4, .1, 0, -.2, .5, .1, 0, .2, .3, .1, .2, .3> }
    finish { specular .4 roughness .03 } }
sphere { <-.6, -.5, -2.6>, .6 pigment { color rgbf <.9, 1, .95, .8> } interior { ior 1.4 } }
union {
    #for (I, 0, 5) sphere { <I*.55 - 3, 2.3, 2>, .25 } #end
    pigment { gradient x color_map { [0 rgb <1, .2, .2>] [.5 rgb <.2, 1, .2>] [1 rgb <.2, .2, 1>] } scale 3.4 translate -6.8*x } }
