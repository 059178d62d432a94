// Sails, hulls and flags of Bezier patches, under a sky with a gradient.
//     rt205 render scenes/sails.pov -o sails.png --samples 3
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 4 }
camera { location <-2.5, 2.2, -14> right x*image_width/image_height angle 40 look_at <0, 2.3, 0> }
light_source { <-30, 25, -20>, rgb <1, .95, .85> }

sky_sphere {
    pigment {
        gradient y
        color_map { [0 rgb <.95, .85, .7>] [.08 rgb <.8, .85, .9>] [.25 rgb <.45, .65, .9>] [.6 rgb <.15, .3, .65>] }
    }
}
plane { y, 0 pigment { gradient z color_map { [0 rgb <.03, .14, .2>] [.5 rgb <.05, .2, .26>] [1 rgb <.03, .14, .2>] } scale 1.4 translate -70*z }
    finish { ambient .2 diffuse .5 reflection .35 } }

#declare Canvas = texture {
    pigment { gradient y color_map { [0 rgb <.95, .93, .86>] [.9 rgb <.93, .9, .82>] [.9 rgb <.75, .72, .66>] } scale .62 translate -6.2*y }
    finish { ambient .25 diffuse .7 }
}

// A sail, from the mast to the leech and from the boom to the head; wind bends it towards -z.
#declare Main = bicubic_patch {
    type 1 flatness .003 u_steps 4 v_steps 4
    <0, .55, 0>, <.7, .5, -.25>, <1.4, .5, -.25>, <2.1, .55, 0>
    <0, 1.9, 0>, <.6, 1.9, -.75>, <1.3, 1.9, -.75>, <1.85, 2, -.15>
    <0, 3.2, 0>, <.4, 3.2, -.6>, <.8, 3.2, -.6>, <1.15, 3.3, -.2>
    <0, 4.4, 0>, <.05, 4.4, -.05>, <.1, 4.4, -.05>, <.15, 4.4, 0>
    texture { Canvas }
}
#declare Jib = bicubic_patch {
    type 1 flatness .003 u_steps 4 v_steps 4
    <-1.9, .5, 0>, <-1.35, .4, -.3>, <-.8, .4, -.35>, <-.2, .5, -.1>
    <-1.3, 1.6, 0>, <-1, 1.5, -.6>, <-.6, 1.5, -.65>, <-.15, 1.6, -.3>
    <-.7, 2.6, 0>, <-.55, 2.6, -.4>, <-.3, 2.6, -.4>, <-.1, 2.6, -.15>
    <-.08, 3.8, 0>, <-.07, 3.8, 0>, <-.06, 3.8, 0>, <-.05, 3.8, 0>
    texture { Canvas }
}
#declare Side = bicubic_patch {
    type 1 flatness .002 u_steps 4 v_steps 4
    <-2, .42, 0>, <-1, .3, -.75>, <1, .3, -.75>, <2.1, .38, -.3>
    <-1.7, .1, 0>, <-.9, 0, -.65>, <1, 0, -.65>, <2, .1, -.28>
    <-1.3, -.2, 0>, <-.7, -.25, -.4>, <1, -.25, -.4>, <1.9, -.15, -.2>
    <-1, -.35, 0>, <-.5, -.4, 0>, <1, -.4, 0>, <1.8, -.3, 0>
}
#declare Flag = bicubic_patch {
    type 1 flatness .002 u_steps 4 v_steps 4
    <0, 0, 0>, <.25, .05, .25>, <.45, -.05, -.3>, <.7, 0, .05>
    <0, .13, 0>, <.25, .18, .25>, <.45, .08, -.3>, <.7, .13, .05>
    <0, .26, 0>, <.25, .31, .25>, <.45, .21, -.3>, <.7, .26, .05>
    <0, .4, 0>, <.25, .45, .25>, <.45, .35, -.3>, <.7, .4, .05>
}

#macro Boat(Paint, Pennant)
    union {
        object { Main }
        object { Jib }
        union {
            object { Side }
            object { Side scale <1, 1, -1> }
            pigment { gradient y color_map { [.5 rgb Paint*.6] [.5 rgb .9] [.55 rgb .9] [.55 rgb Paint] } scale .8 translate -.3*y }
            finish { ambient .2 diffuse .6 phong .4 phong_size 30 }
        }
        cylinder { -.1*y, 4.6*y, .035 }
        cylinder { <0, .5, 0>, <2.15, .5, 0>, .03 }
        object { Flag pigment { rgb Pennant } scale .8 translate <0, 4.3, 0> }
        disc { <.2, .3, 0>, y, 1 pigment { rgb <.6, .42, .25> } scale <1.5, 1, .5> }
        pigment { rgb <.45, .3, .18> } finish { ambient .2 diffuse .7 specular .2 }
    }
#end

object { Boat(<.7, .12, .1>, <.95, .8, .1>) rotate <0, 25, 4> translate <-1.6, 0, 0> }
object { Boat(<.1, .25, .5>, <.8, .15, .1>) rotate <0, 10, 3> scale .8 translate <3.4, 0, 4.5> }
object { Boat(<.12, .4, .25>, <.2, .3, .8>) rotate <0, 40, 2> scale .7 translate <-3.6, 0, 11> }
object { Boat(<.5, .5, .55>, <.9, .5, .1>) rotate <0, 15, 3> scale .6 translate <8, 0, 17> }
