// piston.pov - a piston of an engine with its rings, its pin and its connecting rod.
//
// Lengths are in centimetres, densities in grams per cubic centimetre.  Each part is a solid, with
// a clearance between moving parts.  `rt205 mass scenes/piston.pov --units cm,g` computes its mass.
// If the reader supports the word `part`, each ring has its own name.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 4 }

background { color rgb <0.13, 0.15, 0.19> }

camera {
    location <-19, -3, -25>
    right x * image_width / image_height
    angle 40
    look_at <0, -6.2, 0>
}

light_source { <-18, 14, -22>, color rgb <0.95, 0.93, 0.88> }
light_source { <16, -10, -18>, color rgb <0.35, 0.38, 0.45> }
light_source { <-4, -20, -2>, color rgb 0.3 shadowless }

#declare Aluminium_Density = 2.68;
#declare Steel_Density = 7.85;
#declare Bronze_Density = 8.8;
#declare Iron_Density = 7.2;

#declare Aluminium = texture {
    pigment { color rgb <0.72, 0.73, 0.75> }
    finish { ambient 0.1 diffuse 0.55 specular 0.5 roughness 0.04 reflection 0.08 }
}
#declare Steel = texture {
    pigment { color rgb <0.42, 0.44, 0.48> }
    finish { ambient 0.1 diffuse 0.5 specular 0.8 roughness 0.02 reflection 0.12 }
}
#declare Bronze = texture {
    pigment { color rgb <0.7, 0.47, 0.2> }
    finish { ambient 0.1 diffuse 0.55 specular 0.6 roughness 0.03 }
}
#declare Iron = texture {
    pigment { color rgb <0.24, 0.24, 0.26> }
    finish { ambient 0.1 diffuse 0.6 specular 0.4 roughness 0.05 }
}

#declare Bore = 4;           // radius of the piston
#declare Crown = 2.6;        // height of its top over the axis of the pin
#declare Skirt = -3.2;       // height of its lower edge
#declare Pin_Radius = 1.05;
#declare Long = 13;          // distance of the axes of pin and crank
#declare Gap = 0.01;

// A ring around y that starts at a height.
#macro Ring(Height, High, Inner, Outer)
    difference {
        cylinder { Height * y, (Height + High) * y, Outer }
        cylinder { (Height - 1) * y, (Height + High + 1) * y, Inner }
    }
#end

// A tube along z at the height y.
#macro Tube(Height, Half, Inner, Outer)
    difference {
        cylinder { <0, Height, -Half>, <0, Height, Half>, Outer }
        cylinder { <0, Height, -Half - 1>, <0, Height, Half + 1>, Inner }
    }
#end

#declare Piston = difference {
    merge {
        difference {
            cylinder { Skirt * y, Crown * y, Bore }
            cylinder { (Skirt - 1) * y, (Crown - 0.75) * y, Bore - 0.45 }
        }
        // The pin bosses, inside the skirt.
        intersection {
            merge {
                cylinder { <0, 0, -Bore>, <0, 0, -1.5>, 1.75 }
                cylinder { <0, 0, 1.5>, <0, 0, Bore>, 1.75 }
                box { <-1.3, 0, -Bore>, <1.3, Crown - 0.5, -1.5> }
                box { <-1.3, 0, 1.5>, <1.3, Crown - 0.5, Bore> }
            }
            cylinder { Skirt * y, (Crown - 0.3) * y, Bore - 0.2 }
        }
    }
    // The grooves, and the bowl in the crown.
    Ring(2.05, 0.22, Bore - 0.38, Bore + 1)
    Ring(1.62, 0.22, Bore - 0.38, Bore + 1)
    Ring(1.12, 0.34, Bore - 0.38, Bore + 1)
    sphere { (Crown + 2.3) * y, 2.7 }
    cylinder { -(Bore + 1) * z, (Bore + 1) * z, Pin_Radius + Gap }
    // Cuts of the skirt below the ends of the pin.
    cylinder { <0, Skirt - 0.6, -Bore - 1>, <0, Skirt - 0.6, Bore + 1>, 1.9 }
    texture { Aluminium }
}

#declare Pin = object {
    Tube(0, Bore - 0.5, 0.6, Pin_Radius)
    texture { Steel }
}

#declare Upper_Ring = object { Ring(2.06, 0.2, Bore - 0.33, Bore + 0.05) texture { Iron } }
#declare Middle_Ring = object { Ring(1.63, 0.2, Bore - 0.33, Bore + 0.05) texture { Iron } }
#declare Oil_Ring = object { Ring(1.13, 0.32, Bore - 0.33, Bore + 0.05) texture { Iron } }

#declare Bush = object {
    Tube(0, 1.25, Pin_Radius + Gap, Pin_Radius + 0.2)
    texture { Bronze }
}

#declare Rod = difference {
    merge {
        cylinder { -1.25 * z, 1.25 * z, 1.65 }
        cylinder { <0, -Long, -1.35>, <0, -Long, 1.35>, 2.9 }
        // The shank with an I-section, and lugs for the bolts.
        difference {
            prism {
                linear_spline linear_sweep -0.95, 0.95, 5
                <-0.95, 0>, <0.95, 0>, <1.45, -Long>, <-1.45, -Long>, <-0.95, 0>
                rotate -90 * x
            }
            prism {
                linear_spline linear_sweep 0.3, 2, 5
                <-0.55, -2>, <0.55, -2>, <0.95, 3.2 - Long>, <-0.95, 3.2 - Long>, <-0.55, -2>
                rotate -90 * x
            }
            prism {
                linear_spline linear_sweep -2, -0.3, 5
                <-0.55, -2>, <0.55, -2>, <0.95, 3.2 - Long>, <-0.95, 3.2 - Long>, <-0.55, -2>
                rotate -90 * x
            }
        }
        box { <-4, -Long - 1, -1>, <4, 1 - Long, 1> }
    }
    cylinder { -2 * z, 2 * z, Pin_Radius + 0.2 }
    cylinder { <0, -Long, -2>, <0, -Long, 2>, 2.2 }
    cylinder { <-3.4, -Long - 2, 0>, <-3.4, 2 - Long, 0>, 0.42 }
    cylinder { <3.4, -Long - 2, 0>, <3.4, 2 - Long, 0>, 0.42 }
    texture { Steel }
}

#declare Bolt = merge {
    cylinder { (-Long - 1.4) * y, (1.3 - Long) * y, 0.4 }
    cylinder { (1.02 - Long) * y, (1.6 - Long) * y, 0.65 }
    cylinder { (-Long - 1.6) * y, (-Long - 1.02) * y, 0.65 }
    texture { Iron }
}

object { Piston }
object { Upper_Ring #ifdef (part) part { "compression ring" } #end }
object { Middle_Ring #ifdef (part) part { "compression ring" } #end }
object { Oil_Ring #ifdef (part) part { "oil ring" } #end }
object { Pin }
object { Bush }
object { Rod }
object { Bolt translate -3.4 * x }
object { Bolt translate 3.4 * x }
