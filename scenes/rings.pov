// rings.pov - a toy of rings on a peg, a chain, a band and an apple: tori.
#version 3.7;
#include "colors.inc"
global_settings { assumed_gamma 1.0 }

background { color rgb <0.35, 0.42, 0.5> }

camera {
    location <0.6, 4.4, -8.2>
    right x * image_width / image_height
    angle 41
    look_at <0.2, 0.98, 0>
}

light_source { <-6, 10, -7>, color rgb <1, 0.97, 0.92> }
light_source { <8, 4, -5>, color rgb <0.25, 0.27, 0.32> shadowless }

#declare Lacquer = finish {
    ambient 0.13 diffuse 0.65 specular 0.6 roughness 0.02
}
#declare Metal = finish {
    ambient 0.12 diffuse 0.5 specular 0.9 roughness 0.012
}

plane {
    y, 0
    pigment {
        checker color rgb <0.5, 0.4, 0.28>, color rgb <0.42, 0.32, 0.21>
        scale 1.5
    }
    finish { ambient 0.15 diffuse 0.7 }
}

// The toy: the rings are stacked on a conical peg.
union {
    cylinder { 0, 0.16 * y, 1.35 pigment { color rgb <0.55, 0.36, 0.16> } }
    torus { 1.35, 0.08 translate 0.08 * y
            pigment { color rgb <0.55, 0.36, 0.16> } }
    cone { 0.16 * y, 0.5, 2.75 * y, 0.16
           pigment { color rgb <0.75, 0.6, 0.4> } }
    sphere { 2.75 * y, 0.2 pigment { color rgb <0.8, 0.1, 0.06> } }
    torus { 0.92, 0.34 translate 0.5 * y
            pigment { color rgb <0.07, 0.2, 0.55> } }
    torus { 0.8, 0.31 translate 1.12 * y
            pigment { color rgb <0.04, 0.42, 0.36> } }
    torus { 0.69, 0.27 translate 1.67 * y
            pigment { color rgb <0.9, 0.62, 0.05> } }
    torus { 0.58, 0.23 rotate <0, 0, -4> translate <0.03, 2.14, 0>
            pigment { color rgb <0.85, 0.25, 0.03> } }
    finish { Lacquer }
    translate <-0.9, 0, 0.9>
}

// Three links of a chain; the middle one is upright.
#declare Link = torus { 0.42, 0.1 scale <1.3, 1, 1> }
union {
    object { Link translate <-0.8, 0.1, 0> }
    object { Link rotate <80, 0, 14> translate <0.08, 0.42, 0> }
    object { Link rotate <0, -16, 0> translate <0.95, 0.1, -0.1> }
    pigment { color rgb <0.5, 0.51, 0.55> }
    finish { Metal }
    rotate 12 * y
    translate <-0.5, 0, -1.9>
}

// A band with an elliptical section that is higher than it is thick.  In readers
// without an elliptical torus it is a quartic:
//     (x^2 + z^2 + K y^2 + B)^2 = 4 R^2 (x^2 + z^2).
#declare R = 0.6;     // from the axis to the centre of the section
#declare Thick = 0.07;
#declare High = 0.24;
#ifdef (elliptical_torus)
#declare Band = elliptical_torus { R, Thick, High }
#else
#declare K = Thick * Thick / High / High;
#declare B = R * R - Thick * Thick;
#declare A = 2 * B - 4 * R * R;
#declare Band = quartic {
    <1, 0, 0, 0, 2 * K, 0, 0, 2, 0, A,
     0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
     K * K, 0, 0, 2 * K, 0, 2 * K * B, 0, 0, 0, 0,
     1, 0, A, 0, B * B>
    sturm
}
#end
union {
    object { Band translate 0.24 * y }
    object { Band rotate 78 * z translate <0.85, 0.66, 0.15> }
    pigment { color Gold * 0.9 }
    finish { Metal }
    rotate -25 * y
    translate <1.55, 0, -0.95>
}

// A torus whose minor radius is larger than its major radius: it has a dimple.
union {
    torus { 0.24, 0.46 scale <1, 0.95, 1>
            pigment { color rgb <0.6, 0.03, 0.04> } }
    cone { 0.3 * y, 0.025, <0.12, 0.72, 0.04>, 0.045
           pigment { color rgb <0.18, 0.1, 0.04> } }
    finish { Lacquer }
    rotate <-10, 0, -12>
    translate <2.15, 0.43, 1>
}
