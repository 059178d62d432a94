// A red peg leaves a green box at x = 1. Its sheath ends in the face x = -1 of the
// box, which the peg does not reach: nothing is red there.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <.3, .4, .6> }
camera { location <-6, 2, -7> look_at 0 angle 30 }
light_source { <-9, 9, -9>, 1 }
merge {
    box { -1, 1 rotate 90*x rotate 90*y pigment { rgb <.2, .8, .2> } }
    intersection {
        cylinder { 0, 1.5*x, .5 }
        cylinder { -x, 2*x, .8 }
        pigment { rgb <1, 0, 0> }
    }
}
