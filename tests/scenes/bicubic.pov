// Bicubic patches: a bent sheet; a bowl of four patches, each with an edge of length
// 0; a coarse one; a stretched one, whose flatness is that of the transformed patch.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 6 }
camera { location <1, 4.5, -9> look_at <0, .2, 0> angle 42 }
light_source { <6, 12, -9>, rgb .9 }
light_source { <-8, 5, -4>, rgb <.2, .25, .4> }
background { color rgb <.15, .2, .3> }

plane { y, -1.25 pigment { checker color rgb .85 color rgb .4 scale .7 } }

#declare Sheet = bicubic_patch {
    type 1 flatness .02 u_steps 4 v_steps 3
    <-1.5, .5, -1.5>, <-.5, -.5, -1.5>, <.5, 1, -1.5>, <1.5, 0, -1.5>,
    <-1.5, 0, -.5>, <-.5, 1.5, -.5>, <.5, -1, -.5>, <1.5, .5, -.5>,
    <-1.5, 1, .5>, <-.5, -1, .5>, <.5, 2, .5>, <1.5, .5, .5>,
    <-1.5, 0, 1.5>, <-.5, .5, 1.5>, <.5, 0, 1.5>, <1.5, 1, 1.5>
}

object { Sheet pigment { color rgb <.5, .65, .3> } finish { specular .3 roughness .05 }
    rotate -20*y translate <-2.2, -.3, 1.6> }
object { Sheet scale <.6, .2, .6> pigment { color rgb <.8, .5, .3> } finish { phong .5 }
    rotate <-70, 15, 0> translate <2.8, .6, 1> }

#declare K = .5523;
#macro Quarter(A)
    bicubic_patch {
        type 0 flatness 0 u_steps 3 v_steps 4
        <0, -1, 0>, <0, -1, 0>, <0, -1, 0>, <0, -1, 0>,
        <K, -1, 0>, <K, -1, K*K>, <K*K, -1, K>, <0, -1, K>,
        <1, -K, 0>, <1, -K, K>, <K, -K, 1>, <0, -K, 1>,
        <1, 0, 0>, <1, 0, K>, <K, 0, 1>, <0, 0, 1>
        rotate A*y }
#end
union { Quarter(0) Quarter(90) Quarter(180) Quarter(270)
    pigment { color rgb .3 } finish { reflection .5 phong .8 }
    scale <1.2, 1, 1.2> translate <.9, -.2, -1.4> }

bicubic_patch {                               // two triangles are enough
    type 1 flatness 9 u_steps 5 v_steps 5
    <-.7, 0, 0>, <-.2, .3, 0>, <.3, 0, .2>, <.7, .1, 0>,
    <-.7, .4, 0>, <-.2, .6, .4>, <.3, .4, .2>, <.7, .5, .1>,
    <-.7, .8, 0>, <-.2, 1, 0>, <.3, .8, .3>, <.7, .9, 0>,
    <-.7, 1.2, .1>, <-.2, 1.4, 0>, <.3, 1.2, 0>, <.7, 1.3, .2>
    pigment { color rgb <.7, .3, .3> } rotate 25*y translate <-2.6, -1.2, -1.5> }
