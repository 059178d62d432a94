// A vase of smooth triangles: its normals follow from the profile. Flowers
// consist of triangles and discs, and a cloth of bicubic patches covers a table.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 }
background { rgb <.55, .6, .65> }
camera { location <.4, 3.6, -10> right 4/3*x angle 43 look_at <.1, 1.3, 0> }
light_source { <-6, 8, -7>, rgb .75 }
light_source { <5, 6, -8>, rgb .3 shadowless }
#default { finish { ambient .18 diffuse .65 } }

// The profile: the radius at a height, and its derivative.
#declare Radius = function(h) { .62 + .32*sin(2.1*h + .3) - .06*h*h + .05*h*h*h }
#declare Slope = function(h) { .672*cos(2.1*h + .3) - .12*h + .15*h*h }
#declare Steps = 22;
#declare Turns = 32;
#declare Top = 2.2;
#macro At(I, J) <Radius(Top*I/Steps)*cos(2*pi*J/Turns), Top*I/Steps, Radius(Top*I/Steps)*sin(2*pi*J/Turns)> #end
#macro Normal(I, J) <cos(2*pi*J/Turns), -Slope(Top*I/Steps), sin(2*pi*J/Turns)> #end
mesh {
    #for (I, 0, Steps - 1)
        #for (J, 0, Turns - 1)
            smooth_triangle { At(I, J), Normal(I, J), At(I + 1, J), Normal(I + 1, J), At(I + 1, J + 1), Normal(I + 1, J + 1) }
            smooth_triangle { At(I, J), Normal(I, J), At(I + 1, J + 1), Normal(I + 1, J + 1), At(I, J + 1), Normal(I, J + 1) }
        #end
    #end
    pigment { gradient y triangle_wave frequency 2.5 color_map { [.4 rgb <.15, .3, .6>] [.45 rgb .92] [1 rgb .92] } }
    finish { phong .7 phong_size 60 reflection .07 }
}
disc { 0, y, Radius(0) pigment { rgb <.15, .3, .6> } translate .01*y }

// Flowers: petals around a ring.
#macro Flower(Where, Leaves, Size, Turn, Colour)
    union {
        mesh {
            #for (I, 0, Leaves - 1)
                #local A = 2*pi*I/Leaves;
                #local B = 2*pi*(I + .5)/Leaves;
                #local C = 2*pi*(I - .5)/Leaves;
                triangle { 0, <cos(B), sin(B), -.5>*.55, <cos(A), sin(A), -.35> }
                triangle { 0, <cos(A), sin(A), -.35>, <cos(C), sin(C), -.5>*.55 }
            #end
            pigment { Colour }
        }
        disc { -.16*z, -z, .24 pigment { onion color_map { [0 rgb <.9, .7, .1>] [1 rgb <.5, .3, .1>] } scale .12 } }
        scale Size
        rotate Turn
        translate Where
    }
    #local Foot = <.15*Where.x, 2, .15*Where.z>;
    cylinder { Foot, Where, .03 pigment { rgb <.2, .45, .2> } }
#end
Flower(<-.9, 3.55, -.3>, 8, .6, <20, 30, 0>, rgb <.9, .3, .35>)
Flower(<.2, 4, -.2>, 12, .55, <15, -5, 10>, rgb <.95, .9, .95>)
Flower(<1.15, 3.3, -.1>, 7, .6, <25, -35, 0>, rgb <.95, .75, .2>)
Flower(<.35, 3.1, -.8>, 9, .45, <10, -15, 20>, rgb <.6, .4, .8>)

// The table and its cloth: patches that hang over the edge.
box { <-4, -.4, -2>, <4, -.03, 2.6> pigment { rgb <.4, .27, .18> } }
#macro Cloth(X)
    bicubic_patch {
        type 1 u_steps 3 v_steps 3
        <X, .01, 1.4>, <X + .45, .01, 1.4>, <X + .9, .01, 1.4>, <X + 1.35, .01, 1.4>,
        <X, .01, .2>, <X + .45, .01, .2>, <X + .9, .01, .2>, <X + 1.35, .01, .2>,
        <X, .01, -1>, <X + .45, .01, -1>, <X + .9, .01, -1>, <X + 1.35, .01, -1>,
        <X, .01, -2.03>, <X + .45, .01, -2.03>, <X + .9, .01, -2.03>, <X + 1.35, .01, -2.03>
        pigment { checker rgb <.85, .85, .75> rgb <.7, .25, .25> scale .34 translate .17 }
    }
    bicubic_patch {
        type 1 u_steps 5 v_steps 5
        <X, .01, -2.03>, <X + .45, .01, -2.03>, <X + .9, .01, -2.03>, <X + 1.35, .01, -2.03>,
        <X, -.05, -2.2>, <X + .45, -.05, -2.2>, <X + .9, -.05, -2.2>, <X + 1.35, -.05, -2.2>,
        <X, -.5, -2.1>, <X + .45, -.5, -1.9>, <X + .9, -.5, -2.5>, <X + 1.35, -.5, -2.1>,
        <X, -.9, -2.2>, <X + .45, -1, -1.9>, <X + .9, -1, -2.7>, <X + 1.35, -.9, -2.2>
        pigment { gradient y color_map { [.5 rgb <.85, .85, .75>] [.5 rgb <.7, .25, .25>] } scale .34 translate -2*y }
    }
#end
Cloth(-2.7) Cloth(-1.35) Cloth(0) Cloth(1.35)
plane { z, 6 pigment { rgb <.7, .66, .55> } }
