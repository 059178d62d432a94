// Effects of normals with patterns: reflected rays that would go below the surface,
// rays through transparent bodies, also where they see the back of a normal, metals,
// Fresnel reflection, inverted parts.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 3 }
background { rgb <.3, .4, .6> }
camera { location <0, 4, -9> look_at <0, .6, 0> angle 46 }
light_source { <-4, 7, -6>, rgb 1 }
#default { finish { ambient .1 diffuse .6 specular .3 roughness .04 phong .2 } }
plane { y, -.01 pigment { rgb .8 } finish { reflection .4 } normal { leopard .4 scale .3 } }
sphere { <-2.4, 1, 0>, 1 pigment { rgb <1, .9, .7> } finish { reflection { .1, .9 metallic falloff 2 } metallic }
    normal { onion 2 sine_wave scale .4 rotate 30*x } }
sphere { <0, 1, 0>, 1 pigment { rgbf <.7, .9, 1, .8> } interior { ior 1.4 } finish { reflection { 0, 1 fresnel } }
    normal { gradient <1, 1, 1>, 1 triangle_wave scale .4 } }
sphere { <2.4, 1, 0>, 1 pigment { rgbt <.6, 1, .7, .7> } interior { ior 1.2 } finish { reflection .2 }
    normal { spherical 2 frequency 3 sine_wave translate <2.2, 1.1, -.4> } }
difference {
    sphere { <-1.3, .5, -2>, .5 }
    box { <-2, .5, -3>, <0, 2, 0> }
    pigment { rgb 1 } finish { reflection .5 }
    normal { cylindrical 1.5 frequency 2 scallop_wave scale .3 }
}
sphere { <1.3, .5, -2>, .5 pigment { rgb .2 } finish { reflection .8 }
    normal { planar 4 frequency 3 poly_wave 2 scale .3 rotate 40*z } }
disc { <0, .6, -2.6>, <0, 1, -.3>, .6 pigment { rgbt <.8, .9, 1, .6> } finish { reflection { .2, .9 } }
    normal { radial 2 frequency 5 sine_wave translate -2.6*z } }
