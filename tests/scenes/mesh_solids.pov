// Meshes as parts of solids: bodies with an inside, and surfaces without one.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 4 }
camera { location <.7, 3.1, -9> look_at <0, .35, 0> right x*4/3 angle 44 }
light_source { <6, 9, -7>, rgb .9 }
light_source { <-7, 5, -6>, rgb <.3, .35, .4> }
background { color rgb <.35, .45, .6> }
plane { y, -1.1 pigment { checker rgb .85 rgb .5 } }

#macro Face(P, Q, R) triangle { P, Q, R } #end
#macro Bend(P, Q, R) smooth_triangle { P, P + .2*y, Q, Q, R, R - .1*x } #end
// A star with eight points around an axis: a line crosses it up to ten times.
#declare Star = mesh {
    #for (I, 0, 15)
        #local A = I*pi/8; #local B = (I + 1)*pi/8;
        #local P = <cos(A), .07*sin(3*A), sin(A)>*(mod(I, 2) ? .45 : 1);
        #local Q = <cos(B), .07*sin(3*B), sin(B)>*(mod(I, 2) ? 1 : .45);
        #if (I = 15) #local Q = <1, 0, 0>; #end
        Face(P, Q, <.02, .6, .01>) Face(Q, P, <.01, -.5, .03>)
    #end
    inside_vector <.31, .83, .17> }
#declare Gem = mesh {
    #for (I, -1, 1, 2) #for (J, -1, 1, 2) #for (K, -1, 1, 2)
        Bend(<I, 0, .1>, <.1, J, 0>, <0, .1, K>)
    #end #end #end
    inside_vector <-.73, .22, .41> }
#declare Sheet = mesh2 {
    vertex_vectors { 5, <-1, -.9, .1>, <1.1, -1, -.2>, <.9, 1, .2>, <-1, .8, -.1>,
        <.05, .02, .5> }
    face_indices { 4, <0, 1, 4>, <1, 2, 4>, <2, 3, 4>, <3, 0, 4> } }

difference {                                    // a star subtracted from a box
    box { <-.9, -.5, -.9>, <.9, .5, .9> }
    object { Star scale 1.1 rotate <80, 10, 5> pigment { rgb <.9, .5, .2> } }
    object { Star scale .25 rotate 80*x translate <.75, .35, -.9> }
    rotate -25*y translate <-2.5, .1, 1> pigment { rgb <.3, .6, .4> } finish { phong .5 } }
intersection {                                  // smooth, with a ball
    object { Gem scale 1.25 } sphere { 0, .85 pigment { rgb <.2, .3, .8> } }
    rotate <10, 20, 0> translate <0, .1, 1.6> pigment { rgb <.9, .8, .4> } }
merge {                                         // two stars and a rod
    object { Star } object { Star rotate <60, 40, 20> pigment { rgb <.4, .7, .9> } }
    cylinder { -1.2*y, 1.2*y, .2 open }
    translate <2.4, .2, 1.2> pigment { rgb <.8, .3, .4> } finish { reflection .15 } }
difference {                                    // a subtracted surface without an inside
    box { -.7, .7 } object { Sheet scale .8 } sphere { <.4, .3, 0>, .3 }
    translate <-2.6, -.2, -1.8> pigment { rgb <.9, .9, .3> } }
intersection {                                  // a surface inside a body, and a subtracted star
    object { Gem } object { Sheet scale 2 rotate 35*y pigment { rgb <.9, .2, .6> } }
    difference { box { -1, 1 } object { Star scale .7 rotate 90*x } }
    translate <-1, -.15, -2> scale .9 }
object { Gem                                    // a mesh that is clipped by a mesh
    clipped_by { object { Star scale 1.3 rotate <70, 0, 15> } sphere { .3*z, 1 inverse } }
    scale .8 translate <1.1, -.2, -2.1> pigment { rgb <.5, .9, .6> } }
sphere { 0, .8                                  // clipped by an inverted mesh, bounded by a mesh
    clipped_by { object { Star scale 1.2 rotate 75*x inverse } }
    bounded_by { object { Star scale 9 } }
    translate <2.9, -.2, -1.9> pigment { rgb <.6, .5, .9> } }
