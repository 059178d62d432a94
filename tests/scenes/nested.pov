// Glass in glass: the media that a ray enters and leaves, and the rays that are levels.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 1/500 }
background { rgb <.4, .5, .7> }
camera { location <.2, 3.1, -10> right 4/3*x angle 46 look_at <.1, .5, 0> }
light_source { <-5, 9, -6>, rgb .8 }
#default { finish { ambient .1 diffuse .6 } }

plane { y, -1.03 pigment { checker rgb <.9, .9, .8> rgb <.3, .2, .2> } }
box { <-7, -1.1, 5.02>, <7.1, 3.35, 6>
      pigment { checker rgb <.9, .6, .2> rgb <.2, .3, .6> } }

// A tumbler of water, which extends into the glass, so that no faces coincide. The
// water contains a ball of glass, and a bubble of air that overlaps the ball. Some
// objects cast no shadow, because POV-Ray's shadows depend on earlier shadow rays.
difference {
    cylinder { -y, 1.4*y, 1 }
    cylinder { -.85*y, 1.5*y, .88 }
    pigment { rgbt <.95, 1, .97, .95> }
    finish { reflection { 0, 1 fresnel } specular .4 }
    interior { ior 1.5 }
    translate <-2.6, 0, -.4>
}
cylinder {
    -.91*y, .97*y, .93
    pigment { rgbf <.85, .95, 1, .95> }
    interior { ior 1.33 }
    no_shadow
    translate <-2.6, 0, -.4>
}
sphere {
    <-2.75, -.1, -.6>, .45
    pigment { rgbt <1, .9, .9, .9> }
    finish { reflection { .02, .9 fresnel } }
    interior { ior 1.6 }
}
sphere {
    <-2.17, .2, -.55>, .3
    pigment { rgbt 1 }
    interior { ior 1 }
}

// Two overlapping balls of glass as separate bodies, and two as one union.
sphere {
    <-.55, .1, -1.6>, .6
    pigment { rgbt <1, 1, 1, .9> }
    interior { ior 1.4 }
}
sphere {
    <.17, .25, -1.45>, .5
    pigment { rgbt <.9, 1, .9, .9> }
    interior { ior 1.4 }
}
union {
    sphere { <-.45, 1.65, -1>, .6 }
    sphere { <.25, 1.8, -1.2>, .5 }
    pigment { rgbt <1, 1, .9, .9> }
    finish { reflection { 0, 1 fresnel } }
    interior { ior 1.5 }
    no_shadow
}

// More panes without refraction than the maximum level, before a ball of glass.
#declare pane = box { <-.6, -.8, 0>, <.6, .8, .05>
                      pigment { rgbt <.9, .95, 1, .92> } }
#for (i, 0, 7)
    object { pane rotate 12*y translate <1.7 + .04*i, -.1, -2.5 + .3*i> }
#end
sphere {
    <2.15, .1, .9>, .7
    pigment { rgbf <1, .9, .8, .9> }
    interior { ior 1.5 }
}

// A pipe whose open ends face away: rays that enter its glass may leave without a hit.
cylinder {
    <3.25, -.4, -.4>, <3.85, 1.6, -.1>, .6 open
    pigment { rgbft <.9, 1, .9, .5, .4> }
    interior { ior 1.3 }
}
// A ball with Fresnel reflection, half inside glass.
sphere {
    <2.9, -.6, -2.6>, .33
    pigment { rgb <.2, .1, .1> }
    finish { reflection { 0, 1 fresnel } }
    interior { ior 1.8 }
}
sphere {
    <2.75, -.45, -2.7>, .55
    pigment { rgbt <1, 1, 1, .95> }
    interior { ior 1.45 }
}
