// splines.pov - splines of every kind, and the operations on them.
#version 3.7;
// Show prints two values on a line.
#declare Column = 0;
#macro Show(A)
    #declare Column = 1 - Column;
    #debug concat(vstr(5, A + <0, 0, 0, 0, 0>, " ", 0, 3), #if (Column) "  " #else "\n" #end)
#end
#macro All(S, From, To, Step)
    #for (T, From, To, Step)
        Show(S(T))
        Show(S(T, linear_spline))
        Show(S(T, quadratic_spline))
        Show(S(T, cubic_spline))
        Show(S(T, natural_spline))
    #end
#end
#declare Points = spline { 0, <1, 2, 3> 1, <3, -1, 7> 2.5 <2, 2, 2>, 4, <1, 0, 5> }
All(Points, -1, 5, .5)
// Splines with few points, with one value for all components, and with unordered or repeated points.
All(spline { natural_spline 1, <2, 3> }, 0, 2, .5)
All(spline { cubic_spline 1, <2, 3, 4, 5>, 2, 7 }, 0, 3, .25)
All(spline { quadratic_spline 3, 1 0, <1, 2, 3, 4, 5> 1, 2, 0, 7 }, -.5, 3.5, .5)
All(spline { 0, 1 1, 2 2, 4 2, 7 1, 3 }, .5, 2.5, .5)
All(spline { 0, <1, 2, 3> 1, <5, 4, 3, 2, 1> 2, <6, 7> 3, 8 }, .5, 3, .5)
// A spline of many points.
#for (I, 1, 300)
    #declare S = spline { I, 1 }
    #declare S = spline { S 0, I }
#end
Show(S(150))
// Random splines.
#declare R = seed(7);
#for (I, 3, 7)
    #declare S = spline {
        natural_spline
        #for (K, 0, I) rand(R)*9, <rand(R), rand(R)*4 - 2, rand(R), rand(R)> #end
    }
    All(S, 0, 9, .6)
#end
// Values of splines in expressions; splines as values.
#declare Copy = Points;
#declare Longer = spline { Points cubic_spline 6, y, .5, 9 - 1 }
#declare Points = spline { 0, 1 1, 3 };
Show(Copy(.5)*2 + Points(.25).y*x)
All(Longer, 1, 5.5, .75)
#declare List = array[2] { Copy, spline { linear_spline natural_spline 0, 1 1, 2 } }
Show(List[1](.5) + List[0](2 + 1, cubic_spline))
#declare List[1] = Longer;
Show(List[1](Points(.5).x))
#macro Ask(S, T) S(T) #end
Show(Ask(Points, .5) + Ask(spline { Copy }, 3))
#macro Make() spline { 0, x 2, z } #end
#declare S = Make()
#if (S(.5).x > S(.5).z) #debug "x\n" #end
#debug concat(str(vlength(S(1) - S(2)), 0, 4), "\n")
#ifdef (S) #debug "there\n" #end
#undef S
#ifndef (S) #debug "gone\n" #end
