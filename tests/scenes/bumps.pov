// Normals with patterns: each pattern, lists, slope maps, normal maps, averages; transformed
// with the texture, with the object and alone, with and without scaling of the bumps.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <.3, .4, .6> }
camera { location <0, 6, -9> look_at <0, .4, 0> angle 46 }
light_source { <-4, 7, -6>, rgb .8 area_light x, z, 2, 2 }
light_source { <6, 4, -2>, rgb .3 }
#default { finish { ambient .1 diffuse .7 specular .3 roughness .04 phong .2 } }
#declare Ribs = normal { gradient y, 1 sine_wave scale .2 }
#declare Steps = slope_map { [.1 <0, 1>] [.4 <.5, -1>] [.4 <0, 0>] [.8 <1, .3>] }
plane { y, -.013 pigment { rgb .8 } normal { checker .4 scale .713 translate .013 } }
sphere { <-3, .6, 2>, .6 pigment { rgb <1, .9, .7> } normal { hexagon .6 scale .213 rotate 30*x } }
sphere { <-1.5, .6, 2>, .6 pigment { rgb <.7, .9, 1> } normal { brick .4 scale .0613 rotate 10*z } }
sphere { <0, .6, 2>, .6 pigment { rgb <.6, 1, .7> } normal { radial 1 frequency 8 triangle_wave scallop_wave } }
box { <1, 0, 1.4>, <2, 1.2, 2.6> pigment { rgb <1, .6, .7> } normal { leopard 1 scale .05 } }
sphere { <3, .6, 2>, .6 pigment { rgb .9 } normal { boxed 1 frequency 4 cubic_wave translate <3.1, .3, 1.2> } }
sphere { <-3, .5, .4>, .5 pigment { rgb .9 }
    normal { gradient <1, 1, 0>, 1.2 scallop_wave accuracy .05 scale .3 rotate 30*z } }
sphere { <-1.5, .5, .4>, .5 pigment { rgb 1 }
    normal { gradient x normal_map { [.2 gradient y, 1 scale .3] [.5 onion 2 sine_wave scale .2 rotate 20*x]
        [.9 leopard 2 scale .04] } scale .5 rotate <0, 20, 30> } }
torus { .4, .18 pigment { rgb <1, .8, .5> } normal { average normal_map { [gradient x, 2 triangle_wave]
        [2 gradient y, 2 sine_wave] [.5, radial 1 frequency 8 scale <1, 2, 1>] } scale .3 }
    rotate -40*x translate <0, .5, .4> }
cylinder { <1.1, 0, .4>, <1.9, .8, .4>, .4 pigment { rgb 1 } normal { gradient y slope_map { Steps } bump_size .7 scale .3 } }
sphere { <3, .5, .4>, .5 pigment { rgb 1 } normal { brick normal { gradient y, 1 scale .1 }
        normal { onion .8 scale .1 } brick_size <.41, .213, .317> mortar .053 } }
sphere { 0, 1 texture { pigment { rgb 1 } normal { gradient x, 1 sine_wave scale <.1, 1, 1> no_bump_scale }
        rotate 30*z } scale .5 translate <-2.4, .5, -1.2> }
sphere { 0, 1 texture { pigment { rgb <.7, .9, 1> } normal { gradient x, 1 sine_wave scale <.2, .1, 1> }
        rotate 30*z } scale <.5, .4, .5> translate <-1.2, .5, -1.2> }
sphere { <0, .5, -1.2>, .5 texture { pigment { rgb <.6, 1, .7> } no_bump_scale normal { gradient x, .1 sine_wave
        scale <3, .2, 1> normal_map { [0 gradient y, .3 cubic_wave scale .3] [1 gradient y .3 scale .1] } } } }
sphere { <1.2, .5, -1.2>, .5 texture { pigment { rgb 1 } normal { gradient y, 2 frequency 3 phase .2 accuracy .1
        matrix <.3, .1, 0, 0, .2, .1, .1, 0, .4, 0, 0, 0> } scale .5 } }
sphere { <2.4, .5, -1.2>, .5 pigment { rgb 1 } normal { hexagon normal { Ribs } normal { Ribs rotate 90*z }
        normal { Ribs 0 } scale .213 rotate 70*x } }
union { sphere { <-2, .3, -2.6>, .3 } box { <-1.2, 0, -2.9>, <-.6, .5, -2.3> pigment { rgb .7 } }
    pigment { rgb 1 } normal { planar 1 frequency 3 poly_wave 2 translate .2*y } }
sphere { <.3, .3, -2.6>, .3 pigment { rgb 1 } normal { spherical 1 scale .4 translate <.2, .4, -2.8> } }
sphere { <1.2, .3, -2.6>, .3 pigment { rgb 1 } normal { cylindrical 1 scale .4 rotate 40*x translate <1.2, .3, -2.7> } }
sphere { <2.1, .3, -2.6>, .3 pigment { rgb 1 } normal { Ribs bump_size 2 rotate 60*z } }
sphere { <-2.9, .3, -2.6>, .3 pigment { rgb 1 } normal { onion normal_map { [.4 Ribs bump_size .6 scale .5] } rotate 30*x } }
#declare Bead = sphere { 0, .2 pigment { rgb <1, .7, .4> } normal { onion 1 scale .1 translate <.1, .2, 0> } }
object { Bead translate <-.3, .2, -3.3> }
object { Bead rotate 90*y translate <.3, .2, -3.3> }
sphere { <-1.2, .25, -3.2>, .25 pigment { rgb .9 } normal { quilted 1 control0 0 control1 .5 scale .15 rotate 30*z } }
sphere { <1.4, .25, -3.3>, .25 pigment { rgb .9 } normal { onion normal_map { [.2 quilted -1 control0 .4 scale .1]
        [.7 radial 1 frequency 6] } translate <1.4, .2, -3.2> } }
