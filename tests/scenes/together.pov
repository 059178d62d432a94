// Almost everything that is assembled only for scenes that need it: shapes, normals,
// images, patterns, area lights, spotlights, fog, glass, Fresnel reflection, objects
// that are invisible to some rays.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 }
background { rgb <.3, .4, .5> }
fog { distance 60 color rgb <.5, .6, .7> }
camera { location <.4, 4.2, -9> right x*image_width/image_height angle 46 look_at <0, .5, 0> }
light_source { <6, 9, -6>, .7 area_light x, z, 2, 2 }
light_source { <-5, 7, -7>, .5 spotlight point_at 0 radius 18 falloff 24 }
#default { finish { ambient .15 diffuse .6 phong .5 phong_size 30 } }

plane { y, -.53 pigment { image_map { ppm "images.ppm" interpolate 2 } rotate 90*x scale 3 } }
lathe { linear_spline 5, <0, -.5>, <.7, -.45>, <.15, .3>, <.5, .9>, <0, .8>
        pigment { rgb <.7, .5, .3> } normal { gradient y, .4 scale .2 } translate <-2.6, 0, -.6> }
difference {
    prism { quadratic_spline -.5, .4, 6, <0, .4>, <-1, -1>, <1, -1>, <1, 1>, <.1, .2>, <-1, -1> }
    sphere { <.7, .4, -.4>, .45 }
    pigment { rgb <.3, .6, .4> } finish { specular .6 } translate <2.5, 0, .4>
}
blob { threshold .4 sphere { <-.5, 0, 0>, .8, 1 } cylinder { <.3, -.3, 0>, <.4, .7, 0>, .6, 1 } sphere { <0, .4, -.3>, .6, -.5 }
       pigment { rgb <.7, .3, .3> } finish { specular .5 reflection { .05, .4 fresnel } } interior { ior 1.5 }
       translate <-.2, .2, -1.4> }
intersection {
    mesh { triangle { <-.8, -.5, -.7>, <.9, -.5, -.6>, <0, -.5, .8> } triangle { <-.8, -.5, -.7>, <.9, -.5, -.6>, <.1, 1, 0> }
           triangle { <.9, -.5, -.6>, <0, -.5, .8>, <.1, 1, 0> } triangle { <0, -.5, .8>, <-.8, -.5, -.7>, <.1, 1, 0> }
           inside_vector y }
    sphere { 0, .8 }
    pigment { rgbt <.8, .9, 1, .7> } interior { ior 1.3 } hollow translate <.6, .02, 1.6>
}
sphere { 0, .5 pigment { leopard color_map { [0 rgb <.9, .8, .2>] [.5 rgb <.2, .2, .6>] } scale .1 }
         normal { onion .3 scale .2 } finish { reflection .2 } translate <1.2, 0, -2.6> no_reflection }
sphere { <-1.5, .1, -2.9>, .4 pigment { rgb <.8, .6, .9> } no_image }
text { ttf "timrom.ttf" "C" .3, 0 pigment { rgb .8 } scale 1.4 translate <-1.6, -.5, 1.9> }
