// Prisms: a star with a hole, an open comb, one of glass, one in a shadow.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 8 }
camera { location <1, 5, -9> look_at <0, .3, 0> angle 42 }
light_source { <6, 12, -9>, rgb .9 }
background { color rgb <.15, .2, .3> }

plane { y, -1 pigment { checker color rgb .85 color rgb .4 scale .7 } }

#declare Star = prism { linear_sweep linear_spline -.5, .5, 16,
    #for (I, 0, 9)
        #if (mod(I, 2)) #declare R = .75; #else #declare R = 1.6; #end
        <R*cos(radians(36*I)), R*sin(radians(36*I))>,
    #end
    <1.6, 0>, // the loop ends at its first point; the next loop is a hole
    <.3, -.3>, <.3, .3>, <-.3, .3>, <-.3, -.3>, <.3, -.3> }

object { Star pigment { color rgb <.9, .6, .2> } finish { phong .6 }
    rotate <-70, 20, 0> translate <-2.3, .8, .5> }

// Not closed: POV-Ray closes it.
prism { .8, -.6, 14, <-1, -.5>, <-1, .5>, <-.7, .5>, <-.7, -.2>, <-.4, -.2>,
    <-.4, .5>, <-.1, .5>, <-.1, -.2>, <.2, -.2>, <.2, .5>, <.5, .5>, <.5, -.2>,
    <.8, -.2>, <.8, -.5> open
    pigment { color rgb <.3, .7, .5> } finish { specular .4 roughness .02 }
    rotate 25*y scale <1.4, 1, 1.2> translate <2.1, 0, .8> }

prism { 0, 1.4, 4, <0, .9>, <-.8, -.5>, <.8, -.5>, <0, .9>
    pigment { color rgbf <.9, .95, 1, .85> } interior { ior 1.4 }
    finish { phong .8 reflection .1 ambient 0 diffuse .2 }
    rotate <0, 35, 12> translate <.2, -.7, -2> }
