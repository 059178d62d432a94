// Area lights with points on lit surfaces: on the top of a ball, exactly where a
// camera ray hits it. At distance 0 no object of any kind shadows the point. (Pixels
// have width 1 at 120 x 90, where a camera ray hits such a point of the second ball,
// and width 2 at 60 x 45. These balls have no shadows, because rounding decides
// whether they shadow themselves there.) Other points are within 1e-3 of the surface:
// outside, where the surface still shadows the objects behind it, and inside.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -40> direction z right 120*x up 90*y }
#default { finish { ambient .1 diffuse .8 } }
light_source { <1, 0, -2>, .4 area_light 4*z, x, 3, 1 }
light_source { <-20.5, .5, -4>, .4 area_light 8*z, x, 3, 1 }
light_source { <21.3, 17.2, -2>, .7 area_light 3.7996*z, x, 3, 1 }
light_source { <-21.3, -17.8, -2>, .7 area_light 3.8004*z, x, 3, 1 }
sphere { <1, 0, 3>, 3 pigment { rgb <1, .6, .4> } no_shadow }
sphere { <-20.5, .5, 5>, 5 pigment { rgb <.5, .7, .9> } no_shadow }
sphere { <21.3, 17.2, 3>, 3.1 pigment { rgb <.9, .8, .4> } }
sphere { <-21.3, -17.8, 3>, 3.1 pigment { rgb <.9, .8, .4> } }
plane { -z, -7.3 pigment { rgb .9 } }
box { <-34.2, -4.3, -5>, <-28.4, 8.1, -1.3> pigment { rgb <.5, .7, .9> } }
difference {
    box { <-6.1, -12.2, -4.3>, <4.1, -6.3, -1.2> }
    sphere { <0, -8, -4>, 2 }
    pigment { rgb <.6, .9, .5> }
}
triangle { <14.137, .219, -2.173>, <22.31, .077, -2.411>, <16.53, 9.13, -1.31> pigment { rgb .6 } }
torus { 4, 1 rotate 90*x translate <-11.2, 8.3, -2> pigment { rgb .8 } }
plane { y, -41 pigment { rgb .9 } }
disc { <9, 3, -1>, <1,2,3>, 2, 1 pigment { rgb .5 } }
quadric { <1, 1.3, 1.1>, <0, 0, 0>, <0, 0, 0>, -4 translate <-9, -7, -2> pigment { rgb .4 } }
quadric { <1, 1.3, -1.1>, <0, 0, 0>, <0, 0, 0>, -4 clipped_by { sphere { 0, 5 } } translate <19, -17, -2> pigment { rgb .4 } }
cone { <-20, 8, 0>, 3, <-24, 11, -2>, 1 pigment { rgb .6 } }
prism { linear_spline 0, 2, 5, <0, 0>, <3, 0>, <4, 3>, <-1, 2>, <0, 0> rotate -70*x translate <22, 14, -3> pigment { rgb .7 } }
quartic { <1,0,0,0,2,0,0,2,0,-10.4,0,0,0,0,0,0,0,0,0,0,1,0,0,2,0,5.6,0,0,0,0,1,0,-10.4,0,7.84> rotate 40*x translate <-14, -14, -1> pigment { rgb .8 } }
intersection { sphere { 0, 4 } box { -3, 3 rotate 20 } torus { 3, 1.5 inverse } translate <30, 6, 0> pigment { rgb .7 } }
merge { sphere { 0, 2 } sphere { 1.5*x, 2 } pigment { rgbt .7 } translate <-32, -6, 0> }
cylinder { <20.3, -8.1, -3.2>, <30.1, -4.2, -3.2>, 2 open pigment { rgbt <.8, .8, .2, .5> } }
mesh { triangle { <10, -10, -2>, <16, -10, -1>, <12, -15, -3> } triangle { <10, -10, -2>, <16, -10, -1>, <12, -5, -3> } pigment { rgb .6 } }
