// The camera is in a cavity of a solid, in front of the face of a half-space, and
// inside both parts of a transparent intersection.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <.2, .25, .35> }
camera { location <0, .1, -1> look_at <.2, 0, 3> angle 84 }
light_source { <-.5, 1.4, -.8>, rgb .8 }
light_source { <4, 6, 8>, rgb <.3, .3, .4> }
#default { finish { ambient .15 diffuse .7 } }
// a hollow ball around the camera, whose wall is open on three sides
difference {
    sphere { 0, 3 pigment { checker rgb <.7, .5, .3>, rgb <.5, .35, .2> } }
    sphere { 0, 2.8 pigment { checker rgb <.5, .6, .4>, rgb <.4, .5, .3> } }
    cylinder { -5*x, 5*x, 1.2 }
    box { <-1.3, -1.1, 0>, <1.3, 1.2, 9> rotate 10*y }
    pigment { rgb <.3, .3, .7> }
}
// the camera is inside both of these, and sees the end of both
intersection {
    sphere { <0, 0, -.5>, 1.4 }
    box { <-3, -.6, -2>, <.8, .7, 3> }
    pigment { rgbt <.9, .5, .3, .7> }
}
// the camera is inside neither of these, but between them
merge {
    difference {
        cylinder { -.15*y, .15*y, 2.3 }
        cylinder { -y, y, 2.1 }
        box { <.2, -1, 0>, <2, 1, 3> }
    }
    torus { 1.9, .15 translate -.5*y }
    intersection { plane { -y, -1 } sphere { 0, 1.8 } }
    pigment { checker rgb <.8, .3, .2>, rgb <.9, .6, .4> scale .3 }
}
torus { .9, .25 rotate <70, 0, 20> translate <1, .1, 6>
    pigment { rgb <.3, .7, .6> } }
intersection {
    plane { -z, 1.4 }
    quadric { <1, -1, 1>, 0, 0, -.1 }
    pigment { rgb <.7, .7, .2> } translate <-.3, 0, 5>
}
