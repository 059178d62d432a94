// Coincident faces of a cylinder and of two boxes; some of them belong to the part of
// a box that the other box cuts away.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <.3, .4, .6> }
camera { location <1.9962, 2.35224, -9> look_at <.013, .0171, 0> angle 45 }
light_source { <7.3, 11.1, -9.7>, rgb .8 }
light_source { <-9.1, 5.3, -4.9>, rgb .4 }
merge {
    cylinder { -.5*z, .5*z, 1 scale 2 }
    intersection {
        box { <-1, -.5, -.5>, <1, 1, .5> rotate <90, 90, 0> }
        box { 0, <1, .5, .5> }
    }
}
