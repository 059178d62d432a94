// glass.pov - a burning glass, a ball, a goblet and bored blocks of glass
// in front of a mirror.
//
// The lens is the intersection of two balls; the goblet is an ellipsoid minus a
// smaller one.  Transmitted light is tinted, also in shadows.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 6 }

background { color rgb <0.16, 0.21, 0.29> }

camera {
    location <-0.4, 4.4, -9.4>
    right x * image_width / image_height
    angle 37
    look_at <0.05, 1.05, 0>
}

light_source { <-6, 11, -6>, color rgb <1, 0.97, 0.92> }
light_source { <7, 7, -4>, color rgb <0.25, 0.28, 0.34> }

#declare Polish = finish {
    ambient 0 diffuse 0.05 specular 0.8 roughness 0.005
}
#declare Gleaming = finish { Polish reflection 0.1 }
#declare Wood = texture {
    pigment { color rgb <0.2, 0.085, 0.03> }
    finish { ambient 0.12 diffuse 0.7 phong 0.4 phong_size 30 }
}
#declare Brass_Ring = texture {
    pigment { color rgb <0.6, 0.38, 0.1> }
    finish { ambient 0.1 diffuse 0.6 specular 0.8 roughness 0.02 }
}

// Two balls of radius 2.4 whose centres are 4.2 apart.
union {
    intersection {
        sphere { 2.1 * z, 2.4 }
        sphere { -2.1 * z, 2.4 }
        pigment { color rgbf <0.97, 0.98, 0.98, 0.97> }
        finish { Polish }
        interior { ior 1.5 }
    }
    torus { 1.162, 0.07 rotate 90 * x texture { Brass_Ring } }
    cylinder { -1.22 * y, -1.5 * y, 0.08 texture { Wood } }
    cone { -1.6 * y, 0.55, -1.45 * y, 0.3 texture { Wood } }
    rotate 22 * y
    translate <-1.65, 1.6, -0.5>
}

// A solid ball, which shows an inverted picture.
sphere {
    <-0.15, 0.62, -2.2>, 0.62
    pigment { color rgbf <0.97, 0.98, 0.98, 0.95> }
    finish { Gleaming }
    interior { ior 1.5 }
}

// Blocks, each with a ball of air inside.
#macro Block(Tint, Turn, Place)
    difference {
        box { <-0.55, 0, -0.55>, <0.55, 1.1, 0.55> }
        sphere { <0, 0.55, 0>, 0.4 }
        pigment { color rgb Tint filter 0.95 }
        finish { Polish }
        interior { ior 1.5 }
        rotate Turn * y
        translate Place
    }
#end
Block(<1, 0.25, 0.12>, 30, <1.95, 0, -1.2>)
Block(<0.25, 0.85, 0.4>, 8, <2, 1.105, -1.15>)

merge {
    difference {
        sphere { 0, 1 scale <0.66, 0.9, 0.66> }
        sphere { 0, 1 scale <0.61, 0.84, 0.61> }
        plane { -y, -0.35 }
        translate 1.8 * y
    }
    cylinder { 0.1 * y, 0.95 * y, 0.07 }
    cone { 0, 0.5, 0.16 * y, 0.06 }
    pigment { color rgbf <0.55, 0.72, 1, 0.95> }
    finish { Polish }
    interior { ior 1.5 }
    translate <0.5, 0, 0.2>
}

// A framed mirror leans behind the glasses.
union {
    box {
        <-2.9, 0.15, 0>, <2.9, 2.9, 0.05>
        pigment { color rgb 0.02 }
        finish { ambient 0 diffuse 0.2 reflection 0.8 }
    }
    difference {
        box { <-3.1, 0, -0.05>, <3.1, 3.1, 0.15> }
        box { <-2.85, 0.2, -1>, <2.85, 2.85, 0.02> }
        texture { Wood }
    }
    rotate <8, -9, 0>
    translate 1.9 * z
}

// slightly lower than the objects on it, so that no glass face lies in its plane
plane {
    y, -0.005
    pigment {
        checker color rgb <0.62, 0.59, 0.52>, color rgb <0.2, 0.1, 0.07>
        rotate 20 * y
    }
    finish { ambient 0.13 diffuse 0.7 }
}
