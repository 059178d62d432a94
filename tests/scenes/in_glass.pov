// The camera is inside a ball of glass. In a row of overlapping balls, rays first
// leave the ball that they entered first.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 12 adc_bailout 1/500 }
background { rgb <.3, .4, .6> }
camera { location <0, .6, -7> right 4/3*x angle 52 look_at <.013, .217, 0> }
light_source { <-5, 9, -8>, rgb .8 }
#default { finish { ambient .1 diffuse .6 } }

plane { y, -1.2 pigment { rgb <.7, .6, .4> } }
box { <-4, -1.3, 4>, <4, 2.2, 4.5> pigment { rgb <.8, .4, .3> } }
sphere {
    <.1, .5, -6.9>, .9
    pigment { rgbt <.95, 1, 1, .9> }
    finish { reflection .1 phong .3 }
    interior { ior 1.15 }
}
#declare ball = sphere {
    0, .8
    pigment { rgbt <1, .95, .9, .93> }
    no_shadow
}
#for (I, 0, 4)
    object {
        ball
        interior { ior 1.1 + .05*I }
        translate <-.9 + .1*I, .1*I, -1 + .3*I>
    }
#end
// Mirrors whose reflection depends on the medium around them.
#for (I, 0, 2)
    object {
        ball
        finish { reflection { 0, 1 fresnel } }
        interior { ior 1.5 - .1*I }
        translate <1.1 - .05*I, .1*I, -.6 + .35*I>
    }
#end
