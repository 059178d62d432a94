// Surfaces of cubic and poly, and a visible lamp.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -12> look_at 0 angle 50 }
#declare Lamp = light_source {
    <-1, 4, 0>, .8
    looks_like {
        sphere { 0, .5 pigment { rgb <1, .3, .2> } finish { ambient 1 diffuse 0 } }
        scale <1.2, 1, 1>
    }
};
light_source { Lamp rotate 5*z translate <1, -1, -1> }
light_source { <4, 5, -6>, .5 }
plane { y, -2 pigment { checker rgb 1 rgb .5 } }
poly { 2, <1, .2, -.1, .3, 1, .5, -.8, 2, .6, -1.2> pigment { rgb <.9, .6, .2> } translate 3*x }
cubic {
    <0, 0, 0, 1, 0, 0, 0, 0, 0, 0, .3, 0, 1, 0, 0, 0, 0, 1, 0, -1.2>
    pigment { rgb <.2, .6, .9> } translate -3*x
}
intersection {
    poly { 3, <.4, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1> }
    sphere { 0, 1.4 }
    pigment { rgb <.2, .9, .2> } translate <2, 1.4, 3>
}
poly {
    4, <1, 0,0,0, 0,0,0, 0,0,0, 0,0,0,0,0,0,0,0,0,0,
        1, 0,0,0,0,0,0,0,0,0, 1, 0, 0, 0, -1>
    pigment { rgb <.6, .3, .5> } translate -y
}
