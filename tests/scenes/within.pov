// The camera is inside a solid; lights inside other solids, panes behind panes,
// surfaces that enclose no volume.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 20 }
background { rgb <.3, .4, .5> }
camera { location <.13, .07, -6> right 4/3*x angle 60 look_at 0 }
light_source { <0, 2.5, -3>, rgb .6 }
light_source { <2.6, .4, 1>, rgb <.5, .4, .3> } // in the hollow ball
light_source { <-2.8, 0, 0>, rgb <.2, .3, .5> } // in the lantern
#default { finish { ambient .1 diffuse .7 } }

// A room: its walls are the faces of the subtracted box.
difference {
    box { -9, 9 pigment { rgb .4 } }
    box { <-5, -2, -8>, <5, 3, 6> pigment { checker rgb .9 rgb .6 } }
    cylinder { <0, 0, 5>, <0, 0, 8>, 1.2 pigment { rgb <.3, .3, .8> } }
}
// A hollow ball with a window.
difference {
    sphere { 0, 1 }
    sphere { 0, .9 }
    cylinder { 0, -2*z, .5 }
    pigment { rgb <.9, .5, .3> }
    translate <2.6, .4, 1>
}
// A lantern of coloured panes.
difference {
    box { -.9, .9 }
    box { -.85, .85 }
    pigment { checker rgbt <1, .4, .2, .7> rgbf <.3, .9, .4, .8>
              scale .9 translate .3 }
    rotate 20*y
    translate <-2.8, 0, 0>
}
// An open pipe and an open cone, seen from outside and inside.
cylinder { <-1, -1.5, 1>, <.6, -1.2, 0>, .5 open pigment { rgb <.3, .7, .4> } }
cone { <0, 1.6, 2>, 1, <0, 2.6, 2>, .2 open
       pigment { rgbt <.8, .8, .3, .4> } }
// A slab with a round hole: its intersection with an inverted ball.
intersection {
    box { <-1, -.1, -1>, <1, .1, 1> }
    sphere { 0, .7 inverse }
    pigment { rgb <.8, .3, .6> }
    finish { reflection .3 }
    rotate <-30, 0, 15>
    translate <.3, -.4, -2.5>
}
