// Prisms in solids: cut, cutting, open, with many teeth, of glass.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 6 }
camera { location <0, 5, -9> look_at <0, 0, 0> angle 45 }
light_source { <-5, 9, -9>, rgb 1 }
background { color rgb <.2, .2, .25> }
plane { y, -1.3 pigment { color rgb <.7, .7, .65> } }

#declare Teeth = 14;
#declare Comb = prism { -1, 1, 4*Teeth + 3,
    <-1.5, -.5>,
    #for (I, 0, Teeth - 1)
        #declare X = -1.5 + 3*I/Teeth;
        <X, .5>, <X + 1.5/Teeth, .5>, <X + 1.5/Teeth, -.3>, <X + 3/Teeth, -.3>,
    #end
    <1.5, -.5>, <-1.5, -.5> }

difference { object { Comb pigment { color rgb <.9, .4, .3> } }
    sphere { <0, .3, -.3>, .9 pigment { color rgb <.3, .5, .9> } }
    cylinder { <-2, 0, .1>, <2, 0, .1>, .25 pigment { color rgb <.9, .9, .2> } }
    rotate <10, 30, 5> translate <-1.8, 0, 0> }

// Subtracted from a box.
difference { box { -1, 1 pigment { color rgb <.3, .7, .4> } }
    prism { -1.5, 1.5, 8, <.8, 0>, <.2, .2>, <0, .8>, <-.2, .2>, <-.8, 0>,
        <-.2, -.2>, <0, -.8>, <.2, -.2> pigment { color rgb <.9, .8, .3> } }
    object { Comb scale <.5, .5, 1> rotate 90*x pigment { color rgb <.8, .3, .8> } }
    rotate <-15, 40, 0> translate <2, 0, .3> }

// An open prism and one of glass, in other solids.
intersection { prism { -1, 1, 5, <-.8, -.7>, <.9, -.6>, <.5, .8>, <-.6, .6>,
        <-.8, -.7> open pigment { color rgb <.2, .6, .9> } }
    sphere { 0, 1 pigment { color rgb <.9, .9, .9> } }
    rotate <-25, 20, 10> translate <.1, -.2, -2.6> }
merge { prism { 0, .7, 4, <0, .5>, <-.5, -.4>, <.5, -.4>, <0, .5> }
    sphere { <0, .7, 0>, .35 }
    pigment { color rgbf <1, .8, .8, .8> } interior { ior 1.3 }
    translate <0, -1, 1.9> }
