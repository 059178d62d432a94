// A stage: letters and a star of prisms in spotlights, a row of footlights with fading,
// and a moon with parallel rays.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.4, -11> right 4/3*x angle 48 look_at <0, 1.9, 0> }
#default { finish { ambient .04 diffuse .75 } }

// The floor, the curtain and the wings.
plane { y, 0
        pigment { brick rgb <.15, .1, .06>, rgb <.55, .38, .22> brick_size <2.4, 1, .35> mortar .02 }
        finish { reflection .08 } }
#for (I, -12, 12)
    cylinder {
        <.5*I, 0, 3>, <.5*I, 7, 3>, .36
        pigment { rgb <.5, .08, .1> }
    }
#end
#declare wing = box { <0, 0, -.1>, <1.2, 6.5, .1> pigment { rgb <.3, .25, .35> } }
object { wing rotate 25*y translate <-5.6, 0, -1> }
object { wing rotate -25*y translate <4.5, 0, -1.5> }

text {
    ttf "timrom.ttf" "CYBER" .5, 0
    pigment { rgb <.9, .85, .6> }
    finish { specular .5 roughness .04 }
    scale 1.35
    translate <-3.7, .02, .1>
}
text {
    ttf "cyrvetic.ttf" "205" .4, .03*x
    pigment { gradient y color_map { [0 rgb <.9, .4, .2>] [1 rgb <.95, .8, .3>] } scale 1.2 }
    scale <1.5, 1.9, 1.5>
    rotate -12*y
    translate <1.15, .02, -1.4>
}
// A hanging star with a hole.
prism {
    linear_sweep -.15, .15, 16
    #for (I, 0, 10)
        <sin(I*pi/5), cos(I*pi/5)>*(mod(I, 2) ? .45 : 1.1)
    #end
    <.2, 0>, <0, .2>, <-.2, 0>, <0, -.2>, <.2, 0>
    pigment { rgb <.95, .9, .5> }
    finish { ambient .3 phong .6 }
    rotate <90, 20, 6>
    translate <0, 4.1, .4>
}

light_source { <-7, 8, -8>, rgb <1, .9, .8> spotlight point_at <-1.9, .7, 0> radius 11 falloff 15 }
light_source { <7, 9, -7>, rgb <.6, .8, 1> spotlight point_at <2.2, .8, -1.3> radius 8 falloff 13 tightness 4 }
light_source { <0, 9, -6>, rgb <1, .95, .7>*.9 cylinder point_at <0, 4.1, .4> radius 1.1 falloff 1.6 }
light_source { <3, 8, -12>, rgb <.14, .16, .24> parallel point_at <0, 0, 0> }
#for (I, -1, 1)
    light_source { <3*I, .25, -4.2>, rgb <.8, .5, .3> fade_distance 1.2 fade_power 2 }
#end
