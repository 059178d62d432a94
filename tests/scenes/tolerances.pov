// POV-Ray's tolerances decide the picture, each within 2 %; the frame is smaller
// than 1e-4. A shadow ray starts 1e-3 after its point (SHADOW_TOLERANCE), so light
// passes under the edge of a leaf. All visible points are just too far from one
// leaf for that, and just near enough to the other leaf. (At the edge itself
// POV-Ray's shadow cache decides.) A checker takes coordinates down to 1e-10 below 0
// for 0.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Creep = 1e-3 * 5 / sqrt(26);
#declare Middle = -1.05 * Creep;
camera {
    location <Middle, .01, -.01>
    right x*4/3
    angle .3
    look_at <Middle, 0, 0>
}
light_source { <100, 20, 0>, rgb <1, .5, 0> }
light_source { <-100, 20, 0>, rgb <0, .5, 1> }

#default { finish { ambient 0 diffuse .8 } }
box { <-1, -.1, -1>, <1, 0, 8e-6> pigment { rgb 1 } }
box { <0, 0, -1>, <1e-7, 1, 1> pigment { rgb 1 } }
box { <-2 * Creep, 0, -1>, <-2 * Creep - 1e-7, 1, 1> pigment { rgb 1 } }

// Only y selects one of the two colours.
#macro Tile(From, To, Top)
    box {
        <From, -.1, 8e-6>, <To, Top, 1>
        pigment { checker rgb <.2, .3, .8> rgb <.9, .8, .3> scale <10, 1, 10>
                  translate <-5, 0, -5> }
        finish { ambient 1 diffuse 0 }
    }
#end
Tile(-1, Middle - 2e-5, -.98e-10)
Tile(Middle - 2e-5, Middle, -1.02e-10)
Tile(Middle, Middle + 2e-5, -.98e-10)
Tile(Middle + 2e-5, 0, -1.02e-10)
