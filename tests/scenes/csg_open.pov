// Open cylinders and cones in trees: the volume inside of them is cut away or kept,
// but the missing disks are not visible.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <.12, .16, .2> }
camera { location <0, 5, -9> look_at <0, .5, 0> angle 46 }
light_source { <-6, 9, -8>, rgb .9 }
#default { finish { ambient .14 diffuse .7 } }
#declare Wood = pigment { rgb <.7, .45, .2> }
#declare Lining = pigment { rgb <.2, .6, .7> }
difference { box { <-.8, 0, -.8>, <.8, 1.4, .8> pigment { Wood } }
    cylinder { .5*y, 2*y, .5 open pigment { Lining } }
    rotate 20*y translate -3*x }
difference { box { <-.8, 0, -.8>, <.8, 1.4, .8> pigment { Wood } }
    cone { .4*y, .2, 1.4*y, .6 open pigment { Lining } }
    rotate -20*y translate -.9*x }
intersection { sphere { .7*y, .9 pigment { Wood } }
    cylinder { 0, 1.5*y, .5 open pigment { Lining } } translate <1.1, 0, -1> }
merge { cylinder { 0, 1.2*y, .5 open pigment { Lining } }
    cone { .6*y, .8, 1.6*y, .3 open pigment { Wood } } translate <3, 0, 0> }
// half of a pipe, and a pipe through another one
difference { cylinder { -x, x, .5 open } plane { -y, 0 }
    pigment { Lining } rotate 30*y translate <-1.2, .52, -2.2> }
difference { cylinder { -x, x, .4 open pigment { Wood } }
    cylinder { -y, y, .25 open inverse pigment { Lining } }
    rotate 60*y translate <2.6, .7, -2.4> }
plane { y, 0 pigment { checker rgb .6, rgb .45 } }
