// hills.pov - a lighthouse of cones among paraboloid hills, under an
// ellipsoidal airship.
#version 3.7;
global_settings { assumed_gamma 1.0 }

background { color rgb <0.4, 0.55, 0.72> }

camera {
    location <0, 2.6, -13>
    right x * image_width / image_height
    angle 44
    look_at <0, 2.3, 0>
}

light_source { <-9, 12, -10>, color rgb <1, 0.95, 0.85> }
light_source { <10, 5, -6>, color rgb <0.16, 0.2, 0.28> shadowless }

#declare Matt = finish { ambient 0.16 diffuse 0.72 }
#declare Paint = finish { ambient 0.14 diffuse 0.65 phong 0.4 phong_size 30 }
#declare Meadow = texture {
    pigment { color rgb <0.16, 0.3, 0.07> }
    finish { Matt }
}

plane { y, 0 pigment { color rgb <0.05, 0.2, 0.3> } finish { Paint } }

// A hill of height H, whose base has the half axes E and F:
//     x^2 / E^2 + z^2 / F^2 + y / H = 1.
quadric {
    <1 / 9, 0, 1 / 4>, 0, <0, 1 / 1.7, 0>, -1
    translate <3, 0, 2>
    texture { Meadow }
}
quadric {
    <1 / 25, 0, 1 / 9>, 0, <0, 1 / 2.4, 0>, -1
    translate <-4.5, 0, 6>
    texture { Meadow pigment { color rgb <0.13, 0.24, 0.09> } }
}
quadric {
    <1 / 7, 0, 1 / 3>, <0, 0.05, 0>, <0, 1 / 0.6, 0>, -1
    translate <-3.4, 0, -2>
    texture { Meadow pigment { color rgb <0.3, 0.32, 0.1> } }
}

// The lighthouse: frustums, an open lampshade and a conical roof.
#declare Red = pigment { color rgb <0.6, 0.05, 0.04> }
#declare White_Lime = pigment { color rgb 0.8 }
#declare Post = cylinder {
    <0.4, 2.45, 0.1>, <0.4, 3, 0.1>, 0.03 pigment { color rgb 0.3 }
}
union {
    cone { 0, 0.62, 0.75 * y, 0.545 pigment { White_Lime } }
    cone { 0.75 * y, 0.545, 1.5 * y, 0.47 pigment { Red } }
    cone { 1.5 * y, 0.47, 2.25 * y, 0.395 pigment { White_Lime } }
    cone { 2.25 * y, 0.395, 2.5 * y, 0.6 open pigment { Red } }
    sphere { 2.75 * y, 0.22 pigment { color rgb <1, 0.85, 0.4> }
             finish { ambient 0.8 diffuse 0.2 } }
    object { Post } object { Post rotate 90 * y }
    object { Post rotate 180 * y } object { Post rotate 270 * y }
    cone { 2.95 * y, 0.56, 3.6 * y, 0 pigment { Red } }
    finish { Paint }
    scale 1.15
    translate <2.6, 1.6, 1.8>
}

// Firs.
#declare Needles = pigment { color rgb <0.03, 0.17, 0.08> }
#declare Fir = union {
    cylinder { -0.4 * y, 0.4 * y, 0.09
               pigment { color rgb <0.25, 0.14, 0.06> } }
    cone { 0.25 * y, 0.62, 1.05 * y, 0.1 pigment { Needles } }
    cone { 0.75 * y, 0.5, 1.5 * y, 0.06 pigment { Needles } }
    cone { 1.2 * y, 0.36, 2 * y, 0 pigment { Needles } }
    finish { Matt }
}
object { Fir translate <-3.9, 0.5, -2.1> }
object { Fir scale 0.8 translate <-2.7, 0.45, -2.2> }
object { Fir scale 1.25 translate <-4.9, 1.8, 4.2> }
object { Fir scale 1.1 translate <-2.8, 1.5, 4.4> }
object { Fir scale 0.6 translate <4.6, 0.9, 1.4> }

// The airship: an ellipsoid, with fins and a gondola below.
union {
    sphere { 0, 1 scale <2.1, 0.62, 0.62> }
    cone { <1.2, 0, 0>, 0.05, <2.15, 0, 0>, 0.75 scale <1, 1, 0.06> }
    cone { <1.2, 0, 0>, 0.05, <2.15, 0, 0>, 0.75 scale <1, 0.06, 1> }
    sphere { 0, 1 scale <0.5, 0.16, 0.18> translate <-0.35, -0.7, 0>
             pigment { color rgb <0.12, 0.12, 0.15> } }
    pigment { color rgb <0.62, 0.62, 0.66> }
    finish { ambient 0.14 diffuse 0.6 specular 0.5 roughness 0.03 }
    rotate <0, -24, 5>
    translate <-1.6, 4.3, 1>
}
