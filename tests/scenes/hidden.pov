// Objects that are invisible to the camera or in mirrors: in front of mirrors and in
// them, through glass, after total reflection, with separate materials, and transparent.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 9 adc_bailout 1/630 }
background { rgb <.3, .45, .6> }
camera { location <.3, 2.6, -8> right 4/3*x angle 46 look_at <.013, .717, 0> }
light_source { <-5, 9, -8>, rgb .7 }
light_source { <6, 7, -3>, rgb .3 }
#default { finish { ambient .15 diffuse .6 } }

plane { y, 0 pigment { checker rgb <.8, .75, .6>, rgb <.5, .55, .45> } finish { reflection .2 } }
plane { z, 7 pigment { rgb <.5, .4, .6> } no_image }
box { <-4.2, 0, 3.1>, <4.2, 3.3, 3.2> pigment { rgb .1 } finish { reflection .7 } }

// Enough for a hierarchy: some are visible to all rays, some hidden from one class or from both.
#declare Seen = sphere { 0, .22 pigment { rgb <.9, .7, .2> } }
#for (I, 0, 13)
    object {
        Seen
        #switch (mod(I, 4))
            #case (0) no_image pigment { rgb <.9, .2, .2> } #break
            #case (1) no_reflection pigment { rgb <.2, .3, .9> } #break
            #case (2) no_image no_reflection #break
        #end
        translate <-2.9 + .45*I, .25 + .06*mod(I, 3), 1.6 - .5*mod(I, 5)>
    }
#end
object { Seen no_image no_image off scale <1, 2, 1> translate <-3.4, .5, -.6> }

// A prism with total reflection, and glass in front of hidden objects.
intersection {
    box { <-.9, 0, -.9>, <.9, 1.4, .9> }
    plane { x - z, 0 }
    rotate 20*y translate <2.5, .02, -1.3>
    pigment { rgbt <.95, 1, .97, .9> }
    finish { diffuse .05 ambient .02 reflection .08 }
    interior { ior 1.5 }
}
sphere {
    <-2.2, .8, -1.6>, .75
    pigment { rgbf <1, .95, .9, .9> }
    finish { diffuse .05 ambient .02 reflection .1 }
    interior { ior 1.35 }
}
box { <-2.9, .05, .4>, <-1.9, 1.1, .9> pigment { rgb <.3, .8, .4> } no_image rotate 10*y }
cylinder { <-1.5, .05, .6>, <-1.3, 1.5, .8>, .25 pigment { rgb <.8, .4, .8> } no_reflection }
// Hidden transparent objects; a hidden solid, a hidden surface, a hidden clipped object.
sphere {
    <.5, .7, -2>, .6
    pigment { rgbf <.7, 1, .8, .8> } finish { diffuse .1 reflection .1 } interior { ior 1.3 }
    no_reflection
}
sphere {
    <-.6, 1.1, -.7>, .45
    pigment { rgbf <1, .8, .7, .8> } finish { diffuse .1 reflection .1 } interior { ior 1.2 }
    no_image
}
difference {
    sphere { 0, .6 }
    box { <-1, -.1, -1>, <1, .1, 0> pigment { rgb <.9, .9, .3> } }
    pigment { rgb <.3, .6, .8> }
    translate <1.4, 1.4, .8>
    no_image
}
union {
    torus { .35, .1 }
    merge { sphere { 0, .2 } sphere { .2*y, .18 } }
    pigment { rgb <.8, .5, .3> }
    rotate <-50, 20, 0> translate <.2, 1.5, 1>
    no_reflection
}
mesh {
    triangle { <2.4, 1.7, .5>, <3.6, 1.7, .7>, <3, 2.6, 1> }
    triangle { <2.4, 1.7, .5>, <3, 2.6, 1>, <2.3, 2.3, .9> }
    pigment { rgb <.6, .7, .3> } no_image
}
sphere {
    <3.4, .55, .9>, .5 clipped_by { plane { y, .6 } }
    pigment { rgb <.7, .3, .4> } no_reflection
}
