// Images on tiles and around objects: every map type and every interpolation,
// repeated and once; on spheres of the same appearance, in a mirror, as a sky.
// Transparent pixels transmit light and camera rays.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
camera { location <0, 8.5, -7> look_at <0, 0, -.2> angle 50 }
light_source { <-5, 9, -6>, .8 }
#default { finish { ambient .4 diffuse .6 } }
sky_sphere { pigment { image_map { "images.ppm" map_type 1 interpolate 2 } rotate 20*z } }
plane { y, -.6 pigment { image_map { ppm "images.ppm" } rotate 90*x scale 3 } }
#macro Tile (X, Z, P)
    box { <-.9, -.2, -.9>, <.9, 0, .9> pigment { P } translate <2*X, 0, 2*Z> }
#end
#macro Flat (Between, Once)
    pigment {
        image_map { png "images.png" #if (Between) interpolate Between #end #if (Once) once #end }
        rotate 90*x scale 1.3 translate <-.7, 0, -.5>
    }
#end
Tile (-2, 2, Flat (0, no))
Tile (-1, 2, Flat (2, no))
Tile (0, 2, Flat (4, no))
Tile (1, 2, Flat (0, yes))
Tile (2, 2, Flat (2, yes))
Tile (-2, 1, Flat (4, yes))
Tile (-1, 1, pigment { image_map { "images.png" gamma 1 } rotate <70, 0, 20> scale .8 })
Tile (0, 1, pigment { image_map { "images.png" gamma 2.2 } rotate <110, 0, 20> scale -.8 })
Tile (1, 1, pigment { image_map { "images.ppm" gamma srgb map_type 5 } scale .5 })
Tile (2, 1, pigment { image_map { <1, -1, 0> ppm "images.ppm" map_type 2 } rotate <0, 30, 20> scale .4 })
#declare Globe = pigment { image_map { png "images.png" map_type 1 once interpolate 2 } rotate <0, 50, 30> }
#declare Jacket = texture { pigment { image_map { png "images.png" map_type 2 once } translate -.5*y scale <1, .8, 1> } finish { phong .5 } }
#declare Tyre = pigment { image_map { ppm "images.ppm" map_type 5 interpolate 4 } }
#declare Window = pigment { image_map { ppm "images.ppm" once interpolate 2 } translate -.5 scale .9 }
sphere { 0, .8 pigment { Globe } translate <-4, .8, 0> }
cylinder { -.6*y, .6*y, .6 texture { Jacket } rotate 30*x translate <-2, .8, 0> }
torus { .6, .25 pigment { Tyre scale .6 rotate 20*y } rotate -40*x translate <0, .6, 0> }
box { <-.8, -.8, -.05>, <.8, .8, .05> pigment { Window } rotate <40, 20, 0> translate <2, .9, 0> }
sphere { 0, .8 pigment { Window } interior { ior 1.2 } finish { reflection .1 specular .5 } translate <4, .8, 0> }
sphere { <-3.6, .4, -2.5>, .6 pigment { Globe } }
sphere { <-2, .4, -2.5>, .6 pigment { Globe } finish { phong .6 metallic reflection { .1, .4 metallic } } }
sphere { <-.4, .4, -2.5>, .6 pigment { Window scale 2 } }
sphere { <1.2, .4, -2.5>, .6 texture { Jacket rotate 90*z } }
sphere { <3, .5, -2.7>, .7 pigment { rgb .1 } finish { reflection .8 } }
difference { sphere { 0, .8 } box { <-1, .2, -1>, 1 } pigment { Window scale <2, 1.5, 1> } interior { ior 1.4 }
    rotate -40*x translate <-1.2, .2, -3.6> }
