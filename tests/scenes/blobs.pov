// Blobs: balls and cylinders that join, that subtract, that are transformed; one of
// glass, one in several pieces, one seen from inside.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 8 }
camera { location <.5, 4, -9> look_at <0, .3, 0> angle 46 }
light_source { <6, 12, -9>, rgb .9 }
background { color rgb <.15, .2, .3> }

plane { y, -1 pigment { checker color rgb .85 color rgb .4 scale .7 } }

// Three balls, the last one in the syntax of older files.
blob { threshold .6
    sphere { <-.75, 0, 0>, 1, 1 }
    sphere { <.75, 0, 0>, 1, strength 1 }
    component 1, 1, <0, 1.2, 0>
    pigment { color rgb <.9, .5, .3> } finish { phong .6 }
    rotate <20, 30, 0> translate <-3, .3, 1> }

// Limbs: cylinders, one of them parallel to an axis, with joints; a bite and a dent.
blob { threshold .5
    cylinder { <-1, -.6, 0>, <-.2, .5, 0>, .5, 1 }
    cylinder { <-.2, .5, 0>, <.9, .6, -.3>, .45, .9 }
    cylinder { <.9, .6, -.3>, <.9, 1.5, -.3>, .4, 1.1 }
    sphere { <-.2, .7, -.3>, .6, -1.2 }
    sphere { <.3, .4, -.4>, .4, strength -.6 }
    sphere { <.9, 1.6, -.3>, .6, 1 }
    pigment { color rgb <.3, .7, .5> } finish { specular .4 roughness .02 }
    sturm scale <1.2, 1, .8> translate <2.5, 0, .5> }

// Components with separate transforms; a mirror.
blob { threshold .4
    sphere { 0, 1, 1 scale <1.6, .5, .7> rotate 25*z }
    cylinder { -.6*y, .6*y, .5, 1 scale <1, 1.3, .5> rotate <30, 0, -40>
        translate <.4, .3, 0> }
    sphere { 0, .6, .8 matrix <1, .4, 0, 0, .8, .3, .2, 0, 1, -.9, .5, -.2> }
    pigment { color rgb <.2, .2, .35> } finish { reflection .4 phong .8 }
    hierarchy translate <.2, 1.7, 2> }

// A blob of glass: rays start on its surface.
blob { threshold .5
    sphere { <-.5, 0, 0>, .8, 1 }
    sphere { <.5, .1, .2>, .7, 1 }
    cylinder { <-.5, .5, 0>, <.5, .7, 0>, .3, .8 }
    pigment { color rgbf <.9, .95, 1, .85> } interior { ior 1.3 }
    finish { phong .8 reflection .1 ambient 0 diffuse .2 }
    translate <.4, -.4, -2.5> }

// A blob in several pieces: drops above a ring of balls.
blob { threshold .65
    #for (I, 0, 8)
        sphere { <.8*cos(I*.7), .1*mod(I, 3), .8*sin(I*.7)>, .42, 1.1 }
        sphere { <.6*sin(I*2), 1 + .22*I, .6*cos(I*3)>, .26, 1.4 }
    #end
    pigment { color rgb <.9, .85, .3> }
    translate <-2, -.9, -1.6> }

// A blob seen from inside. It states no threshold; the default is 1.
blob { sphere { <.5, 4, -9>, 30, 1.03 } cylinder { -20*x, 20*x, 25, .9 }
    pigment { color rgb <.3, .2, .4> } translate <0, 3, 4> }
