// A yard with patterns: bricks, hexagons, stripes, rings, spots; with an umbrella.
#version 3.7;
global_settings { assumed_gamma 1 }
sky_sphere { pigment { gradient y color_map { [0 rgb <.85, .9, .95>] [.6 rgb <.25, .45, .8>] } } }
camera { location <1.2, 3.4, -10> right 4/3*x angle 46 look_at <0, 1.4, 0> }
light_source { <-8, 12, -9>, rgb .8 }
#default { finish { ambient .2 diffuse .65 } }

plane { y, 0 pigment { hexagon rgb <.75, .65, .55>, rgb <.65, .5, .4>, rgb <.8, .75, .7> scale .45 } }
// Walls.
box { <-7, 0, 4>, <7, 3.2, 4.6>
      pigment { brick rgb .75, rgb <.6, .25, .18> brick_size <.9, .3, .45> mortar .04 } }
box { <-7, 3.2, 3.9>, <7, 3.45, 4.7> pigment { rgb <.7, .68, .62> } }
cylinder { <-4.4, 0, 2.2>, <-4.4, 4.1, 2.2>, .45
           pigment { gradient y frequency 1 color_map { [.5 rgb <.2, .35, .6>] [.5 rgb .9] }
                     scale .9 rotate 30*x } }
// An umbrella, its pole and a table.
cone { <0, 3, .8>, 2.4, <0, 4.1, .8>, .02 open
       pigment { radial frequency 8 color_map { [.5 rgb <.85, .2, .15>] [.5 rgb <.95, .9, .8>] } translate <0, 0, .8> } }
cylinder { <0, 0, .8>, <0, 4.2, .8>, .06 pigment { rgb .5 } }
disc { <0, 1.1, .8>, y, 1.2, .1 pigment { onion color_map { [0 rgb <.6, .4, .2>] [1 rgb <.75, .55, .3>] } scale .12 translate <.4, .9, .2> } }
// Balls on the table and in front of it.
sphere { 0, .34 pigment { leopard color_map { [0 rgb <.9, .7, .2>] [.35 rgb <.35, .2, .1>] } scale .05 }
         finish { phong .4 } translate <-.5, 1.44, .6> }
sphere { 0, .3 pigment { spherical frequency 3 triangle_wave color_map { [0 rgb <.1, .4, .5>] [1 rgb <.9, .95, .8>] } scale .7 translate <.1, .2, -.2> }
         finish { phong .4 } translate <.45, 1.4, .4> }
sphere { 0, .8 pigment { boxed sine_wave frequency 3 color_map { [0 rgb <.6, .1, .3>] [1 rgb <.95, .8, .3>] } scale 1.1 }
         finish { phong .3 reflection .08 } rotate 30*y translate <-2.6, .8, -1.8> }
box { -.6, .6 pigment { cylindrical frequency 4 scallop_wave color_map { [0 rgb <.2, .3, .5>] [1 rgb <.7, .85, .9>] } rotate 90*x scale 1.2 }
      rotate 25*y translate <2.9, .6, -1.2> }
torus { .7, .25 pigment { planar frequency 6 cubic_wave color_map { [0 rgb <.2, .5, .25>] [1 rgb <.85, .9, .5>] } rotate 40*z scale .8 }
        finish { phong .5 } rotate -25*x translate <1, .4, -3.2> }
