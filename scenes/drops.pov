// A drop of molten copper that fell into its pool: one blob, with a crown of
// inclined jets, beads at their ends, and the column that rises in the middle.
//
//     rt205 render scenes/drops.pov --samples 3 -W 480 -H 360 -o drops.png
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
camera { location <0, 3.6, -7.2> look_at <0, 1.2, 0> angle 40 }
light_source { <-6, 9, -5>, rgb <1, .95, .85> }
light_source { <7, 5, 2>, rgb <.25, .35, .5> shadowless }
sky_sphere { pigment { gradient y color_map {
    [0 rgb <.75, .55, .4>] [.25 rgb <.35, .4, .55>] [1 rgb <.08, .12, .25>] } } }

#declare Jets = 15;
#declare Seed = seed(205);
#declare Copper = texture {
    pigment { color rgb <.85, .42, .2> }
    finish { ambient .12 diffuse .45 specular .9 roughness .012 metallic
        reflection { .38 metallic } }
}

blob {
    threshold .5
    // the rim of the crater, with the jets
    #for (I, 0, Jets - 1)
        #declare A = 2*pi*I/Jets;
        #declare B = 2*pi*(I + 1)/Jets;
        #declare Rise = .75 + .5*rand(Seed);
        #declare Foot = <1.25*cos(A), .1, 1.25*sin(A)>;
        #declare Tip = <(1.45 + .3*Rise)*cos(A), .35 + Rise, (1.45 + .3*Rise)*sin(A)>;
        cylinder { Foot, <1.25*cos(B), .1, 1.25*sin(B)>, .42, .75 }
        cylinder { Foot, Tip, .27, .9 }
        sphere { Tip, .3 + .08*rand(Seed), 1 }
        #if (mod(I, 3) = 1)
            sphere { Tip*<1.18, 1.2, 1.18> + .14*y, .17 + .06*rand(Seed), 1.2 }
        #end
    #end
    // the column, and the drop that separates from it
    sphere { <0, 0, 0>, 1, 1 scale <.95, .6, .95> }
    cylinder { <0, .1, 0>, <0, 1.35, 0>, .34, 1 }
    sphere { <0, 1.5, 0>, .5, 1 }
    sphere { <.03, 2.25, 0>, .36, 1.3 }
    sphere { <.05, 2.8, .02>, .26, 1.4 }
    texture { Copper }
}

// Ripples.
plane { y, 0 texture { Copper } }
#for (I, 0, 2)
    torus { 2.3 + .75*I, .16 - .03*I scale <1, .5, 1> texture { Copper } }
#end
