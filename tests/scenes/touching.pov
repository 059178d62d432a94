// Transparent bodies that touch each other: a ray passes the face of the later region
// first. The face of the other region is at the start of the next ray.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 12 adc_bailout 0 }
background { rgb <.3, .4, .6> }
camera { location <2.513, 4.017, -7.531> look_at <.013, .417, .021> right 4/3*x angle 43 }
light_source { <6, 12, -9>, 1 }

#default { finish { ambient .1 diffuse .3 } }
plane { y, 0 pigment { checker rgb <.9, .8, .7>, rgb <.5, .6, .7> scale .45 translate .11 } }
// Two bodies next to each other, and one on top of both.
box { <-2, 0, -1>, <-1, 1, 0> pigment { rgbf <.8, .9, 1, .9> } interior { ior 1.5 } }
box { <-1, 0, -1>, <0, 1, 0> pigment { rgbf <1, .9, .8, .9> } interior { ior 1.3 } }
cylinder { <-1, 1, -.5>, <-1, 1.6, -.5>, .5 pigment { rgbf .9 } interior { ior 1.4 } }
// Water in glass, with coincident faces.
difference {
    cylinder { 1.3*x, <1.3, 1.4, 0>, .8 }
    cylinder { <1.3, .2, 0>, <1.3, 1.5, 0>, .65 }
    pigment { rgbf .95 } interior { ior 1.5 } finish { reflection { .02, .6 fresnel } }
}
cylinder { <1.3, .2, 0>, <1.3, 1.1, 0>, .65 pigment { rgbf <.9, .95, 1, .9> } interior { ior 1.33 } }
// Three bodies that touch one plane; the middle one is a patch of triangles.
box { <-2, 0, 1>, <-1, .5, 2> pigment { rgbf .9 } interior { ior 1.2 } }
mesh {
    triangle { <-2.5, .5, .9>, <-.5, .5, .9>, <-.5, .5, 2.1> }
    triangle { <-2.5, .5, .9>, <-.5, .5, 2.1>, <-2.5, .5, 2.1> }
    pigment { rgbf <1, .8, .8, .9> }
}
merge {
    box { <-2, .5, 1>, <-1.5, 1, 2> }
    cone { <-1.4, .5, 1.5>, .5, <-1.4, 1.2, 1.5>, .1 }
    pigment { rgbf <.8, 1, .8, .9> } interior { ior 1.5 }
}
