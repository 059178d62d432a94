// Polygons: a sheet, a frame with two holes, one of which contains an island, a star
// that intersects itself, a leaning arrow, a mirror, a comb that casts shadows.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 6 }
camera { location <1, 4.5, -9> look_at <0, .2, 0> angle 42 }
light_source { <6, 12, -9>, rgb .9 }
light_source { <-8, 5, -4>, rgb <.2, .25, .4> }
background { color rgb <.15, .2, .3> }

plane { y, -1.25 pigment { checker color rgb .85 color rgb .4 scale .7 } }

polygon { 5, <-.9, -.6>, <.8, -.7>, <1, .5>, <-.7, .8>, <-.9, -.6>
    pigment { color rgb <.5, .65, .3> } finish { specular .3 roughness .05 }
    rotate <20, -25, 0> translate <-2.9, .1, 1.4> }

// The parts: an outline, two holes, and an island in the second hole.
polygon {
    19,
    <-1.5, -1>, <1.5, -1>, <1.5, 1>, <-1.5, 1>, <-1.5, -1>
    <-1.2, -.7>, <-.3, -.6>, <-.6, .7>, <-1.2, -.7>
    <.1, -.7>, <1.2, -.7>, <1.2, .8>, <.1, .6>, <.1, -.7>
    <.4, -.3>, <.9, -.4>, <1, .3>, <.5, .2>, <.4, -.3>
    pigment { checker color rgb <.9, .5, .2> color rgb <.9, .8, .6> scale .37 }
    finish { phong .5 }
    rotate <15, 20, 5> translate <1.9, .35, 1.1> }

#declare Star = polygon {
    6,
    #for (I, 0, 5) <sin(4*pi*mod(I, 5)/5), cos(4*pi*mod(I, 5)/5)> #end
}
object { Star pigment { color rgb <.9, .8, .2> } finish { ambient .3 phong .6 }
    rotate <10, 25, 3> translate <-2, .1, -1.6> }
object { Star pigment { color rgb <.8, .3, .3> }
    scale .7 rotate <80, 0, 10> translate <-.4, -.9, -2.9> }

// In a slanted plane: 3 x + 2 y + 2 z = 6.
#macro Aslant(X, Y) <X, Y, (6 - 3*X - 2*Y)/2> #end
polygon {
    8,
    Aslant(0, 0), Aslant(.5, -.5), Aslant(.5, .25), Aslant(1.25, .25),
    Aslant(.5, 1.5), Aslant(-.25, .25), Aslant(0, .25), Aslant(0, 0)
    pigment { color rgb <.4, .6, .9> } finish { phong .4 }
    scale .8 translate <2.5, -.4, -3.6> }

polygon { 7, <-1.8, 0>, <1.6, -.2>, <2, 1.1>, <.6, 2>, <-1, 1.8>, <-2, .9>, <-1.8, 0>
    pigment { color rgb .1 } finish { reflection .7 diffuse .2 }
    rotate <8, 12, 0> translate <-.3, -.7, 3.4> }

polygon {
    #local Teeth = 6;
    4*Teeth + 3,
    #for (I, 0, Teeth - 1)
        <I/3, 0, 0>, <I/3, 0, .8 + I/20>, <I/3 + .2, 0, .7>, <I/3 + .2, 0, 0>,
    #end
    <2, 0, -.2>, <0, 0, -.2>, <0, 0, 0>
    pigment { color rgb <.8, .7, .9> } rotate <-20, -10, 5> translate <-.4, -.2, -1.4> }
