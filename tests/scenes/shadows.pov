// Shadows of three lights: full ones, and coloured ones through transparent objects;
// no shadow of objects with no_shadow, and none of a shadowless light.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb .1 }
camera { location <0, 8, -11> right 4/3*x angle 50 look_at <0, .5, 0> }
light_source { <-6, 9, -5>, rgb .5 }
light_source { <7, 6, 2>, rgb <.5, .4, .3> }
light_source { <0, 20, 0>, rgb .1 shadowless }
#default { finish { ambient .05 diffuse .8 } }

plane { y, 0 pigment { checker rgb 1 rgb .8 } }

// Solid and hollow glass: two surfaces, and four.
sphere { <-3, 1.2, 0>, 1 pigment { rgbf <1, .6, .5, .9> } }
difference {
    sphere { 0, 1 }
    sphere { 0, .8 }
    pigment { rgbft <.5, .9, .6, .6, .3> }
    translate <0, 1.2, 1>
}
// Coloured panes, one with a checker of transparent and opaque squares.
box { <-1, 0, -.05>, <1, 2, 0> pigment { rgbt <.2, .2, 1, .5> }
      rotate 30*y translate <3, 0, -1> }
box { <-1, .3, -.02>, <1, 2, 0>
      pigment { checker rgbt <1, 0, 0, .7> rgb <.1, .1, .4> scale .4 }
      rotate -40*y translate <.5, 0, -2.5> }
// Opaque objects.
difference {
    cylinder { 0, 1.4*y, .8 }
    cylinder { .2*y, 2*y, .6 }
    pigment { rgb <.9, .7, .3> }
    translate <-3, 0, -3>
}
torus { .7, .2 pigment { rgb <.3, .5, .9> } rotate 70*x
        translate <3.5, 1, 2> }
sphere { <5, .7, -3>, .6 pigment { rgb <.8, .2, .2> } no_shadow }
union {
    box { <-.4, 0, -.4>, <.4, 1.2, .4> no_shadow }
    sphere { 1.6*y, .4 }
    pigment { rgb <.5, .8, .4> }
    translate <-5.5, 0, 1>
}
