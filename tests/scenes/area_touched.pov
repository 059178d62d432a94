// Lights whose areas have points on what they shine on, just where rays of the camera
// meet it: at a distance of 0 nothing is before them, in no direction.  A pixel is 1
// wide at 120 x 90, 2 at 60 x 45.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -40> direction z right 120*x up 90*y }
#default { finish { ambient .1 diffuse .8 } }
light_source { <1, 0, -2>, .4 area_light 4*z, x, 3, 1 }
light_source { <11, 4, -4>, .4 area_light <4, 0, 8>, <0, 4, 0>, 5, 3 }
light_source { <-20.5, .5, -6>, .4 area_light 2*z, 4*y, 2, 3 }
plane { -z, 0 pigment { rgb .9 } }
sphere { <6.131, 6.217, -3.3>, 2.5 pigment { rgb <1, .6, .4> } }
box { <-30.2, -4.3, -5>, <-18.4, 8.1, -1.3> pigment { rgb <.5, .7, .9> } }
difference {
    box { <-6.1, -8.2, -4.3>, <4.1, -2.3, -1.2> }
    sphere { <0, -4, -4>, 2 }
    pigment { rgb <.6, .9, .5> }
}
triangle { <14.137, .219, -2.173>, <22.31, .077, -2.411>, <16.53, 9.13, -1.31> pigment { rgb .6 } }
torus { 4, 1 rotate 90*x translate <-12, 8, -2> pigment { rgb .8 } }
cylinder { <20.3, -8.1, -3.2>, <30.1, -4.2, -3.2>, 2 pigment { rgbt <.8, .8, .2, .5> } }
