// A mobile in front of a window: polygons with holes, discs, triangles, a mesh of
// smooth triangles, and patches. All of these are thin surfaces.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
background { rgb <.7, .8, .9> }
camera { location <.5, .7, -11> right 4/3*x angle 42 look_at <0, .45, 0> }
light_source { <-5, 7, -8>, rgb .75 }
light_source { <6, 2, -7>, rgb .25 shadowless }
#default { finish { ambient .2 diffuse .65 } }

// The wall with its window: a polygon with a hole for two panes.
polygon {
    15, <-9, -5>, <9, -5>, <9, 6>, <-9, 6>, <-9, -5>,
    <-2.6, -1.8>, <-.1, -1.8>, <-.1, 2.3>, <-2.6, 2.3>, <-2.6, -1.8>,
    <.1, -1.8>, <2.6, -1.8>, <2.6, 2.3>, <.1, 2.3>, <.1, -1.8>
    pigment { rgb <.85, .8, .7> }
    translate 2*z
}
polygon { 6, <-60, -30>, <60, -30>, <60, 3>, <5, 1.5>, <-60, -2>, <-60, -30> pigment { rgb <.35, .55, .3> } translate 30*z }

#macro Thread(Where, Top)
    cylinder { Where, <Where.x, Top, Where.z>, .012 pigment { rgb .3 } }
#end
#macro Rod(From, To) cylinder { From, To, .03 pigment { rgb <.5, .4, .3> } } #end
Rod(<-2.3, 2.3, 0>, <2.3, 2.5, 0>)
Rod(<-3, 1.1, -.6>, <-1.4, 1.2, .5>)
Rod(<1.3, 1.2, .5>, <3.1, 1.05, -.4>)
Thread(<0, 2.4, 0>, 5)
Thread(<-2.2, 1.15, 0>, 2.31)
Thread(<2.2, 1.13, .05>, 2.49)

// Rings of discs.
#for (I, 0, 3)
    disc { 0, <.4, .3, -1>, .62 - .14*I, .52 - .14*I
           pigment { rgb <.9, .3 + .15*I, .2> } finish { phong .4 }
           rotate 31*I*y translate <0, .9, 0> }
#end
Thread(<0, 1.5, 0>, 2.4)
// A star and a letter.
polygon {
    #local N = 5;
    2*N + 1
    #for (I, 0, 2*N) , <sin(I*pi/N), cos(I*pi/N)>*(mod(I, 2) ? .3 : .75) #end
    pigment { rgb <.95, .8, .2> }
    rotate <0, 25, 8> translate <-2.9, .2, -.55>
}
Thread(<-2.95, .9, -.57>, 1.1)
polygon {
    13, <-.5, -.6>, <-.3, -.6>, <-.17, -.2>, <.17, -.2>, <.3, -.6>, <.5, -.6>, <.08, .7>, <-.08, .7>, <-.5, -.6>,
    <-.11, .02>, <.11, .02>, <0, .38>, <-.11, .02>
    pigment { rgb <.3, .5, .85> }
    rotate -30*y translate <-1.4, .1, .45>
}
Thread(<-1.4, .78, .46>, 1.2)
// A bird of triangles.
#declare Wing = mesh {
    triangle { <0, 0, 0>, <.9, .35, .2>, <.35, -.05, .55> }
    triangle { <0, 0, 0>, <.9, .35, .2>, <.3, .1, -.3> }
    pigment { rgb .95 }
}
union {
    object { Wing rotate 15*z }
    object { Wing scale <-1, 1, 1> rotate -15*z }
    triangle { <0, .02, -.7>, <-.15, -.02, .65>, <.15, -.02, .65> pigment { rgb <.9, .6, .3> } }
    scale 1.15
    rotate <-50, 25, 0>
    translate <1.35, .1, .45>
}
Thread(<1.35, .1, .45>, 1.2)
// A bent leaf.
bicubic_patch {
    type 1 u_steps 4 v_steps 4
    <0, .9, 0>, <.1, .9, -.1>, <.2, .9, -.1>, <.05, .9, 0>,
    <-.5, .4, .2>, <-.1, .5, -.5>, <.3, .5, -.5>, <.6, .4, .2>,
    <-.5, -.1, .2>, <-.1, -.2, -.6>, <.3, -.2, -.6>, <.6, -.1, .2>,
    <0, -.8, 0>, <.1, -.8, -.1>, <.2, -.8, -.1>, <.1, -.9, 0>
    pigment { rgb <.4, .7, .35> }
    finish { phong .3 }
    rotate 40*y translate <3, -.2, -.35>
}
Thread(<3.05, .7, -.38>, 1.07)
