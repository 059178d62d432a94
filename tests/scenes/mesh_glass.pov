// Light through meshes: with and without an inside vector, sheets, a field, parts.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 9 }
camera { location <.4, 2.6, -8> look_at <0, .2, 0> right x*4/3 angle 46 }
light_source { <5, 9, -6>, rgb .9 }
light_source { <-7, 5, -4>, rgb <.3, .35, .4> }
background { color rgb <.35, .45, .6> }
plane { y, -1.2 pigment { checker rgb .9 rgb .45 } }

#macro Gem(Inside)
    mesh {
        #for (I, -1, 1, 2) #for (J, -1, 1, 2) #for (K, -1, 1, 2)
            triangle { <I, 0, .1>, <.1, J, 0>, <0, .1, K> }
        #end #end #end
        #if (Inside) inside_vector <-.73, .22, .41> #end
#end
#declare Dent = mesh {                          // rays cross it four times or more
    #for (I, 0, 11)
        #local A = I*pi/6; #local B = mod(I + 1, 12)*pi/6;
        #local P = <cos(A), .1*sin(2*A), sin(A)>*(mod(I, 2) ? .4 : 1);
        #local Q = <cos(B), .1*sin(2*B), sin(B)>*(mod(I, 2) ? 1 : .4);
        triangle { P, Q, <.02, .7, .01> } triangle { Q, P, <.01, -.6, .03> }
    #end }

Gem(no) scale .9 rotate <10, 25, 0> translate <-2.4, -.1, .8>
    pigment { rgbf <.9, .95, 1, .9> } interior { ior 1.4 } finish { phong .6 } }
Gem(yes) scale .9 rotate <15, -20, 5> translate <2.3, -.1, 1>
    pigment { rgbt <1, .8, .6, .7> } interior { ior 1.2 } finish { reflection .1 } }
object { Dent rotate <70, 10, 0> translate <0, .4, 1.8>
    pigment { checker rgbf <.6, 1, .7, .8> rgbf <.9, .8, .5, .6> scale .4 }
    interior { ior 1.1 } }
smooth_triangle {                               // a sheet: rays are inside it after the hit
    <-3, -1, -2>, <-.2, 0, -1>, <-1.6, -1, -2.4>, <.2, 0, -1>, <-2.3, .9, -2.1>, <0, .2, -1>
    pigment { rgbt <.8, .5, .9, .6> } }
mesh2 {
    vertex_vectors { 5, <-1, -.9, .1>, <1.1, -1, -.2>, <.9, 1, .2>, <-1, .8, -.1>,
        <.05, .02, .5> }
    face_indices { 4, <0, 1, 4>, <1, 2, 4>, <2, 3, 4>, <3, 0, 4> }
    scale .7 rotate 20*y translate <-.4, -.4, -2> pigment { rgbf <.7, .9, 1, .85> } no_shadow }
height_field { function 9, 9 { .4 + .3*sin(7*x)*cos(5*y) }
    translate <-.5, 0, -.5> scale <1.6, 1, 1.4> translate <1.5, -1, -2>
    pigment { rgbf <.6, .8, .5, .7> } }
difference {                                    // a hollow in glass
    sphere { 0, .8 }
    Gem(yes) scale .6 pigment { rgbf <1, .6, .5, .8> } }
    translate <2.9, -.3, -1.6> pigment { rgbf <.9, .9, .95, .9> } interior { ior 1.3 } }
