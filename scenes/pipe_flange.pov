// pipe_flange.pov - two pipes joined by bolted flanges, with a pressure gauge.
#version 3.7;
#include "colors.inc"
global_settings { assumed_gamma 1.0 }

background { color rgb <0.2, 0.25, 0.32> }

camera {
    location <-5.2, 4.1, -8.2>
    right x * image_width / image_height
    angle 46
    look_at <0.45, 0.3, 0>
}

light_source { <-5, 10, -8>, color rgb <1, 0.98, 0.94> }
light_source { <8, 3, -4>, color rgb <0.26, 0.26, 0.3> shadowless }

#declare Polished = finish {
    ambient 0.12 diffuse 0.55 specular 0.8 roughness 0.02
}
#declare Painted = finish { ambient 0.14 diffuse 0.7 phong 0.5 phong_size 45 }
#declare Rough = finish { ambient 0.16 diffuse 0.7 }

#declare Pipe_Paint = texture {
    pigment { color rgb <0.6, 0.12, 0.02> }
    finish { Painted }
}
#declare Iron = texture {
    pigment { color rgb <0.14, 0.17, 0.2> }
    finish { Polished }
}
#declare Bolt_Zinc = texture {
    pigment { color rgb <0.6, 0.57, 0.45> }
    finish { Polished }
}
#declare Rubber = texture {
    pigment { color Gray05 }
    finish { Rough }
}

// The axis of the pipes is x; the joint is at x = 0.
#declare Pipe = 0.85;
#declare Flange = 1.75;
#declare Thick = 0.38;
#declare Circle = 1.32;   // radius of the bolt circle

#declare Half = union {
    cylinder { 0.05 * x, (0.05 + Thick) * x, Flange texture { Iron } }
    cylinder { (0.05 + Thick) * x, (0.2 + Thick) * x, 1.02 texture { Iron } }
    cylinder { Thick * x, 9 * x, Pipe texture { Pipe_Paint } }
}

// A bolt along x through both flanges; its head is at the left.
#declare Flats = 0.46;
#declare Side = Flats / sqrt(3);
#declare Plate = box {
    <-0.24, -Side / 2, -Flats / 2>, <0, Side / 2, Flats / 2>
}
#declare Bolt = union {
    cylinder { -0.62 * x, 0.75 * x, 0.13 }
    union {
        object { Plate }
        object { Plate rotate 60 * x }
        object { Plate rotate 120 * x }
        rotate 17 * x
        translate -(0.05 + Thick) * x
    }
    texture { Bolt_Zinc }
    translate Circle * y
}
#declare Three_Bolts = union {
    object { Bolt }
    object { Bolt rotate 120 * x }
    object { Bolt rotate 240 * x }
}

// The face of the gauge points along negative z; its stem is on the pipe.
#declare Gauge = union {
    cylinder { -0.2 * y, 0.75 * y, 0.13 texture { Bolt_Zinc } }
    union {
        cylinder { -0.2 * z, 0.2 * z, 0.62 texture { Iron } }
        cylinder { -0.205 * z, 0, 0.53 pigment { White } finish { Rough } }
        box {
            <-0.025, -0.1, -0.22>, <0.025, 0.42, 0>
            pigment { color Scarlet }
            finish { Rough }
            rotate -50 * z
        }
        sphere {
            0, 0.08
            scale <1, 1, 0.5>
            translate -0.21 * z
            texture { Iron }
        }
        translate 1.3 * y
    }
}

#declare Saddle = union {
    box { <-0.25, -1.95, -0.7>, <0.25, -0.6, 0.7> }
    box { <-0.55, -2.1, -1.1>, <0.55, -1.9, 1.1> }
    texture { pigment { color rgb <0.07, 0.09, 0.11> } finish { Rough } }
}

union {
    object { Half }
    object { Half rotate 180 * y }
    cylinder { -0.05 * x, 0.05 * x, 1.6 texture { Rubber } }
    object { Three_Bolts }
    object { Three_Bolts rotate 60 * x }
    object { Gauge rotate 30 * y translate <2.2, Pipe, 0> }
    object { Saddle translate 2.2 * x }
    object { Saddle translate -2.4 * x }
}

plane {
    y, -2.1
    pigment {
        checker color rgb <0.3, 0.3, 0.28>, color rgb <0.23, 0.23, 0.21>
        scale 2
    }
    finish { Rough }
}
