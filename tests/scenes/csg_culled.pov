// A box that is cut to a small ball is half inside another box and coplanar with two of
// its faces. It is seen in places where no ray comes near the ball, and where some do.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <.3, .4, .6> }
camera { location <3.05434, 1.67098, -9> look_at <.013, .0171, 0> angle 45 }
light_source { <7.3, 11.1, -9.7>, rgb .8 }
light_source { <-9.1, 5.3, -4.9>, rgb .4 }
merge {
    intersection {
        sphere { .5*y, .5 }
        box { <-1, -.5, -.5>, <1, .5, 1> }
    }
    box { <0, -.5, -1>, <1, .5, 1> }
}
