// The end of a game of chess: pieces turned on a lathe, some cut, and a glass.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
background { rgb <.42, .5, .6> }
camera { location <2.9, 4.9, -9.2> right 4/3*x angle 42 look_at <.75, .6, .1> }
light_source { <-7, 11, -6>, rgb .85 }
light_source { <8, 6, -7>, rgb .3 shadowless }
#default { finish { ambient .16 diffuse .65 specular .4 roughness .02 } }

#declare Light = pigment { rgb <.93, .8, .58> }
#declare Dark = pigment { rgb <.33, .14, .08> }

// The foot of all pieces: 9 points of a profile, from the axis outwards.
#macro Foot(R)
    <0, 0>, <R, 0>, <R, .12>, <.94*R, .18>, <.94*R, .22>, <.82*R, .26>, <.78*R, .36>, <.6*R, .46>, <.5*R, .5>
#end

#declare Pawn = lathe {
    linear_spline 27, Foot(.36)
    <.15, .62>, <.12, .8>, <.11, .95>, <.22, .98>, <.22, 1.02>, <.12, 1.05>
    #for (I, 1, 12) , <.2*sin(.25 + I*(pi - .25)/12), 1.21 - .2*cos(.25 + I*(pi - .25)/12)> #end
}

#declare Bishop = difference {
    lathe {
        linear_spline 30, Foot(.4)
        <.18, .64>, <.14, .9>, <.12, 1.15>, <.26, 1.19>, <.26, 1.24>, <.15, 1.28>, <.13, 1.32>
        #for (I, 1, 10) , <.21*sin(.45 + I*.21), 1.5 - .27*cos(.45 + I*.21)> #end
        , <.07, 1.77>, <.09, 1.83>, <.06, 1.89>, <0, 1.91>
    }
    box { <-.4, -.03, -.4>, <.4, .03, .4> rotate 50*z translate <.22, 1.67, 0> }
}

#declare Rook = difference {
    lathe {
        linear_spline 17, Foot(.42)
        <.24, .7>, <.22, 1.05>, <.32, 1.1>, <.32, 1.42>, <.23, 1.42>, <.23, 1.26>, <0, 1.26>, <0, 1>
    }
    #for (I, 0, 2) box { <-.4, 1.31, -.06>, <.4, 1.5, .06> rotate 60*I*y } #end
}

// A fluted head: cylinders cut grooves around it.
#declare Queen = union {
    difference {
        lathe {
            linear_spline 22, Foot(.46)
            <.22, .68>, <.16, 1.05>, <.14, 1.42>, <.3, 1.47>, <.3, 1.53>, <.17, 1.58>, <.15, 1.64>,
            <.2, 1.8>, <.31, 2.08>, <.25, 2.08>, <.2, 2>, <0, 2.03>, <0, 1.6>
        }
        #for (I, 0, 7) cylinder { <.3, 2.12, 0>, <.1, 2.2, 0>, .1 rotate (45*I + 10)*y } #end
    }
    sphere { 2.12*y, .1 }
}

#declare King = union {
    lathe {
        linear_spline 22, Foot(.48)
        <.23, .7>, <.17, 1.1>, <.15, 1.5>, <.33, 1.55>, <.33, 1.62>, <.18, 1.67>, <.16, 1.74>,
        <.2, 1.9>, <.28, 2.16>, <.28, 2.21>, <.12, 2.3>, <.06, 2.36>, <0, 2.36>
    }
    box { <-.045, 2.3, -.04>, <.045, 2.66, .04> }
    box { <-.13, 2.46, -.04>, <.13, 2.54, .04> }
}

#macro Stand(Piece, Color, X, Z, Turn)
    object { Piece pigment { Color } rotate Turn*y translate <X, 0, Z> }
#end
Stand(King, Light, .5, .5, 25) Stand(Queen, Dark, -1.5, 1.5, 0) Stand(Rook, Light, -.5, -.5, 20)
Stand(Bishop, Dark, 1.5, 1.5, -65) Stand(Bishop, Light, -2.5, -.5, 190)
Stand(Pawn, Light, .5, -1.5, 0) Stand(Pawn, Light, 1.5, -.5, 0) Stand(Pawn, Dark, -.5, 1.5, 0)
Stand(Pawn, Dark, 2.5, .5, 0)
// The other king lies on the board.
object { King pigment { Dark } rotate <0, 40, -90> translate .48*y rotate -35*y translate <-1.9, 0, -1.9> }

// The board.
box { <-4, -.25, -4>, <4, 0, 4>
    pigment { checker rgb <.2, .24, .2>, rgb <.85, .83, .74> }
    finish { ambient .12 diffuse .55 specular 0 reflection .1 }
}
box { <-4.35, -.3, -4.35>, <4.35, -.03, 4.35> pigment { Dark } }
plane { y, -.3 pigment { rgb <.24, .3, .33> } finish { specular 0 } }

// A glass whose wall is modelled with its thickness.
lathe {
    linear_spline 16, <0, -.3>, <.62, -.3>, <.6, -.26>, <.1, -.17>, <.07, .1>, <.08, .5>, <.3, .68>, <.52, .98>,
    <.58, 1.4>, <.53, 1.85>, <.5, 1.85>, <.54, 1.4>, <.48, 1>, <.27, .73>, <.06, .58>, <0, .57>
    pigment { rgbf <.95, .98, .97, .92> }
    finish { ambient .02 diffuse .1 specular .8 roughness .003 reflection .1 }
    interior { ior 1.45 }
    scale 1.2 translate <3.1, .37, 1.5>
}
