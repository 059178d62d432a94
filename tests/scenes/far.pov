// Planes that are parallel to a view ray but for the rounding of their normals'
// turns meet it 5e15 away.  From there whether a part lies before a light or
// behind it is left to rounding, so that a bounding sphere and the part within
// it would decide differently.  What is farther than 1e12 is not seen.
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
