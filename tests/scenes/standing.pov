// Transparent bodies on planes and boxes, whose lower faces coincide with the surface below.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
background { rgb <.3, .4, .6> }
camera { location <2.513, 4.017, -7.531> look_at <.013, .417, .021> right 4/3*x angle 43 }
light_source { <6, 12, -9>, 1 }

#default { pigment { rgbf <.9, .95, .92, .9> } finish { ambient .1 diffuse .3 } }
#declare Floor = pigment { checker rgb <.9, .8, .7>, rgb <.5, .6, .7> scale .45 translate .11 }

plane { y, 0 pigment { Floor } }
box { <-3, 0, -1.5>, <-2, .9, -.5> interior { ior 1.5 } }
cylinder { <-1, 0, -1.2>, <-1, .8, -1.2>, .55 interior { ior 1.33 } }
cone { <.5, 0, -1.3>, .6, <.5, .9, -1.3>, .2 interior { ior 1.5 } }
prism { linear_spline linear_sweep 0, .7, 5, <1.4, -1.8>, <2.6, -1.9>, <2.3, -.9>, <1.5, -.7>, <1.4, -1.8>
        interior { ior 1.4 } }
merge {
    box { <-2.6, 0, .6>, <-1.6, .6, 1.6> }
    cylinder { <-1.6, 0, 1.1>, <-1.6, .9, 1.1>, .5 }
    interior { ior 1.5 }
}
// On an opaque box, and next to it.
box { <0, 0, .6>, <1.2, .7, 1.8> pigment { checker rgb .9, rgb <.7, .3, .2> scale .21 translate .05 } }
cylinder { <.6, .7, 1.2>, <.6, 1.4, 1.2>, .4 interior { ior 1.5 } }
box { <1.2, 0, .8>, <1.9, .9, 1.5> interior { ior 1.5 } }
