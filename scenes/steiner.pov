// steiner.pov - the Roman surface and the cross-cap in separated pieces.
//
// Both consist of rational patches.  The point with the parameters s, t, u is
//     Roman surface   (tu, su, st) / (s^2 + t^2 + u^2)
//     cross-cap       (tu, 2 st, s^2 - t^2) / (s^2 + t^2 + u^2)
// The patches are the images of the triangles of an octahedron, each face cut in
// four so that all weights are positive.  One face is the image of one lobe
// here; three copies, rotated or mirrored, are the other lobes.
#version 3.7;
global_settings { assumed_gamma 1.0 }
#ifndef (steiner_patch)
#include "steiner.inc"
#end

background { color rgb <0.4, 0.42, 0.46> }

camera {
    location <0, 3, -8>
    right x * image_width / image_height
    angle 38
    look_at <0, 1.2, 0>
}

light_source { <-5, 9, -8>, color rgb <1, 0.97, 0.92> }
light_source { <7, 4, -5>, color rgb <0.25, 0.28, 0.36> shadowless }

#declare Glaze = finish {
    ambient 0.15 diffuse 0.62 specular 0.6 roughness 0.02
}

#declare H = <0.5, 0.5, 0.5>;
#ifdef (steiner_patch)
#declare Roman_Lobe = union {
    steiner_patch { 0, z/2, y/2, z/2, H, y/2 weights 4, 2, 2, 2, 1, 2 }
    steiner_patch { 0, x/2, z/2, x/2, H, z/2 weights 4, 2, 2, 2, 1, 2 }
    steiner_patch { 0, y/2, x/2, y/2, H, x/2 weights 4, 2, 2, 2, 1, 2 }
    steiner_patch { z/2, x/2, y/2, H, H, H weights 2, 2, 2, 1, 1, 1 }
}
#declare Cap_Quarter = union {
    steiner_patch { z, y, z/2, y + z, <0.5, 1, 1>, z
                    weights 4, 2, 2, 2, 1, 2 }
    steiner_patch { -z, <0.5, 0, -0.5>, y, <0.5, 0, -1>, <0.5, 1, -1>, y - z
                    weights 4, 2, 2, 2, 1, 2 }
    steiner_patch { 0, z/2, <0.5, 0, -0.5>, 0, <0.5, 1, 0>, x/2
                    weights 4, 2, 2, 2, 1, 2 }
    steiner_patch { y, <0.5, 0, -0.5>, z/2,
                    <0.5, 1, -1>, <0.5, 1, 0>, <0.5, 1, 1>
                    weights 2, 2, 2, 1, 1, 1 }
}
#else
#declare Of_Corner = array[6] { 4, 2, 2, 2, 1, 2 }
#declare Of_Middle = array[6] { 2, 2, 2, 1, 1, 1 }
#declare Roman_Lobe = union {
    Steiner_Weighted(array[6] { 0*x, z/2, y/2, z/2, H, y/2 }, Of_Corner)
    Steiner_Weighted(array[6] { 0*x, x/2, z/2, x/2, H, z/2 }, Of_Corner)
    Steiner_Weighted(array[6] { 0*x, y/2, x/2, y/2, H, x/2 }, Of_Corner)
    Steiner_Weighted(array[6] { z/2, x/2, y/2, H, H, H }, Of_Middle)
}
#declare Cap_Quarter = union {
    Steiner_Weighted(array[6] { z, y, z/2, y + z, <0.5, 1, 1>, z },
                     Of_Corner)
    Steiner_Weighted(array[6] { -z, <0.5, 0, -0.5>, y, <0.5, 0, -1>,
                                <0.5, 1, -1>, y - z }, Of_Corner)
    Steiner_Weighted(array[6] { 0*x, z/2, <0.5, 0, -0.5>, 0*x, <0.5, 1, 0>,
                                x/2 }, Of_Corner)
    Steiner_Weighted(array[6] { y, <0.5, 0, -0.5>, z/2, <0.5, 1, -1>,
                                <0.5, 1, 0>, <0.5, 1, 1> }, Of_Middle)
}
#end

union {
    object { Roman_Lobe pigment { color rgb <0.75, 0.12, 0.08> } }
    object { Roman_Lobe rotate 180 * x
             pigment { color rgb <0.85, 0.55, 0.06> } }
    object { Roman_Lobe rotate 180 * y pigment { color rgb <0.06, 0.4, 0.2> } }
    object { Roman_Lobe rotate 180 * z pigment { color rgb <0.07, 0.2, 0.6> } }
    finish { Glaze }
    scale 2.1
    rotate <-36, 28, 20>
    translate <-1.3, 1.3, 0>
}

// One quarter is omitted near the camera: the inside has two sheets that
// intersect in a line.
union {
    object { Cap_Quarter pigment { color rgb <0.75, 0.12, 0.08> } }
    object { Cap_Quarter scale <-1, 1, 1>
             pigment { color rgb <0.85, 0.55, 0.06> } }
    object { Cap_Quarter scale <1, -1, 1>
             pigment { color rgb <0.06, 0.4, 0.2> } }
    finish { Glaze }
    rotate 90 * x
    rotate -60 * y
    scale 1.1
    translate <1.45, 1.3, 0>
}

plane {
    y, 0
    pigment {
        checker color rgb <0.45, 0.44, 0.42>, color rgb <0.38, 0.37, 0.36>
    }
    finish { ambient 0.15 diffuse 0.7 }
}
