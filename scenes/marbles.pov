// Marbles on a board near a window: the camera's lens focuses on one row of them, and
// the area light has the size of the window.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 }
background { rgb <.35, .38, .42> }
camera {
    location <-1.4, 2.6, -7.5>
    right 4/3*x
    angle 40
    look_at <.2, .55, 0>
    aperture .7
    focal_point <0, .5, -.6>
    #ifdef (elliptical_torus) blur_samples 16 #else blur_samples 100 #end
}
light_source { <-7, 8, -3>, rgb <1, .97, .9> area_light 4*z, 3*y, 3, 3 }
light_source { <6, 5, -9>, rgb .2 shadowless }
#default { finish { ambient .2 diffuse .6 } }

plane { y, 0 pigment { rgb <.55, .5, .45> } }
// A board with hollows for the marbles.
difference {
    box { <-3, 0, -3>, <3, .3, 3> }
    #for (I, -2, 2)
        #for (K, -2, 2)
            sphere { <1.1*I, .62, 1.1*K>, .45 }
        #end
    #end
    pigment { gradient x color_map { [0 rgb <.5, .3, .15>] [.5 rgb <.62, .4, .2>] [1 rgb <.5, .3, .15>] }
              scale .35 rotate 3*y }
    rotate 20*y
}
// Marbles in most of the hollows.
#declare Stream = seed(7);
#for (I, -2, 2)
    #for (K, -2, 2)
        #declare Look = rand(Stream);
        #if (Look < .8)
            sphere { 0, .45
                #if (Look < .25)
                    pigment { rgbf <.6 + .4*rand(Stream), .9, .7 + .3*rand(Stream), .8> }
                    interior { ior 1.4 }
                    finish { ambient 0 diffuse .1 specular .7 roughness .01 reflection .08 }
                #else
                    pigment { rgb <.2 + .8*rand(Stream), .2 + .6*rand(Stream), .2 + .6*rand(Stream)> }
                    finish { specular .6 roughness .01 reflection .06 }
                #end
                translate <1.1*I, .62, 1.1*K>
                rotate 20*y
            }
        #end
    #end
#end
