// Rays that are reflected many times inside one body: without normalisation, the
// error of their directions would grow about 60 times with each reflection.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 30 adc_bailout .005 }
background { rgb <.2, .3, .5> }
camera { location <0, .5, -6> right 4/3*x angle 46 look_at 0 }
light_source { <1, 8, -10>, rgb 1 }
light_source { <-4, -.4, -9>, rgb <.3, .2, .2> }
#default { finish { ambient .1 diffuse .4 phong .45 phong_size 30 } }

plane { y, -1.5 pigment { rgb <.8, .6, .4> } }
// A transparent ball with reflection.
sphere {
    <-1.3, 0, 0>, 1
    pigment { rgbt <1, 1, 1, .9> }
    finish { reflection { .1, .75 } }
}
// Balls of glass with a flat side: rays continue along the wall by total reflection.
#declare cut = difference { sphere { 0, 1 } plane { z, -.15 } };
object {
    cut
    pigment { rgbt <.9, .95, 1, .96> }
    interior { ior 1.6 }
    rotate <10, -15, 0>
    translate <1.2, .3, .4>
}
