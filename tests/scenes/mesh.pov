// Meshes: a ridge of triangles, a smooth saddle, a reflecting stone, a mirror, a union.
// POV-Ray stores the points of meshes in 32 bits, so they are multiples of 1/16 here.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 6 }
camera { location <1, 4.5, -9> look_at <0, .2, 0> angle 42 }
light_source { <6, 12, -9>, rgb .9 }
light_source { <-8, 5, -4>, rgb <.2, .25, .4> }
background { color rgb <.15, .2, .3> }

plane { y, -1.25 pigment { checker color rgb .85 color rgb .4 scale .7 } }

#macro Ridge(I, J) <I/2, mod(abs(5*I*I + 3*J + 7*I*J), 9)/8 - .5, J/2> #end
mesh {
    #for (I, -3, 2)
        #for (J, -2, 1)
            triangle { Ridge(I, J), Ridge(I + 1, J), Ridge(I, J + 1) }
            triangle { Ridge(I + 1, J + 1), Ridge(I + 1, J), Ridge(I, J + 1) }
        #end
    #end
    triangle { <0, 2, 0>, <1, 2, 1>, <2, 2, 2> } // no area: ignored
    pigment { color rgb <.5, .65, .3> } finish { specular .3 roughness .05 }
    rotate -20*y scale <1, .8, 1> translate <-2.2, -.3, 1.6> }

// y = x^2 / 4 - z^2 / 4, and its gradient.
#macro Saddle(I, J) <I/2, (I*I - J*J)/16, J/2>, <-I/4, 1, J/4> #end
mesh {
    #for (I, -2, 1)
        #for (J, -2, 1)
            smooth_triangle { Saddle(I, J), Saddle(I + 1, J), Saddle(I, J + 1) }
            smooth_triangle { Saddle(I + 1, J + 1), Saddle(I, J + 1),
                Saddle(I + 1, J) }
        #end
    #end
    pigment { checker color rgb <.9, .5, .2> color rgb <.9, .8, .6> scale .4 }
    finish { phong .7 phong_size 30 }
    scale 1.4 rotate <-25, 30, 5> translate <2.2, .4, .6> }

#declare Stone = mesh2 {
    vertex_vectors { 6, <1, 0, 0>, <-1, 0, 0>, <0, 1.25, 0>, <0, -1, 0>,
        <0, 0, 1>, <0, 0, -1> }
    face_indices { 8, <0, 2, 4>, <2, 1, 4>, <1, 3, 4>, <3, 0, 4>,
        <2, 0, 5>, <1, 2, 5>, <3, 1, 5>, <0, 3, 5> } }

object { Stone pigment { color rgb <.9, .95, .6> }
    finish { phong .8 reflection .3 diffuse .4 }
    scale .8 rotate <10, 25, 15> translate <.2, -.3, -2.4> }

// Smooth: each vertex has a normal; one face has another normal at a vertex.
mesh2 {
    vertex_vectors { 6, <1, 0, 0>, <-1, 0, 0>, <0, 1, 0>, <0, -1, 0>,
        <0, 0, 1>, <0, 0, -1> }
    normal_vectors { 7, <2, 0, 0>, <-2, 0, 0>, <0, 2, 0>, <0, -2, 0>,
        <0, 0, 2>, <0, 0, -2>, <1, 1, -1> }
    face_indices { 8, <0, 2, 4>, <2, 1, 4>, <1, 3, 4>, <3, 0, 4>,
        <2, 0, 5>, <1, 2, 5>, <3, 1, 5>, <0, 3, 5> }
    normal_indices { 8, <0, 2, 4>, <2, 1, 4>, <1, 3, 4>, <3, 0, 4>,
        <2, 0, 6>, <1, 2, 5>, <3, 1, 5>, <0, 3, 5> }
    pigment { color rgb <.4, .6, .9> } finish { phong .5 }
    scale .6 rotate <0, 20, 0> translate <-2.4, -.4, -2.2> }

// A mirror of two triangles; a third triangle coincides with the first.
mesh {
    triangle { <-2, 0, 0>, <2, 0, 0>, <-2, 2, 0> }
    triangle { <2, 0, 0>, <-2, 2, 0>, <2, 2, 0> }
    triangle { <-2, 0, 0>, <2, 0, 0>, <-2, 2, 0> }
    pigment { color rgb .1 } finish { reflection .7 diffuse .2 }
    rotate <8, 12, 0> translate <.3, -.6, 3.4> }

union {
    triangle { <-.5, 0, -.5>, <.5, 0, -.5>, <0, 1, 0>
        pigment { color rgb <.9, .3, .3> } }
    triangle { <.5, 0, -.5>, <0, 0, .5>, <0, 1, 0> }
    smooth_triangle { <0, 0, .5>, <0, .5, 1>, <-.5, 0, -.5>, <-1, .5, -.4>,
        <0, 1, 0>, <-.3, 1, .3> finish { phong .6 } }
    sphere { <0, 1.1, 0>, .2 }
    pigment { color rgb <.8, .7, .4> }
    scale 1.2 rotate -30*y translate <2.4, -1.2, -2.2> }
