// Coincident faces: parts that are cut off flush vanish, touching faces of a merge
// vanish, and two halves make a whole. POV-Ray shows noise here.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <.1, .12, .2> }
camera { location <1.5, 5, -10> look_at <.2, .4, 0> angle 46 }
light_source { <-6, 9, -8>, rgb .9 }
light_source { <7, 6, -5>, rgb <.25, .3, .4> }
#default { finish { ambient .12 diffuse .7 } }
#declare Red = pigment { rgb <.8, .25, .15> }
#declare Blue = pigment { rgb <.2, .4, .8> }
#declare Cube = box { <-.7, 0, -.7>, <.7, 1.4, .7> }
// the hole ends exactly at both faces
difference { object { Cube }
    box { <-.4, 0, -.4>, <.4, 1.4, .4> pigment { Blue } }
    pigment { Red } rotate 25*y translate <-3.6, 0, 0> }
// a solid minus itself, and minus one half of itself
difference { object { Cube } object { Cube pigment { Blue } }
    pigment { Red } translate <-1.9, 0, 1.5> }
difference {
    object { Cube }
    difference { object { Cube } plane { x, 0 } pigment { Blue } }
    pigment { Red } rotate -20*y translate <-1.5, 0, 0>
}
// halves of a ball and of a cylinder; adjacent cubes
merge {
    intersection { sphere { 0, .8 } plane { <1, .3, .2>, .1 } }
    intersection { sphere { 0, .8 } plane { <1, .3, .2>, .1 inverse } }
    pigment { Red } translate <.5, .8, -.6>
}
difference {
    merge { cylinder { 0, .7*y, .6 } cylinder { .7*y, 1.4*y, .6 } }
    plane { z, -.1 pigment { Blue } }
    pigment { Red } rotate 30*y translate <2, 0, .8>
}
merge { object { Cube } object { Cube translate 1.4*x } object { Cube }
    pigment { Red } scale .6 rotate 15*y translate <3, 0, -1> }
// the intersection of two boxes that share faces
intersection { object { Cube pigment { Red } }
    box { <-.7, 0, -.7>, <.2, 2, .7> pigment { Blue } }
    rotate 40*y translate <-.6, 0, -2.4> }
plane { y, 0 pigment { checker rgb .6, rgb .45 } }
