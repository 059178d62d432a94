// A lens of an orthographic camera, with the objects of lens.pov.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <.3, .35, .4> }
camera {
    orthographic
    location <.5, 2, -7>
    right 5*x*image_width/image_height
    up 5*y
    aperture 1.2
    focal_point <0, .7, -.5>
    look_at <0, .6, 0>
    confidence .999
    variance 0
    #ifdef (elliptical_torus) blur_samples 14 #else blur_samples 300 #end
}
light_source { <5, 9, -7>, .8 }
light_source { <-9, 4, -5>, .2 shadowless }
plane { y, 0 pigment { checker rgb .6 rgb .4 scale 2 } }
sphere { <0, .7, 0>, .7 pigment { rgb <.7, .4, .3> } }
sphere { <1.6, .8, 4>, .8 pigment { rgb <.4, .6, .3> } }
sphere { <-1.2, .5, -3>, .5
    pigment { rgb <.3, .4, .6> }
    finish { reflection .3 }
}
box { <1, .1, -2.4>, <1.7, .9, -1.8>
    pigment { rgbt <.8, .9, .8, .7> }
    interior { ior 1.2 }
    rotate 10*y
}
