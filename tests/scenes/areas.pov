// Area lights: grids with sides of every kind, circles, spotlights, behind transparent bodies,
// transformed. A light of one point has no area, and a shadowless light sends no shadow rays.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 }
background { rgb <.05, .06, .1> }
camera { location <0, 6, -9> look_at <0, .3, 0> angle 50 }
light_source { <-4, 5, -2>, rgb <.5, .4, .3> area_light <1.5, 0, 0>, <0, 0, 1>, 4, 3 }
light_source { <4, 6, 0>, rgb <.3, .3, .5> area_light <1, .2, 0> <0, 0, 1>, 3, 5
    circular adaptive 1 }
light_source { <0, 0, 0>, rgb <.3, .5, .3> area_light x, z, 5.9, 1
    scale <2, 1, 1> rotate 40*y translate <1, 4, 3> }
light_source { <-1, 5, 1>, rgb <.6, .4, .4> area_light .7*x, .7*z, 2, 2 spotlight
    point_at <0, 0, 0> radius 15 falloff 25 tightness 2 }
light_source { <5, 3, -6>, rgb .2 area_light x, y, 1, 1 }
light_source { <-5, 3, -6>, rgb .1 area_light x, y, 3, 3 shadowless }
light_source { <0, 1.5, -4>, rgb .4 area_light x, .5*z, 2, 3 fade_distance 2
    fade_power 2 }
#default { finish { ambient .1 diffuse .7 specular .3 roughness .04 phong .2 } }
plane { y, 0 pigment { rgb .8 } }
sphere { <-2.4, .8, 0>, .8 pigment { rgbf <1, .9, .7, .7> } }
sphere { <-.2, .6, .6>, .6 pigment { rgb <.9, .8, .3> } finish { metallic } }
box { <1, 0, -1>, <2, 1, 0> pigment { rgb <.6, .7, .9> } finish { reflection .2 } }
difference {
    sphere { <3.6, .9, 1>, .9 }
    box { <3, .8, -1>, <5, 2, 3> }
    pigment { rgb <.8, .5, .5> }
}
disc { <-1, 2, -1>, y, .7, .3 pigment { checker rgbt <.6, .8, .9, .5> rgb 1 scale .3 } }
torus { .9, .25 rotate 20*x translate <-2.4, .6, 3> pigment { rgb .7 } }
