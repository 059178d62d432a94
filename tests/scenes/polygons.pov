// Polygons: a square, one with a hole, a star that crosses itself, two parts, and a
// triangle aslant in space.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <.3, 1, -9> look_at <0, .1, 0> angle 50 }
light_source { <-5, 9, -9>, 1 }
background { rgb <.1, .2, .3> }
#default { finish { ambient .3 } }
polygon { 5, <-1, -1>, <1, -1>, <1, 1>, <-1, 1>, <-1, -1>
    pigment { rgb <.8, .3, .2> } rotate -20*y translate -2.6*x }
polygon { 10, <-1, -1>, <1, -1>, <1, 1>, <-1, 1>, <-1, -1>,
    <-.5, -.5>, <.5, -.5>, <.6, .5>, <-.4, .5>, <-.5, -.5>
    pigment { rgb <.2, .8, .2> } rotate 30*y }
polygon { 6, <0, 1>, <.588, -.809>, <-.951, .309>, <.951, .309>, <-.588, -.809>, <0, 1>
    pigment { rgb <.3, .4, .9> } translate 2.5*x }
polygon { 8, <0, 0>, <1, 0>, <.5, 1>, <0, 0>, <2, .5>, <3, .2>, <2.4, 1.3>, <2, .5>
    pigment { rgb <.9, .8, .2> } translate <-1.6, 1.5, .5> }
polygon { 4, <-3, -2, 2>, <3, -2, 1>, <0, 3, 4>, <-3, -2, 2>
    pigment { checker rgb 1 rgb .4 } }
