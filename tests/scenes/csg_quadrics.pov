// Quadrics of every kind in trees, with both signs of their coefficients: the inside
// is where the polynomial is negative, whether that region is bounded or not.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <.1, .14, .16> }
camera { location <.5, 5, -10> look_at <0, .7, 0> angle 48 }
light_source { <-6, 9, -8>, rgb .9 }
light_source { <8, 6, -5>, rgb <.25, .25, .35> }
#default { finish { ambient .13 diffuse .7 } }
#declare A = pigment { rgb <.8, .4, .25> }
#declare B = pigment { rgb <.3, .55, .8> }
#declare Cube = box { -.8, .8 pigment { A } }
#declare One_Sheet = quadric { <1, -1, 1>, 0, 0, -.15 pigment { B } }
#declare Outside = quadric { <-1, 1, -1>, 0, 0, .15 pigment { B } }
#declare Two_Sheets = quadric { <1, -1, 1>, 0, 0, .1 pigment { B } }
#declare Cup = quadric { <1, 0, 1>, 0, -y, 0 pigment { B } }
#declare Saddle = quadric { <1, 0, -1>, 0, y, 0 pigment { B } }
#declare Cross = quadric { 0, <0, -1, 0>, 0, 0 pigment { B } }
#declare Pipe = quadric { <4, 2, 0>, 0, 0, -.6 pigment { B } }
#declare Ball = quadric { -1, 0, 0, .9 pigment { B } }
intersection { object { Cube } object { One_Sheet } translate <-3.6, .8, 1> }
intersection { object { Cube } object { Outside }
    rotate 20*y translate <-1.6, .8, 1.4> }
difference { object { Cube } object { One_Sheet }
    rotate 35*y translate <.6, .8, 1.4> }
intersection { object { Cube } object { Two_Sheets } translate <2.6, .8, 1.2> }
difference { object { Cube } object { Cup translate -.5*y }
    rotate 30*y translate <-3.4, .8, -1.6> }
intersection { object { Cube } object { Saddle }
    rotate -25*y translate <-1.1, .8, -2> }
difference { object { Cube } object { Cross rotate 20*z }
    translate <1, .8, -1.6> }
difference { object { Cube } object { Pipe }
    rotate -15*y translate <3, .8, -1.4> }
difference { box { -.5, .5 pigment { A } } object { Ball scale .7 }
    translate <4.4, .5, .6> }
plane { y, 0 pigment { checker rgb .6, rgb .45 } }
