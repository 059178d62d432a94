// language.pov - a picture made by loops, conditionals, macros, arrays and random
// numbers, the same in both programs.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 5, -11> look_at <0, 1, 0> angle 42
    right x*image_width/image_height }
light_source { <5, 9, -7>, rgb .9 shadowless }
background { rgb <.2, .25, .35> }

#declare Paints = array[3] { rgb <.8, .2, .1>, rgb <.2, .7, .3>, rgb <.9, .8, .2> }
#declare Stream = seed(7);

#macro Paint(I)
    pigment { Paints[mod(I, dimension_size(Paints, 1))] }
    finish { phong .4 }
#end

// The object at an angle; its kind changes cyclically with the number.
#macro Place(I, Angle)
    #local Height = .5 + rand(Stream);
    #local Solid =
    #switch (mod(I, 3))
        #case (0) cylinder { 0, Height*y, .3 } #break
        #case (1) box { <-.3, 0, -.3>, <.3, Height, .3> } #break
        #else sphere { Height/2*y, Height/2 }
    #end
    object { Solid translate 3.5*x rotate Angle*y Paint(I) }
#end

#macro Tower(Size, Left)
    union {
        box { -Size, Size translate Size*y Paint(Left) }
        #if (Left > 1)
            object { Tower(Size*.7, Left - 1) rotate 20*y translate 2*Size*y }
        #else
            sphere { 2.3*Size*y, .3*Size Paint(Left) }
        #end
    }
#end

object { Tower(.8, 4) }
#for (I, 0, 11) Place(I, 30*I) #end
#declare Row = 0;
#while (Row < 6)
    sphere { <Row - 2.5, .2, -4.5>, .2 pigment { rgb (Row = 3 ? x : <1, 1, 1>*Row/6) } }
    #declare Row = Row + 1;
#end
plane { y, 0 pigment { checker rgb .4, rgb .6 } }
