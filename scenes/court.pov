// A court: all surfaces are smooth, and perturbed normals make them look rough.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 5 }
camera { location <2.4, 3, -9.6> look_at <0, 1.15, 0> angle 46 }
light_source { <-7, 11, -8>, rgb <1, .95, .85> }
light_source { <9, 6, -7>, rgb <.25, .28, .35> shadowless }
sky_sphere {
    pigment { gradient y color_map { [0 rgb <.85, .85, .8>] [.5 rgb <.3, .5, .8>] [1 rgb <.2, .3, .6>] } }
}
#default { finish { ambient .15 diffuse .75 } }

#declare Copper = finish {
    ambient .1 diffuse .4 specular .8 roughness .03 metallic
    reflection { .25, .5 metallic }
}

// The wall, and its coping
#declare Wall = box {
    <-6, 0, 0>, <6, 3.6, .4>
    texture {
        pigment { brick rgb <.62, .58, .52>, rgb <.62, .3, .2> brick_size <1, .36, .48> mortar .05 }
        normal { brick -.3 brick_size <1, .36, .48> mortar .05 accuracy .01 }
        translate <.17, .07, .21>
    }
}
difference {
    object { Wall }
    cylinder { <0, 2.05, -1>, <0, 2.05, 1>, .85 }
    box { <-.85, -1, -1>, <.85, 2.05, 1> }
    translate 3*z
}
box {
    <-6.1, 3.6, 2.9>, <6.1, 3.85, 3.5>
    pigment { rgb <.7, .66, .58> }
    normal { gradient y slope_map { [0 <0, 1>] [.5 <.4, 0>] [1 <0, -1>] } scale .125 translate 3.6*y }
}

// Fluted columns
#declare Column = union {
    cylinder {
        0, 2.6*y, .3
        pigment { rgb <.85, .82, .74> }
        normal { radial 2 frequency 16 slope_map { [0 <0, 1>] [.5 <.5, 0>] [1 <0, -1>] } }
    }
    torus { .32, .09 translate .09*y }
    torus { .32, .09 translate 2.6*y }
    box { <-.45, 2.66, -.45>, <.45, 2.86, .45> }
    sphere {
        3.3*y, .45
        pigment { rgb <.9, .5, .3> }
        normal { leopard 1.6 scale .04 }
        finish { Copper }
    }
    pigment { rgb <.85, .82, .74> }
}
object { Column translate <-2.6, 0, 1.5> }
object { Column translate <2.6, 0, 1.5> }

// Paving, and a round pool with circular waves
difference {
    box { <-90, -.5, -20>, <90, 0, 300> }
    cylinder { -y, y, 2.1 translate <-.3, 0, -1.7> }
    texture {
        pigment { hexagon rgb <.7, .62, .5>, rgb <.62, .56, .48>, rgb <.76, .68, .56> }
        normal { hexagon .35 accuracy .03 }
        scale .31
        translate <.11, 0, .07>
    }
}
torus {
    2.15, .16
    pigment { rgb <.75, .72, .66> }
    normal { radial 1.2 frequency 24 sine_wave poly_wave .4 }
    translate <-.3, .02, -1.7>
}
disc {
    <-.3, -.12, -1.7>, y, 2.1
    pigment { rgb <.03, .12, .14> }
    normal {
        average normal_map {
            [1 onion .35 sine_wave scale .3 translate <.4, 0, .3>]
            [.6 onion .5 sine_wave phase .4 scale .2 translate <-1, 0, -.5>]
        }
        translate <-.3, 0, -1.7>
    }
    finish { ambient .1 diffuse .3 specular .9 roughness .004 reflection { .15, .9 falloff 3 } }
}

// A turned bowl and balls in front of the pool
difference {
    sphere { 0, .75 }
    sphere { .15*y, .68 }
    box { <-1, .25, -1>, <1, 1, 1> }
    pigment { rgb <.95, .75, .35> }
    normal { gradient y 1 sine_wave scale .13 }
    finish { Copper }
    translate <2.7, .72, -2.9>
}
sphere {
    <1.55, .36, -3.9>, .36
    pigment { rgb <.2, .45, .5> }
    normal { checker normal { gradient x 1.5 sine_wave scale .08 } normal { gradient y 1.5 sine_wave scale .08 }
        scale .24 translate .071 }
    finish { specular .6 roughness .02 }
}
