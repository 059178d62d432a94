// Discs and rings: alone, transformed, transparent, in a shadow, as mirrors, and in solids.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 6 }
camera { location <1, 4, -9> look_at <.2, .2, 0> angle 42 }
light_source { <6, 12, -9>, rgb .9 }
background { color rgb <.15, .2, .3> }

plane { y, -1.2 pigment { checker color rgb .85 color rgb .4 scale .7 } }

#declare Ring = disc { <0, .3, 0>, <1, 4, -2>, 1.1, .5 }

object { Ring pigment { color rgb <.9, .4, .2> } finish { phong .6 } translate <-2.4, .2, -.5> }
object { Ring pigment { color rgb <.3, .5, .9> } scale <1.4, .6, .5> rotate <-40, 30, 20> translate <2.6, .3, -1> }
disc { <.2, .6, 1.5>, <.4, .1, -1>, 1.3 pigment { color rgb .2 } finish { reflection .7 } }
disc { <-.6, -.2, -2.2>, <.3, 1, -1>, .6 pigment { color rgbf <.9, .95, 1, .8> } interior { ior 1.3 } }
union {                                       // one above the other
    disc { 0, y, .8 pigment { color rgb <.8, .8, .2> } }
    disc { .2*y, y, .6, .2 pigment { color rgb <.2, .7, .3> } no_shadow }
    translate <1.6, -1, -2.6>
}
difference {                                  // subtracts a half-space; shows the disc only
    sphere { 0, .8 pigment { color rgb <.5, .3, .6> } }
    disc { .1*y, -y - .3*z, .5 pigment { color rgb <.9, .9, .4> } }
    translate <-1.2, .4, 2.6>
}
difference {                                  // the ring shows the inside of the sphere
    sphere { 0, .8 pigment { color rgb <.3, .6, .6> } }
    disc { 0, <.2, .4, 1>, 2, .4 pigment { color rgb <.9, .6, .4> } inverse }
    translate <2.9, .5, 2.5>
}
