// Prisms with quadratic splines: a cross, one with a hole, an open one, one of glass,
// in solids; straight edges, repeated points, a loop of three points.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 5 }
background { rgb <.3, .4, .5> }
camera { location <.4, 5, -7> look_at <0, -.2, .2> angle 46 }
light_source { <-4, 8, -6>, .9 }
light_source { <6, 5, -3>, .4 }
plane { y, -1 pigment { checker rgb .35, rgb .75 } }

#declare Cross = prism { quadratic_spline linear_sweep -.4, .4, 12,
    <.2, -1>, <.2, .2>, <1, -.2>, <1, .2>, <.2, 1>, <-.2, 1>, <-1, .2>, <-1, -.2>,
    <-.2, .2>, <-.2, -1>, <.2, -1>, <.2, .2> }
#declare Holed = prism { linear_sweep quadratic_spline .3, -.4, 11,
    <0, -2>, <-1, -1>, <1, -1>, <1, 1>, <-1, 1>, <-1, -1>,
    <0, -1>, <-.5, -.5>, <.5, -.5>, <0, .5>, <-.5, -.5> }

object { Cross pigment { rgb <.8, .5, .3> } finish { phong .5 } }
object { Holed pigment { rgb <.3, .5, .8> } rotate -30*x translate 2.6*x }
prism { quadratic_spline -.5, .5, 6, <0, -2>, <-1, -1>, <1, -1>, <1, 1>, <-1, 1>, <-1, -1>
    open pigment { rgb <.3, .8, .4> } finish { specular .4 } rotate 20*z translate <-2.6, 0, .3>
}
prism { quadratic_spline 0, .5, 6, <-.7, 1>, <-.7, 0>, <.6, -.3>, <.8, .3>, <0, .5>, <-.7, 0>
    pigment { rgbf <.9, 1, .9, .9> } interior { ior 1.4 } finish { reflection .1 }
    rotate -70*x translate <.3, -.2, -2.2>
}
// Straight edges, one of which continues beyond its end.
prism { quadratic_spline -.2, .2, 7, <-3, 0>, <0, 0>, <1, 0>, <1.2, 0>, <.6, .9>, <.6, .9>, <0, 0>
    pigment { rgb <.9, .8, .3> } translate <-1.2, -.6, -2.4>
}
difference { object { Cross scale <1, 2, 1> } sphere { .6*y, .8 } object { Holed scale .35 translate .2*z }
    pigment { rgb <.7, .4, .7> } rotate -50*x translate <-1.4, .5, 2> }
intersection { box { -.8, .8 } object { Holed scale <.77, 3, .77> rotate 90*x inverse } plane { y, .4 }
    pigment { rgb <.8, .7, .5> } rotate 30*y translate <1.7, .4, 2.2> }
prism { quadratic_spline -.3, .3, 5, <1, -.4>, <-.5, 0>, <.5, .1>, <.6, .5>, <-.5, 0>
    clipped_by { plane { x, .1 } } pigment { rgb <.9, .4, .4> } rotate 40*y translate <1.9, -.6, -2.2> }
