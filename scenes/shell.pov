// A sea shell of smooth triangles on a floor of flat ones: a tube that grows along a
// spiral, r = e^(w a). The floor has dunes, which are heights over the points of a grid.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <2.6, 2.7, -7.5> look_at <0, .1, .3> angle 34 }
background { color rgb <.55, .68, .8> }
light_source { <6, 9, -7>, color rgb .95 }
light_source { <-9, 5, -4>, color rgb <.25, .3, .4> shadowless }

#declare Turns = 3.6;                 // number of turns
#declare Growth = .17;                // exponent w, growth per radian
#declare Ends = exp(Growth*2*pi*Turns);

// The tube: A is the angle around the axis, B around the tube. Its size at the end is 1.
#macro Tube(A, B)
    #local S = exp(Growth*A)/Ends;
    #local R = S*(1 + .04*cos(24*A));
    <cos(A)*(S + .92*R*cos(B)), .95*R*sin(B) + 1.5*(1 - S), sin(A)*(S + .92*R*cos(B))>
#end
#macro Across(A, B)
    vcross(Tube(A, B + .01) - Tube(A, B - .01), Tube(A + .01, B) - Tube(A - .01, B))
#end
#macro Corner(I, J)
    Tube(I*2*pi*Turns/Along, J*2*pi/Round), Across(I*2*pi*Turns/Along, J*2*pi/Round)
#end

#declare Along = 180;
#declare Round = 28;
mesh {
    #for (I, 0, Along - 1)
        #for (J, 0, Round - 1)
            smooth_triangle { Corner(I, J), Corner(I + 1, J), Corner(I + 1, J + 1) }
            smooth_triangle { Corner(I, J), Corner(I + 1, J + 1), Corner(I, J + 1) }
        #end
    #end
    pigment { color rgb <.93, .66, .45> }
    finish { ambient .12 diffuse .75 specular .5 roughness .02 reflection .08 }
    rotate <-62, 0, 0> rotate y*-35 translate <0, .35, 0>
}

#macro Dune(X, Z)
    <X, -1.05 + .07*sin(2.2*X + .8*sin(1.1*Z)) + .04*sin(3.1*Z + X), Z>
#end
#declare Step = .35;
mesh {
    #for (I, -20, 19)
        #for (J, -12, 35)
            #local X = I*Step;
            #local Z = J*Step;
            triangle { Dune(X, Z), Dune(X + Step, Z), Dune(X + Step, Z + Step) }
            triangle { Dune(X, Z), Dune(X + Step, Z + Step), Dune(X, Z + Step) }
        #end
    #end
    pigment { color rgb <.85, .74, .52> }
    finish { ambient .15 diffuse .7 }
}
