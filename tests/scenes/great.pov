// Solids with many parts, some of them in front of others: a hit on one limits the
// rays to the next one, and few rays come near any part.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <.3, .4, .6> }
camera { location <-2.1, 6.3, -9.4> look_at <.1, -.2, .3> angle 48 }
light_source { <-7.3, 11.1, -6.7>, rgb .8 }
light_source { <6.1, 9.3, -8.9>, rgb .3 }
#declare Stream = seed(7);
box { <-6, 4.7, -6>, <4, 5.9, -5.9> pigment { rgb .9 } }
difference {
    merge {
        box { <-4, -1, -4>, <4, -.6, 4> }
        #for (I, 0, 23)
            sphere { <mod(I, 6) * 1.4 - 3.5, -.6, int(I / 6) * 1.9 - 2.9>, .3 }
        #end
    }
    #for (I, 0, 29)
        cylinder {
            <mod(I, 6) * 1.4 - 3.1, -2, int(I / 6) * 1.6 - 3.3>,
            <mod(I, 6) * 1.4 - 3.1, 0, int(I / 6) * 1.6 - 3.3>, .25
        }
    #end
    pigment { rgb <.8, .6, .3> }
}
merge {
    #for (I, 1, 40)
        sphere {
            <rand(Stream) * 6 - 3, rand(Stream) * 2, rand(Stream) * 6 - 3>,
            .15 + .2 * rand(Stream)
        }
    #end
    pigment { rgb <.3, .7, .5> }
}
merge {
    #for (I, 1, 30)
        box { -.12, .12 rotate 40 * I * x
            translate <rand(Stream) * 6 - 3, .5 + rand(Stream) * 2, rand(Stream) * 4 - 4> }
    #end
    pigment { rgb <.8, .3, .3> }
}
