// A label: hills in front of the sun, with a striped frame. It makes label.png for shop.pov:
// rt205 render label.pov --samples 4 -W 96 -H 48 -o label.png
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <1, .5, -4> direction z right 2*x up y }
light_source { <1, .5, -1e4>, 0 }
#default { finish { ambient 1 diffuse 0 } }
plane { z, 3 pigment { gradient y color_map { [0 rgb <.95, .75, .4>] [.9 rgb <.15, .35, .65>] } } }
disc { <1.3, .55, 2>, z, .22 pigment { rgb <1, .85, .3> } }
polygon { 5, <0, .1>, <.5, .6>, <.9, .3>, <1.2, .1>, <0, .1> pigment { rgb <.25, .4, .3> } translate z }
polygon { 5, <.6, .1>, <1.4, .45>, <1.8, .25>, <2, .1>, <.6, .1> pigment { rgb <.15, .3, .2> } translate .5*z }
difference {
    box { <-1, -1, 0>, <3, 2, .1> }
    box { <.08, .1, -1>, <1.92, .9, 1> }
    pigment { gradient x color_map { [.5 rgb <.7, .15, .1>] [.5 rgb <.95, .9, .8>] } scale .125 translate .0137*x }
}
