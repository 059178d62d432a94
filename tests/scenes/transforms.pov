// Every primitive under transforms that are not rigid.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <.05, .08, .1> }
camera { location <1, 4, -9> look_at <0, .6, 0> sky <.1, 1, 0> angle 48 }
light_source { <6, 9, -8>, rgb 1 }
light_source { <-9, 5, 2>, rgb <.3, .4, .6> }
#declare Shiny = finish { ambient .1 diffuse .6 specular .7 roughness .01 }
#declare Dull = finish { ambient .15 diffuse .7 phong .2 phong_size 7.5 }
#declare Squares = pigment {
    checker rgb <.9, .6, .1>, rgb <.1, .3, .6>
    rotate <20, 30, 10> scale <.3, .5, .4> translate <.1, .2, .3>
}
sphere { 0, 1 scale <1.2, .5, .8> rotate <10, 40, 25> translate <-2.4, 1.2, 0>
    pigment { Squares } finish { Shiny } no_shadow }
box { -1, 1 matrix <.7, .1, 0, .2, .6, .3, 0, -.2, .5, .1, .9, -.6>
    pigment { rgb <.7, .2, .3> } finish { Dull } no_shadow }
cylinder { -y, y, .7 open scale <1.3, .8, .6> rotate <35, 0, 50>
    translate <2.3, 1.1, .4> pigment { Squares } finish { Shiny } no_shadow }
cylinder { <2.6, .1, -2>, <3.2, 1.4, -2.4>, .35 pigment { rgb <.3, .8, .5> }
    finish { Shiny } no_shadow }
union {
    sphere { <-.6, 0, 0>, .3 }
    cylinder { <-.6, 0, 0>, <.6, 0, 0>, .12 }
    box { <.4, -.3, -.3>, <.9, .3, .3> }
    scale <1, 1.4, 1> rotate 30*z translate <-2, .5, -2.4>
    pigment { rgb <.9, .9, .6> } finish { Dull } no_shadow
}
plane { <.1, 1, .05>, -.4 scale <1, .8, 1.2> pigment { Squares scale 2 }
    finish { Dull } no_shadow }
