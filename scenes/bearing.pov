// bearing.pov - a shaft in the ball bearing of a pillow block.
//
// The scene uses no difference: a ring is a disk with a smaller disk in front
// of it, and a hexagon is the union of three boxes.
#version 3.7;
#include "colors.inc"
global_settings { assumed_gamma 1.0 }

background { color rgb <0.03, 0.04, 0.055> }

camera {
    location <5.2, 3.4, -8.6>
    right x * image_width / image_height
    angle 40
    look_at <-0.05, -0.22, -0.5>
}

light_source { <3, 9, -9>, color rgb <1, 0.97, 0.9> }
light_source { <-8, 2, -6>, color rgb <0.22, 0.28, 0.38> shadowless }

#declare Bright = finish {
    ambient 0.1 diffuse 0.5 specular 0.9 roughness 0.01
}
#declare Satin = finish {
    ambient 0.12 diffuse 0.6 phong 0.35 phong_size 18
}
#declare Steel = texture {
    pigment { color rgb <0.42, 0.44, 0.48> }
    finish { Bright }
}
#declare DarkSteel = texture {
    pigment { color rgb <0.05, 0.055, 0.065> }
    finish { Satin }
}
#declare Brass_Cage = texture {
    pigment { color rgb <0.58, 0.33, 0.06> }
    finish { Bright }
}
#declare Paint = texture {
    pigment { color rgb <0.03, 0.16, 0.2> }
    finish { Satin }
}

// The axis is z; the camera is at negative z.
#declare Housing_Radius = 2.0;
#declare Outer_Race = 1.62;
#declare Groove = 1.36;
#declare Pitch = 1.1;
#declare Ball_Radius = 0.23;
#declare Inner_Race = 0.86;
#declare Shaft = 0.6;
#declare Face = -0.5;   // front face of the housing
#declare Base = -2.3;   // lower face of the foot

#declare Housing = union {
    cylinder { <0, 0, Face>, <0, 0, 0.5>, Housing_Radius }
    box { <-Housing_Radius, Base, Face>, <Housing_Radius, 0, 0.5> }
    box { <-3.3, Base, -0.75>, <3.3, Base + 0.5, 0.75> }
    texture { Paint }
}

// Disks, each slightly in front of the larger one.
#declare Races = union {
    cylinder { <0, 0, Face - 0.10>, <0, 0, 0>, Outer_Race texture { Steel } }
    cylinder { <0, 0, Face - 0.11>, <0, 0, 0>, Groove texture { DarkSteel } }
    cylinder { <0, 0, Face - 0.16>, <0, 0, 0>, Inner_Race texture { Steel } }
}

#declare Ball = sphere {
    <0, Pitch, Face - 0.11>, Ball_Radius
    texture { Steel }
}
#declare Three_Balls = union {
    object { Ball }
    object { Ball rotate 120 * z }
    object { Ball rotate 240 * z }
}
#declare Bar = box {
    <-0.05, Pitch - 0.14, Face - 0.17>, <0.05, Pitch + 0.14, Face>
    texture { Brass_Cage }
}
#declare Three_Bars = union {
    object { Bar }
    object { Bar rotate 120 * z }
    object { Bar rotate 240 * z }
    rotate 20 * z
}

// Shaft with a key and a rounded end.
#declare Journal = union {
    cylinder { <0, 0, -2.2>, <0, 0, 3>, Shaft }
    cylinder { <0, 0, -0.95>, <0, 0, Face>, 0.74 }
    sphere { 0, Shaft scale <1, 1, 0.4> translate -2.2 * z }
    texture { Steel }
}
#declare Key = box {
    <-0.13, Shaft - 0.1, -2.1>, <0.13, Shaft + 0.12, -1.2>
    texture { Brass_Cage }
    rotate -35 * z
}

// A hexagon with the distance s across flats has sides s / sqrt(3): three boxes.
#declare Flats = 0.62;
#declare Side = Flats / sqrt(3);
#declare Plate = box { <-Side, 0, -Flats> / 2, <Side / 2, 0.26, Flats / 2> }
#declare Bolt = union {
    cylinder { 0, 0.06 * y, 0.45 }
    object { Plate translate 0.06 * y }
    object { Plate translate 0.06 * y rotate 60 * y }
    object { Plate translate 0.06 * y rotate 120 * y }
    cylinder { 0, 0.45 * y, 0.17 }
    texture { Steel }
}

union {
    object { Housing }
    object { Races }
    object { Three_Balls }
    object { Three_Balls rotate 40 * z }
    object { Three_Balls rotate 80 * z }
    object { Three_Bars }
    object { Three_Bars rotate 40 * z }
    object { Three_Bars rotate 80 * z }
    object { Journal }
    object { Key }
    object { Bolt rotate 12 * y translate <-2.65, Base + 0.5, 0> }
    object { Bolt rotate 41 * y translate <2.65, Base + 0.5, 0> }
    // a grease nipple on top
    union {
        cylinder { 0, 0.22 * y, 0.16 }
        sphere { 0, 0.13 scale <1, 1.3, 1> translate 0.3 * y }
        texture { Brass_Cage }
        translate (Housing_Radius - 0.02) * y
    }
}

plane {
    y, Base
    pigment {
        checker color rgb 0.2, color rgb 0.15
        scale 1.5
        rotate 30 * y
    }
    finish { ambient 0.15 diffuse 0.6 }
}
