// finned_tube.pov - tubes of a heat exchanger with annular fins, one cut open.
//
// Such fins exchange heat by radiation, and rays can compute the shares.  This
// scene only shows them.  A macro makes a tube, and loops place the fins.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 4 }

background { color rgb <0.13, 0.15, 0.19> }

camera {
    location <-6.6, 5.2, -10.4>
    right x * image_width / image_height
    angle 40
    look_at <0.1, 1.05, 0.1>
}

light_source { <-9, 12, -6>, color rgb <1, 0.96, 0.88> }
light_source { <8, 6, -8>, color rgb <0.3, 0.34, 0.42> }

#declare Copper = texture {
    pigment { color rgb <0.62, 0.25, 0.1> }
    finish { ambient 0.12 diffuse 0.6 specular 0.8 roughness 0.025 }
}
#declare Aluminium = texture {
    pigment { color rgb <0.5, 0.53, 0.57> }
    finish {
        ambient 0.1 diffuse 0.65 specular 0.4 roughness 0.04 reflection 0.06
    }
}
#declare Section = texture {
    pigment { color rgb <0.8, 0.14, 0.05> }
    finish { ambient 0.2 diffuse 0.7 }
}

// The proportions are those of the closed form: radius 1, fin radius 1.8, pitch 0.7.
#declare Radius = 0.5;
#declare Wall = 0.1;
#declare Reach = 0.9;
#declare Spacing = 0.35;
#declare Sheet = 0.06;
#declare Half = 2.4;       // half length of a tube

// A fin is a ring; its hole ends inside the wall of the tube.
#declare Fin = difference {
    cylinder { -Sheet / 2 * x, Sheet / 2 * x, Reach }
    cylinder { -x, x, Radius - Wall / 2 }
    texture { Aluminium }
}

#macro Bore()
    cylinder { -2 * Half * x, 2 * Half * x, Radius - Wall texture { Copper } }
#end

#macro Tube()
    difference {
        cylinder { -Half * x, Half * x, Radius }
        Bore()
        texture { Copper }
    }
    #local Fins = 1 + 2 * floor((Half - 0.2) / Spacing);
    #for (I, 1, Fins)
        object {
            Fin
            translate (I - (Fins + 1) / 2) * Spacing * x
        }
    #end
#end

union { Tube() translate <0, Reach, 1.15> }
union { Tube() translate <0, Reach + 2 * 0.98, 0.1> }

// The front tube is open from its left end to the middle.  Each fin is cut
// separately, so a ray far from it does not test the other fins.
#macro Opening()
    box { <-3, 0, -3>, <0.17, 3, 0> texture { Section } }
#end
difference {
    cylinder { -Half * x, Half * x, Radius texture { Copper } }
    Bore()
    Opening()
    translate <0, Reach, -1.15>
}
#declare I = -6;
#while (I <= 6)
    difference {
        object { Fin translate I * Spacing * x }
        Opening()
        translate <0, Reach, -1.15>
    }
    #declare I = I + 1;
#end

plane {
    y, 0
    pigment {
        checker color rgb <0.2, 0.21, 0.22>, color rgb <0.14, 0.145, 0.15>
        scale 1.5
    }
    finish { ambient 0.15 diffuse 0.7 reflection 0.1 }
}
