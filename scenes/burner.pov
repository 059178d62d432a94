// burner.pov - a bundle of finned copper tubes over a burner, between walls of brick.
//
// A guess at the case that the paper describes: radiation from a burner to tubes with
// fins.  The parts that exchange heat are called Burner, Tube, Fin and Wall.  POV-Ray
// reads the temperatures and emissivities below as well, and ignores them.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 4 }

background { color rgb <0.07, 0.08, 0.1> }

camera {
    location <-5.2, 3.4, -7.4>
    right x * image_width / image_height
    angle 38
    look_at <0.15, 0.75, 0.2>
}

light_source { <-8, 10, -7>, color rgb <0.95, 0.93, 0.9> }
light_source { <6, 4, -9>, color rgb <0.25, 0.28, 0.34> }

// Temperatures in kelvins.  Options of rt205 heat take precedence.
#declare Burner_Temperature = 1150;
#declare Tube_Temperature = 360;
#declare Fin_Temperature = 420;
#declare Burner_Emissivity = 0.9;
#declare Copper_Emissivity = 0.6;
#declare Brick_Emissivity = 0.8;

#declare Copper = texture {
    pigment { color rgb <0.66, 0.3, 0.14> }
    finish { ambient 0.12 diffuse 0.6 specular 0.7 roughness 0.03 }
}
#declare Glowing = texture {
    pigment { color rgb <1, 0.36, 0.08> }
    finish { ambient 0.75 diffuse 0.3 }
}
#declare Brick = texture {
    pigment {
        brick color rgb <0.42, 0.4, 0.38>, color rgb <0.5, 0.26, 0.18>
        brick_size <0.7, 0.24, 0.4> mortar 0.03
    }
    finish { ambient 0.15 diffuse 0.75 }
}

#declare Half = 1.8;       // half length of a tube
#declare Pitch = 1.15;     // distance between two tubes
#declare Height = 1.45;    // height of the axes over the burner
#declare Radius = 0.3;
#declare Reach = 0.5;      // radius of a fin
#declare Sheet = 0.05;
#declare Spacing = 0.36;

#declare Burner = box { <-Half, -0.2, -1.6>, <Half, 0, 1.6> texture { Glowing } }

#declare Tube = difference {
    cylinder { -(Half + 0.25) * x, (Half + 0.25) * x, Radius }
    cylinder { -3 * x, 3 * x, Radius - 0.06 }
    texture { Copper }
}

// The hole of the fin ends inside the wall of the tube.
#declare Fin = difference {
    cylinder { -Sheet / 2 * x, Sheet / 2 * x, Reach }
    cylinder { -x, x, Radius - 0.03 }
    texture { Copper }
}

#declare Wall = box {
    <-Half, -0.2, 0>, <Half, 2.3, 0.3>
    texture { Brick }
}

object { Burner }
object { Wall translate 1.75 * z }

#for (Row, -1, 1)
    object { Tube translate <0, Height, Row * Pitch> }
    #for (I, -4, 4)
        object { Fin translate <I * Spacing, Height, Row * Pitch> }
    #end
#end
