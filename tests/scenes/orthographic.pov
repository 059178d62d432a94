// An oblique orthographic camera: parallel rays with different origins, their first
// hits, reflections and refractions, and the sky.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 }
camera { orthographic location <-3, 4, -6> look_at <0, .2, 0> angle 48 }
light_source { <-6, 9, -8>, rgb .9 }
sky_sphere { pigment { gradient y color_map { [0 rgb <.8, .7, .6>] [1 rgb <.2, .3, .6>] } } }
#default { finish { ambient .15 diffuse .7 } }
sphere { <-1.6, .7, .4>, .7 pigment { rgb <.8, .3, .2> } finish { phong .6 } }
sphere { <.2, .8, -.8>, .8 pigment { rgbf <.9, 1, .95, .85> } interior { ior 1.4 } finish { specular .5 } }
box { <1, 0, .4>, <2.2, 1.6, 1.2> pigment { rgb <.3, .4, .7> } finish { reflection .4 } }
difference { cylinder { 0, 1.2*y, .6 } cylinder { -.1*y, 1.3*y, .4 }
    pigment { rgb <.5, .7, .3> } translate <-.4, 0, 1.6> }
torus { .5, .15 rotate 20*x translate <1.9, .3, -1.2> pigment { rgb <.8, .7, .2> } }
#declare N = 0;
#while (N < 12)
    sphere { <-2.2 + .35*N, .15, -2>, .15 pigment { rgb <1, N/12, .2> } }
    #declare N = N + 1;
#end
disc { 0, y, 3.6 pigment { checker rgb .7, rgb .4 } }
