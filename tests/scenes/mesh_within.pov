// The camera is inside a transparent body of triangles, with and without inside vector.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 9 }
camera { location <.12, .2, -.31> look_at <0, .1, 3> right x*4/3 angle 70 }
light_source { <5, 9, -6>, rgb .9 }
background { color rgb <.35, .45, .6> }
box { <-20, -3, -9>, <20, 12, 14> pigment { checker rgb .9 rgb .45 scale 2 } }
sphere { <.6, .5, 5>, 1 pigment { rgb <.8, .3, .2> } }

#macro Gem()
    mesh {
        #for (I, -1, 1, 2) #for (J, -1, 1, 2) #for (K, -1, 1, 2)
            triangle { <I, 0, .1>, <.1, J, 0>, <0, .1, K> }
        #end #end #end
#end
Gem() inside_vector <-.73, .22, .41> rotate <10, 25, 0> scale 1.6
    pigment { rgbf <.9, .95, 1, .9> } interior { ior 1.3 } }
Gem() rotate <20, -15, 0> scale 2.4 translate .2*z
    pigment { rgbf <1, .9, .8, .9> } interior { ior 1.15 } }
