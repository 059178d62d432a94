// Tori in trees, with two intervals along a ray: cut, cutting and linked.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <.1, .1, .16> }
camera { location <0, 5, -9> look_at <0, .5, 0> angle 46 }
light_source { <-6, 9, -8>, rgb .9 }
#default { finish { ambient .13 diffuse .7 phong .3 } }
#declare A = pigment { rgb <.8, .4, .25> }
#declare B = pigment { rgb <.3, .55, .8> }
#declare Ring = torus { .8, .3 }
difference { object { Ring pigment { A } }
    object { Ring translate .7*x pigment { B } }
    translate <-3, .4, 0> }
intersection { object { Ring pigment { A } }
    object { Ring rotate 90*x pigment { B } }
    scale 1.5 translate <-.6, .8, .6> }
difference { torus { .8, .3 pigment { A } }
    torus { .8, .2 pigment { B } }
    box { <0, 0, -2>, <2, 2, 2> rotate 30*y } rotate -30*x
    translate <1.7, .8, .4> }
difference { box { <-.9, 0, -.9>, <.9, .5, .9> pigment { A } }
    torus { .6, .2 translate .5*y pigment { B } }
    rotate 20*y translate <3.6, 0, 0> }
merge { object { Ring pigment { A } }
    object { Ring rotate 90*z translate .8*x pigment { B } }
    scale .7 translate <-1.8, .6, -2.3> }
// a bead with a fillet at its foot
merge {
    difference { cylinder { 0, .4*y, .8 } torus { .8, .4 translate .4*y } }
    cylinder { 0, y, .4 }
    intersection { torus { .2, .2 } plane { -y, 0 } translate y }
    cylinder { y, 1.2*y, .2 }
    pigment { A } translate <1.2, 0, -2.2>
}
plane { y, 0 pigment { checker rgb .6, rgb .45 } }
