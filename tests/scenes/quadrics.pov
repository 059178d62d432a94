// Cones and quadrics of each kind, under transforms that are not rigid.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <.06, .08, .12> }
camera { location <.5, 3.5, -9> look_at <0, .5, 0> angle 46 }
light_source { <6, 9, -8>, rgb 1 }
light_source { <-8, 4, -3>, rgb <.3, .35, .5> }
#default { finish { ambient .12 diffuse .6 specular .4 roughness .02 } }
// cones: pointed at either end, frustums, open, almost a cylinder, rotated
cone { <-3, 0, -2>, .6, <-3, 1.4, -2>, 0
    pigment { rgb <.8, .3, .2> } no_shadow }
cone { <-1.8, 0, -2.2>, 0, <-1.6, 1.2, -2>, .5 open
    pigment { rgb <.7, .6, .2> } no_shadow }
cone { <-.7, 0, -2.4>, .5, <-.4, .9, -2.2>, .25
    pigment { checker rgb <.2, .6, .7>, rgb <.9, .9, .8> scale .2 } no_shadow }
cone { 0, .3, 1.3*y, .3001 rotate <20, 0, 35> translate <.8, .3, -2.4>
    pigment { rgb <.3, .7, .3> } no_shadow }
cone { -y, .7, y, .1 open scale <1, .5, -.6> rotate <70, 30, 0>
    translate <2.1, .6, -2> pigment { rgb <.6, .3, .8> } no_shadow }
cone { x, .4, -x, .9 matrix <.5, .1, 0, .2, .6, .1, 0, -.2, .5, 3.3, .6, -1.6>
    pigment { rgb <.8, .5, .3> } no_shadow }
// an ellipsoid with mixed terms, and one by scaling
quadric { <1, 2, 1.5>, <.6, -.4, .3>, <.2, 0, -.1>, -.5
    translate <-2.6, 1, 0> pigment { rgb <.2, .4, .8> } no_shadow }
quadric { 1, 0, 0, -1 scale <.4, .9, .6> rotate <0, 20, 40>
    translate <-1, 1.1, 0> pigment { rgb <.8, .8, .3> } no_shadow }
// a paraboloid that opens downwards, a distant hyperboloid of two sheets
quadric { <2, 0, 1>, 0, y, -1.3 translate <.9, 0, .4>
    pigment { checker rgb <.2, .5, .3>, rgb <.1, .3, .2> scale .4 } no_shadow }
quadric { <-1, -1, .3>, 0, 0, -1 scale <.3, .3, 2> translate <-3, 2.6, 14>
    pigment { rgb <.5, .5, .6> } no_shadow }
// a cylinder, a double cone, a saddle, a pair of planes
quadric { <4, 0, 6>, 0, 0, -.5 rotate <0, 0, -4> translate <3, 0, 1.4>
    pigment { rgb <.7, .3, .4> } no_shadow }
quadric { <1, -.2, 1>, 0, 0, 0 translate <6, 3, 8>
    pigment { rgb <.4, .6, .6> } no_shadow }
quadric { 0, <0, .12, 0>, y, 0 translate <0, -.4, 2>
    pigment { checker rgb .6, rgb .4 } no_shadow }
quadric { <0, .01, -1>, 0, 0, -1 scale 40 translate 30*z
    pigment { rgb <.2, .25, .3> } no_shadow }
