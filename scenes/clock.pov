// A clock: gears and hands are prisms, the face consists of discs, the numerals are
// letters, and clipped_by cuts the case open.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 5 }
background { rgb <.3, .35, .42> }
camera { location <1.6, 1.1, -9> right 4/3*x angle 41 look_at 0 }
light_source { <-6, 8, -9>, rgb .75 }
light_source { <7, 3, -6>, rgb .3 shadowless }
#default { finish { ambient .15 diffuse .65 } }

#declare brass = finish { ambient .12 diffuse .5 specular .5 roughness .03 metallic reflection .12 }
// A gear around z with Teeth teeth and spokes.
#macro Gear(Teeth, Radius, Thick)
    prism {
        linear_sweep 0, Thick, 4*Teeth + 1 + 9
        #for (I, 0, Teeth)
            #local A = 2*pi*I/Teeth;
            #local B = 2*pi/Teeth;
            <sin(A), cos(A)>*Radius
            #if (I < Teeth)
                <sin(A + .2*B), cos(A + .2*B)>*(Radius + .14)
                <sin(A + .5*B), cos(A + .5*B)>*(Radius + .14)
                <sin(A + .7*B), cos(A + .7*B)>*Radius
            #end
        #end
        #for (I, 0, 8) <sin(I*pi/4), cos(I*pi/4)>*.45*Radius #end
        pigment { rgb <.85, .65, .25> }
        finish { brass }
        rotate -90*x
    }
#end
object { Gear(24, 1.1, .18) rotate 4*z translate <-.55, .5, .35> }
object { Gear(16, .7, .18) rotate 9*z translate <1.27, -.2, .36> }
object { Gear(12, .5, .18) pigment { rgb <.75, .72, .7> } rotate 2*z translate <.3, -1.05, .55> }

// The face: rings, and marks for the minutes.
#for (I, 0, 2)
    disc { -.2*z, -z, 2.3 - .05*I, 1.75 + .05*I translate -.01*I*z pigment { rgb <.9, .88, .8>*(1 - .3*mod(I, 2)) } }
#end
#for (I, 0, 59)
    box { <-.012, 2.05, -.25>, <.012, 2.17 + (mod(I, 5) = 0 ? .06 : 0), -.235> rotate 6*I*z pigment { rgb .1 } }
#end
#macro Numeral(Text, Hour, Wide)
    text {
        ttf "timrom.ttf" Text .03, 0
        pigment { rgb .08 }
        scale .33
        translate <-Wide, -.12, -.26>
        translate <1.87*sin(pi*Hour/6), 1.87*cos(pi*Hour/6), 0>
    }
#end
Numeral("12", 12, .16) Numeral("3", 3, .08) Numeral("6", 6, .08) Numeral("9", 9, .08)

// Hands.
#macro Hand(Length, Wide)
    prism {
        linear_sweep 0, .04, 7
        <-Wide, -.3>, <Wide, -.3>, <.6*Wide, .7*Length>, <1.6*Wide, .75*Length>, <0, Length>, <-1.6*Wide, .75*Length>, <-Wide, -.3>
        pigment { rgb <.1, .12, .2> }
        finish { phong .5 }
        rotate -90*x
    }
#end
object { Hand(1.15, .08) rotate -55*z translate -.36*z }
object { Hand(1.65, .055) rotate -230*z translate -.45*z }
cylinder { -.55*z, .6*z, .09 pigment { rgb <.85, .65, .25> } finish { brass } }
// Half of the case.
difference {
    cylinder { -.3*z, .9*z, 2.55 }
    cylinder { -.4*z, .8*z, 2.35 }
    pigment { rgb <.4, .15, .1> }
    finish { phong .4 reflection .06 }
    clipped_by { plane { x, .4 rotate 35*z } }
}
plane { z, 3 pigment { checker rgb <.6, .62, .55> rgb <.5, .54, .5> scale 1.3 translate .3 } }
