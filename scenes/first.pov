// first.pov - one of each primitive on a checkered floor.
//
// POV-Ray 3.7 renders the same file.  The first light casts shadows; the second
// is shadowless (POV-Ray gives such a light no highlights, either).
#version 3.7;
#include "colors.inc"
global_settings { assumed_gamma 1.0 }

background { color rgb <0.08, 0.14, 0.25> }

camera {
    location <2.8, 4.2, -7>
    right x * image_width / image_height
    angle 42
    look_at <0.1, 0.65, 0.1>
}

light_source { <6, 9, -8>, color rgb 0.95 }
light_source { <-9, 5, -3>, color rgb <0.25, 0.32, 0.45> shadowless }

#declare Glossy = finish {
    ambient 0.12 diffuse 0.65 specular 0.7 roughness 0.015
}
#declare Floor = pigment {
    checker color White * 0.6, color rgb <0.07, 0.09, 0.13>
}

plane {
    y, 0
    pigment { Floor }
    finish { ambient 0.15 diffuse 0.7 }
}

sphere {
    <0, 1, 0.4>, 1
    pigment { color rgb <0.55, 0.05, 0.04> }
    finish { Glossy }
}

box {
    <-0.7, 0, -0.7>, <0.7, 1.4, 0.7>
    pigment { color rgb <0.06, 0.33, 0.42> }
    finish { phong 0.4 phong_size 30 }
    rotate 28 * y
    translate <-2.05, 0, 0.5>
}

cylinder {
    <2, 0, 0.9>, <2, 1.9, 0.9>, 0.55
    pigment { color Gold * 0.9 }
    finish { Glossy }
}

// A lens: a ball with different scales along the axes.
sphere {
    0, 0.5
    scale <1.35, 0.45, 1.35>
    rotate -12 * z
    translate <1.15, 0.27, -1.35>
    pigment { color rgb <0.08, 0.36, 0.12> }
    finish { Glossy }
}
