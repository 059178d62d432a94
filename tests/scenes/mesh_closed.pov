// Closed meshes from inside: a hollow of 192 triangles, seen from its centre along an
// axis, and a smooth mesh and a mirror inside it. No background may be visible.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 5 }
camera { location 0 direction z right 2*x up 1.5*y }
light_source { <.75, 1.25, -.5>, rgb .9 }
light_source { <0, 30, 0>, rgb <3, 0, 3> }
background { color rgb <3, 0, 3> }

// The points of a cube, at varying distances from its centre: multiples of 1/16,
// because POV-Ray stores them in 32 bits.
#macro Far(A, B, C)
    (<A, B, C> * (1 + mod(abs(13*A + 29*B*B + 53*C + A*B*C), 6)/16))
#end
#macro Side(A, B, C)
    triangle { Far(A.x, A.y, A.z), Far(B.x, B.y, B.z), Far(C.x, C.y, C.z) }
#end
#macro Square(P, Q, R)
    Side(P, P + Q, P + R)
    Side(P + Q + R, P + R, P + Q)
#end
mesh {
    #for (I, -2, 1)
        #for (J, -2, 1)
            Square(<I, J, 2>, x, y) Square(<I, J, -2>, x, y)
            Square(<2, I, J>, y, z) Square(<-2, I, J>, y, z)
            Square(<I, 2, J>, x, z) Square(<I, -2, J>, x, z)
        #end
    #end
    pigment { checker color rgb <.9, .85, .7> color rgb <.4, .5, .6> scale .5 }
    finish { phong .3 } }

#macro Round(A, B, C)
    smooth_triangle { A, A, B, B, C, C }
#end
#declare Ball = mesh {
    #for (I, -1, 1, 2)
        #for (J, -1, 1, 2)
            #for (K, -1, 1, 2)
                Round(I*x, <I, J, 0>*.75, <I, 0, K>*.75)
                Round(J*y, <I, J, 0>*.75, <0, J, K>*.75)
                Round(K*z, <I, 0, K>*.75, <0, J, K>*.75)
                Round(<I, J, 0>*.75, <I, 0, K>*.75, <0, J, K>*.75)
            #end
        #end
    #end }

object { Ball scale .5 rotate <20, 30, 0> translate <-.7, -.3, 1.5>
    pigment { color rgb <.9, .4, .3> } finish { phong .6 } }
object { Ball scale .4 rotate <40, 10, 0> translate <.6, .35, 1.4>
    pigment { color rgb .05 } finish { reflection .8 diffuse .1 } }
