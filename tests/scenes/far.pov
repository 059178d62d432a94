// Planes that are parallel to a camera ray, except for the rounding of their rotated
// normals, intersect it at a distance of 5e15. There, rounding decides whether a part
// is in front of a light or behind it, so a bounding sphere and the part inside it
// would give different results. Hits beyond 1e12 are therefore not visible.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 }
background { rgb <.3, .4, .6> }
camera { location <0.5, 0, 0> direction 14*z right 21*x up 15*y }
light_source { <-2.629, 11.239, -8.731>, rgb .8 shadowless }
light_source { <5.566, 10.378, -4.753>, rgb .8 }
#default { pigment { rgb .8 } }
box { <0, 1, -1>, <0.5, 0, 0.5> rotate <90, 90, 270> }
union {
    cylinder { <0, 1, 0>, <0, 1, -1>, 0.5 open }
    quadric { 0, 0, <0, 0, 1>, -.5 pigment { rgb <0.05, 0.13, 0.05> } }
    rotate <270, 270, 180> translate <-0.25, -0.5, 0>
}
