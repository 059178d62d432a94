// A tumbler of water with ice and a straw: glass in water in glass. The water extends
// into the glass, so that no two faces coincide.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 10 adc_bailout 1/200 }
background { rgb <.75, .8, .85> }
camera { location <0, 3.1, -8.2> right 4/3*x angle 38 look_at <.013, 1.117, 0> }
light_source { <-6, 9, -6>, rgb .75 }
light_source { <7, 5, -5>, rgb .3 shadowless }
#default { finish { ambient .12 diffuse .65 } }

plane { y, 0 pigment { checker rgb <.85, .8, .7> rgb <.55, .6, .55> scale .8 } }
box { <-6, -.1, 4>, <6, 4.6, 4.3>
      pigment { gradient x color_map { [0 rgb <.9, .6, .4>] [.5 rgb <.95, .85, .7>] [1 rgb <.9, .6, .4>] }
                scale 1.5 translate -6*x } }

#declare glass = finish { ambient 0 diffuse 0 phong .5 phong_size 90 reflection { .02, .6 fresnel } }
difference {
    cone { .02*y, .95, 2.6*y, 1.25 }
    cone { .25*y, .8, 2.7*y, 1.13 }
    pigment { rgbt <.97, 1, .98, .96> }
    finish { glass }
    interior { ior 1.5 }
}
// Water.
cone {
    .24*y, .82, 2.01*y, 1.06
    pigment { rgbt <.93, .97, 1, .95> }
    finish { ambient 0 diffuse 0 phong .3 phong_size 120 reflection { 0, .5 fresnel } }
    interior { ior 1.33 }
    no_shadow
}
// Ice, with air inside.
#declare ice = box {
    -.32, .32
    pigment { rgbt <.95, .97, 1, .93> }
    finish { ambient 0 diffuse .05 }
    interior { ior 1.31 }
    no_shadow
}
object { ice rotate <12, 28, 9> translate <-.3, 1.78, -.25> }
object { ice rotate <-17, 61, 14> translate <.38, 1.72, .2> }
sphere {
    <-.31, 1.76, -.24>, .12
    pigment { rgbt 1 }
    finish { ambient 0 diffuse 0 }
    interior { ior 1 }
    no_shadow
}
// A straw.
difference {
    cylinder { <-.5, .3, .25>, <.95, 3.9, .1>, .1 }
    cylinder { <-.52, .25, .25>, <.97, 3.95, .1>, .08 }
    pigment { gradient y color_map { [.5 rgb <.8, .1, .1>] [.5 rgb .95] } scale .5 rotate 20*z translate -4*y }
}
// A lemon next to the tumbler.
sphere {
    0, .6
    scale <1.3, 1, 1>
    pigment { rgb <.95, .8, .15> }
    finish { specular .3 roughness .05 }
    rotate <0, 35, 8>
    translate <2.15, .6, .4>
}
