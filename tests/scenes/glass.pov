// Glass: with one and with many refractions, with total reflection, with a reflecting
// finish, coloured, hollow, and one that only attenuates the light.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 12 adc_bailout 1/500 }
background { rgb <.4, .5, .7> }
camera { location <0, 3, -10> right 4/3*x angle 48 look_at <0, .7, 0> }
light_source { <-5, 9, -6>, rgb .8 }
#default { finish { ambient .1 diffuse .6 } }

plane { y, -1 pigment { checker rgb <.9, .9, .8> rgb <.3, .2, .2> } }
box { <-7, -1, 5>, <7, 3, 6>
      pigment { checker rgb <.9, .6, .2> rgb <.2, .3, .6> } }

sphere {
    <-2.6, .2, 0>, 1.2
    pigment { rgbt <1, 1, 1, .9> }
    finish { reflection .15 specular .7 roughness .01 }
    interior { ior 1.5 }
}
// A prism; its slanted face reflects totally.
intersection {
    box { <-1, -1, -1>, <1, 1, 1> }
    plane { <0, 1, 1>, 0 }
    pigment { rgbf <.9, .95, 1, .95> }
    interior { ior 1.6 }
    rotate 25*y
    translate <.4, .05, -1>
}
// A thick bowl.
difference {
    sphere { 0, 1 }
    sphere { .1*y, .8 }
    plane { -y, -.4 }
    pigment { rgbf <.8, 1, .9, .9> }
    interior { ior 1.3 }
    translate <3, 0, 0>
}
// A lens, and an air bubble in a block: one solid.
intersection {
    sphere { <0, 0, -1.5>, 1.8 }
    sphere { <0, 0, 1.5>, 1.8 }
    pigment { rgbt 1 }
    interior { ior 1.5 }
    translate <.5, 1.6, -3>
}
difference {
    box { -.8, .8 }
    sphere { 0, .6 }
    pigment { rgbf <1, .8, .8, .9> }
    interior { ior 1.4 }
    rotate <0, 35, 0>
    translate <3.6, 0, -3>
}
// Without a refractive index, rays continue straight.
torus { .8, .25 pigment { rgbft <.3, .9, .4, .5, .3> }
        rotate 60*x translate <-3.6, .3, -3> }
