// Steiner patches: flat, bent, bumpy, weighted, from the back, edge-on, degenerate;
// and a torus with an elliptical section.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <.1, .08, .1> }
camera { location <0, 3, -8> look_at <0, .8, 0> angle 44 }
light_source { <5, 9, -8>, rgb 1 }
light_source { <-8, 3, -4>, rgb <.3, .35, .4> }
#default { finish { ambient .12 diffuse .6 phong .5 phong_size 20 } }
steiner_patch { <-3, 0, 0>, <-1.5, 2, .5>, <-1, 0, -1>,
    <-2.25, 1, .25>, <-1.25, 1, -.25>, <-2, 0, -.5>
    pigment { rgb <.8, .5, .2> } no_shadow }
steiner_patch { <-1, 0, 0>, <0, 2.4, .6>, <1.2, 0, -.3>,
    <-1, 1.6, -1.4>, <1, 1.8, -1>, <.2, -.6, -1.6>
    pigment { checker rgb <.2, .6, .8>, rgb <.9, .9, .8> scale .25 } no_shadow }
steiner_patch { <-.8, 0, 0>, <0, 1.6, 0>, <.8, 0, 0>,
    <-1.6, 1.4, .8>, <1.4, 1.2, -.9>, <.3, -.8, .7>
    weights 1, 2, .5, 4, .3, 1.5
    translate <2.2, .3, 0> pigment { rgb <.5, .7, .3> } no_shadow }
steiner_patch { x, y, -x, y, 0, -y scale <.8, -1.2, .6> rotate <60, 30, 0>
    translate <-2.4, 1.9, 1> pigment { rgb <.7, .3, .6> } no_shadow }
// an edge that is a straight line of constant speed; a corner of three equal control points
steiner_patch { <0, 0, 0>, <0, 1, 1>, <2, 0, 0>, <.3, 1.2, .2>, <1, .5, .5>, x
    rotate 160*y translate <3, .9, 1> pigment { rgb <.3, .4, .9> } no_shadow }
steiner_patch { 0, x + y, x - y, 0, <1.6, 0, -1>, 0
    translate <-.6, 2.1, 1.4> pigment { rgb <.9, .3, .3> } no_shadow }
// second differences that are parallel to an edge: a bent patch and a flat one
steiner_patch { <-1, 0, 1>, 2*x, 0, <-1, .5, 0>, -x, 0
    scale .5 rotate <-40, 200, 0> translate <-.2, 1.5, -2.6>
    pigment { rgb <.3, .7, .7> } no_shadow }
steiner_patch { 0, <.4, .8, 0>, .8*x, 0, <.4, .8, 0>, .8*x
    translate <.8, .1, -3.2> pigment { rgb <.7, .7, .5> } no_shadow }
// a part of the sphere x^2 + y^2 + z^2 = 1
steiner_patch { z, y, x, <1, 1, 1>, <1, 1, -1>, <1, 1, 1>
    weights 2, 2, 2, 1, 1, 1
    translate <1, 2.2, 1> pigment { rgb <.9, .8, .3> } no_shadow }
elliptical_torus { .6, .12, .3 rotate <25, 0, -30> scale <1, 1.2, .9>
    translate <-.6, .1, -2.4> pigment { rgb <.4, .8, .7> } no_shadow }
plane { y, -.4 pigment { checker rgb .5, rgb .35 } no_shadow }
