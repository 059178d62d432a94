// Tori and quartics, under transforms that are not rigid, near and far.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <.08, .07, .1> }
camera { location <-.6, 4, -9> look_at <0, .5, 0> angle 46 }
light_source { <6, 9, -8>, rgb 1 }
light_source { <-8, 4, -3>, rgb <.3, .35, .5> }
#default { finish { ambient .12 diffuse .6 specular .4 roughness .02 } }
torus { .7, .2 sturm rotate <-30, 0, 20> translate <-2.9, .7, -1.5>
    pigment { rgb <.8, .3, .2> } no_shadow }
torus { .8, .02 sturm rotate <20, 0, -40> translate <-2.8, .8, -1.4>
    pigment { rgb <.9, .8, .2> } no_shadow }
torus { .4, .4 sturm scale <1, 1.4, .8> rotate <-40, 10, 0>
    translate <-1.1, .8, -2> pigment { rgb <.2, .6, .7> } no_shadow }
torus { .3, .6 sturm matrix <.8, .1, 0, .2, .7, .1, 0, -.2, .9, .9, .6, -2>
    pigment { checker rgb <.3, .7, .3>, rgb <.9, .9, .7> scale .3 } no_shadow }
torus { 1e3, 3e2 sturm scale 1e-3 rotate 70*x translate <2.9, 1.2, -1.2>
    pigment { rgb <.6, .4, .8> } no_shadow }
torus { 4, .8 sturm rotate 90*x translate <0, 1, 15>
    pigment { rgb <.4, .4, .5> } no_shadow }
// x^4 + y^4 + z^4 = 1; a surface whose terms of degree four are all 0
quartic { <1,0,0,0,0,0,0,0,0,0, 0,0,0,0,0,0,0,0,0,0, 1,0,0,0,0,0,0,0,0,0,
    1,0,0,0,-1> sturm scale <.7, .5, .6> rotate <20, 30, 0>
    translate <-1.4, .7, .4> pigment { rgb <.8, .5, .3> } no_shadow }
quartic { <0,0,0,0,0,0,0,0,0,2, 0,0,0,0,0,0,0,0,0,0, 0,0,0,0,0,1,0,0,0,0,
    0,0,3,0,-1> sturm translate <.4, .8, .6>
    pigment { rgb <.3, .5, .9> } no_shadow }
// the Roman surface, scaled differently along each axis
quartic { <0,0,0,0,1,0,0,1,0,0, 0,0,0,0,-1,0,0,0,0,0, 0,0,0,1,0,0,0,0,0,0,
    0,0,0,0,0> sturm scale <2, 1.4, 1.8> rotate <-40, 0, 30>
    translate <2, .8, .8> pigment { rgb <.7, .2, .5> } no_shadow }
plane { y, -.4 pigment { checker rgb .5, rgb .35 } no_shadow }
