// Characters with straight edges only, because this renderer divides curves into edges.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -9> look_at <0, 0, 0> angle 50 }
light_source { <-4, 5, -6>, 1 }
plane { y, -2 pigment { checker rgb 1 rgb .5 } }
text {
    ttf "cyrvetic.ttf" "AVLTZ MW" .4, 0
    pigment { rgb <.2, .6, .9> } rotate 10*y translate <-3, .5, 0>
}
text {
    ttf "cyrvetic.ttf", " HKX\u0041il", 1, <.1, .05, .2>
    pigment { rgb <.9, .6, .2> } finish { reflection .2 } translate <-3, -1, 0>
}
difference {
    box { <0, -1, 0>, <3.5, 1.5, .5> }
    text { ttf "timrom.ttf" "-l-" 1 0 scale 1.5 translate <.3, .3, -.3> }
    text { ttf "cyrvetic.ttf" "N" 1 0 translate <2.3, -.6, -.3> }
    pigment { rgb <.3, .8, .4> } rotate 20*y translate <.2, .1, 1>
}
