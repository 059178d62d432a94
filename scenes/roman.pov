// roman.pov - Steiner's Roman surface and the cross-cap, as quartics.
//
// Both are images of the projective plane, which is a sphere with opposite
// points identified.  The Roman surface intersects itself along three lines
// that meet in its centre; the cross-cap intersects itself along one line.
#version 3.7;
global_settings { assumed_gamma 1.0 }

background { color rgb <0.07, 0.08, 0.11> }

camera {
    location <0, 3.4, -8>
    right x * image_width / image_height
    angle 39
    look_at <0, 1.25, 0>
}

light_source { <-5, 9, -8>, color rgb <1, 0.96, 0.9> }
light_source { <7, 3, -4>, color rgb <0.2, 0.24, 0.34> shadowless }

#declare Glaze = finish {
    ambient 0.14 diffuse 0.62 specular 0.7 roughness 0.02
}
#declare Stone = finish { ambient 0.15 diffuse 0.7 }

// x^2 y^2 + y^2 z^2 + z^2 x^2 = x y z, within 1/sqrt(3) of the origin.
// The order of the coefficients is x^4, x^3 y, x^3 z, x^3, x^2 y^2 ..
quartic {
    <0, 0, 0, 0, 1, 0, 0, 1, 0, 0,
     0, 0, 0, 0, -1, 0, 0, 0, 0, 0,
     0, 0, 0, 1, 0, 0, 0, 0, 0, 0,
     0, 0, 0, 0, 0>
    sturm
    scale 2.1
    rotate <-36, 28, 20>
    translate <-1.45, 1.4, 0>
    pigment { color rgb <0.72, 0.24, 0.06> }
    finish { Glaze }
}

// 4 x^2 (x^2 + y^2 + z^2 + z) + y^2 (y^2 + z^2 - 1) = 0, rotated so that the
// line of self-intersection is vertical.
quartic {
    <4, 0, 0, 0, 4, 0, 0, 4, 4, 0,
     0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
     1, 0, 0, 1, 0, -1, 0, 0, 0, 0,
     0, 0, 0, 0, 0>
    sturm
    rotate 90 * x
    rotate <0, 40, 0>
    scale 1.05
    translate <1.5, 1.42, 0>
    pigment { color rgb <0.05, 0.34, 0.45> }
    finish { Glaze }
}

#declare Plinth = union {
    cylinder { 0, 0.22 * y, 1.15 }
    torus { 1.15, 0.11 translate 0.11 * y }
    pigment { color rgb <0.5, 0.48, 0.44> }
    finish { Stone }
}
object { Plinth translate <-1.45, 0, 0> }
object { Plinth translate <1.5, 0, 0> }

plane {
    y, 0
    pigment {
        checker color rgb <0.2, 0.2, 0.22>, color rgb <0.13, 0.13, 0.16>
    }
    finish { Stone }
}
