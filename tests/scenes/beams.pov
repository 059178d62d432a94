// Lights with limited directions, and fading lights: cones and cylinders with soft
// edges, sharp edges and none, with and without tightness; parallel rays from the
// front and from the back of the lit objects; through transparent bodies, without
// shadows, transformed.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 }
background { rgb <.05, .06, .1> }
camera { location <0, 7, -9> look_at <0, .3, 0> angle 52 }
light_source { <-4, 5, -2>, rgb <.9, .7, .5> spotlight point_at <-3, 0, 0>
    radius 9 falloff 16 tightness 4 }
light_source { <-1, 5, -2>, rgb <.5, .8, .5> spotlight point_at <-1, 0, .5>
    radius 14 falloff 10 }                              // a sharp edge
light_source { <2, 6, 2>, rgb <.4, .4, .9> spotlight }  // by default along z
light_source { <0, 0, 0>, rgb <.8, .3, .3> spotlight radius 95 falloff 120
    tightness 12 point_at <0, -1, 0> scale 2 translate <4, 4, -1> }
light_source { <3, 6, -2>, rgb .7 cylinder point_at <1, 0, 0>
    radius .6 falloff 1.1 tightness 1 fade_distance 5 fade_power 1.5 }
light_source { <1, .9, 4>, rgb <.7, .6, .2> cylinder point_at <1, 0, 4> }
light_source { <-5, 6, 3>, rgb <.2, .25, .35> parallel point_at <0, 1, 0> }
light_source { <0, -3, 0>, rgb .1 parallel point_at <.3, -9, 0>
    fade_distance 2 fade_power 2 }                      // behind the plane
light_source { <-3, .6, 3>, rgb <.9, .5, .1> fade_distance .7 fade_power 2.5 }
light_source { <4.4, 3, 3>, rgb <.3, .1, .3> shadowless spotlight // spotlight cancels shadowless
    point_at <4, 0, 3> radius 10 falloff 30 }
light_source { <-9, 3, 3>, rgb <.1, .1, .2> cylinder point_at <4, 0, 3>
    shadowless }                                        // shadowless cancels cylinder
light_source { <-2, 3, -8>, rgb <.2, .1, .1> parallel spotlight point_at <0, 0, 1> }
light_source { <0, 2, -4>, rgb .3 fade_distance 3 }     // does not fade
#default { finish { ambient .1 diffuse .7 specular .3 roughness .04 phong .2 } }
plane { y, 0 pigment { rgb .8 } }
sphere { <-3, .8, 0>, .8 pigment { rgbf <1, .9, .7, .7> } }
sphere { <-.8, .6, .6>, .6 pigment { rgb <.9, .8, .3> } finish { metallic } }
box { <1, 0, -1>, <2, 1, 0> pigment { rgb <.6, .7, .9> } finish { reflection .2 } }
difference {
    sphere { <3.6, .9, .4>, .9 }
    box { <3, .8, -1>, <5, 2, 2> }
    pigment { rgb <.8, .5, .5> }
}
cylinder { <1, 0, 3>, <1, 1.4, 3>, .3 pigment { rgb <.4, .8, .7> } }
disc { <-2, 3, 1>, y, .7, .3 pigment { rgbt <.6, .8, .9, .5> } }
torus { .9, .25 rotate 20*x translate <-3.4, .6, 3> pigment { rgb .7 } }
