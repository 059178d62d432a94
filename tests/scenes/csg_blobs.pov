// Blobs in solids: cut, cutting, joined, clipped, inverted, of glass.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 6 }
camera { location <0, 5, -9> look_at <0, 0, 0> angle 45 }
light_source { <-5, 9, -9>, rgb 1 }
background { color rgb <.2, .2, .25> }
plane { y, -1.3 pigment { color rgb <.7, .7, .65> } }

#declare Bone = blob { threshold .5
    cylinder { -x, x, .5, 1 }
    sphere { <-1, .3, 0>, .6, 1 } sphere { <-1, -.3, 0>, .6, 1 }
    sphere { <1, .3, 0>, .6, 1 } sphere { <1, -.3, 0>, .6, 1 }
    sphere { <0, .4, 0>, .4, -.8 } }

// Cut by a plane, which shows the inside, and by a ball.
difference { object { Bone pigment { color rgb <.9, .4, .3> } }
    plane { -z, 0 rotate 10*x pigment { color rgb <.9, .8, .6> } }
    sphere { <.3, -.1, 0>, .3 pigment { color rgb <.3, .5, .9> } }
    rotate <-30, 30, 5> translate <-2.2, 0, 0> }

// Subtracted from a box.
difference { box { -1, 1 pigment { color rgb <.3, .7, .4> } }
    object { Bone scale <1, 1, 1.5> rotate 90*y translate <0, .4, -.2>
        pigment { color rgb <.9, .8, .3> } }
    object { Bone rotate <90, 0, 90> pigment { color rgb <.8, .3, .8> } }
    rotate <-15, 40, 0> translate <2.1, 0, .3> }

// The intersection of two blobs; a merge of two that cross each other, of glass.
intersection { object { Bone } object { Bone rotate 90*z scale 1.1 }
    pigment { color rgb <.2, .6, .9> }
    scale 1.6 rotate <-25, 20, 10> translate <.1, -.2, -2.4> }
merge { object { Bone } object { Bone rotate 90*y }
    pigment { color rgbf <1, .8, .8, .8> } interior { ior 1.2 }
    scale .7 translate <-.2, -.4, 2.2> }

// A clipped shell; a slab with a hole of the shape of the blob.
object { Bone clipped_by { plane { <1, 1, -1>, .1 } }
    pigment { color rgb <.9, .9, .4> } scale .8 translate <-2.6, -.5, -2.3> }
intersection { object { Bone inverse } box { <-1.5, -1, -.1>, <1.5, 1, .1> }
    pigment { color rgb <.5, .4, .8> } scale .7 rotate <40, -20, 0>
    translate <2.2, -.4, -2.4> }
