// Lathes: a goblet, a ring, open ones, one of glass, an inclined one; downward
// profiles, repeated points, horizontal and vertical segments.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 5 }
background { rgb <.3, .4, .6> }
camera { location <.6, 3.4, -7> look_at <0, .8, 0> angle 42 }
light_source { <-5, 8, -6>, .9 }
light_source { <6, 5, -3>, .4 }
plane { y, 0 pigment { checker rgb .35, rgb .75 } finish { reflection .1 } }

lathe { linear_spline 12, <0, 0>, <.9, 0>, <.9, 0>, <1, .1>, <.3, .3>, <.2, 1>,
    <.8, 1.4>, <.95, 2.2>, <.85, 2.2>, <.7, 1.5>, <0, 1.25>, <0, 1.25>
    pigment { rgb <.8, .55, .3> } finish { phong .6 }
}
lathe { 5, <.7, 0>, <.9, .3>, <.6, .5>, <.4, .2>, <.7, 0>       // closed
    pigment { rgb <.3, .7, .4> } rotate <-50, 20, 0> translate <-2.1, .7, -.8>
}
lathe { 3, <.25, 1.3>, <.5, .8>, <.6, 0>                        // open, downwards
    pigment { rgb <.4, .5, .9> } finish { specular .5 } translate <1.9, 0, -1.2>
}
lathe { linear_spline 7, <0, 1.5>, <.25, 1.35>, <.1, .9>, <.45, .5>, <.45, .1>, <.3, 0>,
    <0, 0>
    pigment { rgbf <.9, 1, .9, .9> } finish { reflection .1 }
    interior { ior 1.4 } translate <-1.3, .01, -2.4>
}
lathe { 2, <0, 0>, <.6, 1>                                      // a cone without base
    pigment { rgb <.9, .3, .3> } scale <1, 1.4, .6> rotate 15*z
    translate <2.2, 0, 1>
}
