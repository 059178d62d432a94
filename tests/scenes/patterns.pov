// Patterns without noise, each on a tile, translated and rotated; with all waves,
// with frequencies and phases; on curved objects, in mirrors; one as a sky.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 3 }
camera { location <0, 8.5, -7> look_at <0, 0, -.2> angle 50 }
light_source { <-5, 9, -6>, .8 }
#default { finish { ambient .4 diffuse .6 } }
sky_sphere { pigment { planar triangle_wave frequency 3
    color_map { [0 rgb <.2, .3, .7>] [1 rgb <.9, .8, .6>] } scale 1.3 } }
#declare Map = color_map { [0 rgb <.1, .1, .4>] [.4 rgb <.9, .5, .1>]
    [.4 rgb <.2, .7, .3>] [1 rgb <1, 1, .8>] }
#macro Tile (X, Z, P)
    box { <-.9, -.2, -.9>, <.9, 0, .9> pigment { P } translate <2*X, 0, 2*Z> }
#end
Tile (-2, 2, pigment { planar color_map { Map } rotate 70*x scale .8 })
Tile (-1, 2, pigment { spherical color_map { Map } scale 1.2 })
Tile (0, 2, pigment { cylindrical color_map { Map } rotate <30, 0, 40> scale 1.1 })
Tile (1, 2, pigment { boxed color_map { Map } rotate 25*y scale <1, 1, .7> })
Tile (2, 2, pigment { onion color_map { Map } scale .3 translate .4*x })
Tile (-2, 1, pigment { leopard color_map { Map } scale .1 rotate 20*y })
Tile (-1, 1, pigment { radial rotate <20, 0, 10> })
Tile (0, 1, pigment { radial color_map { Map } frequency 6.5 phase .3 sine_wave })
Tile (1, 1, pigment { brick scale .12 translate <.1, -.05, 0> rotate 90*x })
Tile (2, 1, pigment { brick rgb <.2, .2, .5> rgb <.8, .7, .2>
    brick_size <.5, .2, .3> mortar .04 })
Tile (-2, 0, pigment { hexagon scale .3 rotate 10*y })
Tile (-1, 0, pigment { hexagon pigment { rgb <.9, .3, .3> }
    pigment { rgb .2 } pigment { rgb <.9, .9, .5> } scale <.2, 1, .3> })
Tile (0, 0, pigment { gradient <1, 0, 1> color_map { Map } frequency 2.5 })
Tile (1, 0, pigment { gradient x triangle_wave color_map { Map } scale .4 })
Tile (2, 0, pigment { gradient z scallop_wave scale .5 })
Tile (-2, -1, pigment { gradient x cubic_wave color_map { Map } scale .7 })
Tile (-1, -1, pigment { gradient x poly_wave .4 color_map { Map } scale .7 })
Tile (0, -1, pigment { spherical poly_wave 2 frequency -3.2 phase 7 })
Tile (1, -1, pigment { onion frequency 0 scale .4 })
Tile (2, -1, pigment { gradient <1, 2, 3> frequency 0 phase .3 })
sphere { <-4, .6, -3.6>, .6 pigment { leopard color_map { Map } scale .08 } }
sphere { <-2, .6, -3.6>, .6 pigment { radial color_map { Map } frequency 3
    translate <-2, 0, -3.6> } finish { reflection .3 } }
sphere { 0, .6 pigment { hexagon scale .15 rotate 90*x } translate <0, .6, -3.6> }
cylinder { <2, 0, -3.6>, <2, 1, -3.6>, .5 pigment { brick scale .1 } }
#declare Waves = pigment { leopard color_map { Map } scale .1 }
sphere { <-3, .3, 3.5>, .3 pigment { Waves } }
sphere { <-2, .3, 3.5>, .3 pigment { Waves triangle_wave } }
sphere { <-1, .3, 3.5>, .3 pigment { Waves frequency 2 } }
sphere { <0, .3, 3.5>, .3 pigment { Waves frequency 2 } }
#declare Listed = pigment { hexagon rgb <.9, .2, .1> rgb .9 rgb <.2, .3, .8> scale .08 rotate 90*x }
sphere { <1, .3, 3.5>, .3 pigment { Listed } }
sphere { <2, .3, 3.5>, .3 pigment { Listed frequency .4 phase .15 } }
sphere { <3, .3, 3.5>, .3 pigment { Listed checker frequency .4 sine_wave scale 2 } }
sphere { <-4, .3, 3.5>, .3 pigment { Listed brick frequency .3 cubic_wave brick_size .3 mortar .04 } }
sphere { <4, .6, -3.6>, .6 pigment { rgb .1 } finish { reflection .8 } }
