// Images that are smaller than the precision of coordinates: a point in them is at an
// edge, or its position is arbitrary.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -9> look_at 0 angle 40 }
light_source { <-5, 9, -6>, .8 }
#declare Tiny = pigment { image_map { ppm "images_plain.ppm" } }
#declare Smooth = pigment { image_map { ppm "images_plain.ppm" interpolate 2 } }
plane { y, -1 pigment { Tiny rotate 90*x scale 1e-20 } }
box { -.5, .5 pigment { Smooth scale 1e-18 } rotate 30*y translate -2.5*x }
sphere { 0, .7 pigment { image_map { ppm "images_plain.ppm" map_type 5 interpolate 4 } scale 1e-100 } }
cylinder { -.7*y, .7*y, .6 pigment { image_map { ppm "images_plain.ppm" map_type 2 } scale 1e-15 } translate 2.5*x }
sphere { <0, 0, -3>, .6 pigment { Tiny scale 1e-13 } finish { reflection .3 } }
