// tube_row.pov - a plane burner under a row of finned copper tubes.
//
// A guess at the case that the paper describes; its geometry is not known.  Tubes and fins
// are cylinders, because the scene only serves to test whether rays hit them.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 3 }

background { color rgb <0.08, 0.09, 0.11> }

camera {
    location <-4.6, 3.1, -6.4>
    right x * image_width / image_height
    angle 40
    look_at <0, 0.55, 0>
}

light_source { <-6, 9, -8>, color rgb <0.95, 0.93, 0.9> }
light_source { <5, 3, -8>, color rgb <0.25, 0.28, 0.34> }

#declare Copper = texture {
    pigment { color rgb <0.66, 0.3, 0.14> }
    finish { ambient 0.12 diffuse 0.6 specular 0.7 roughness 0.03 }
}

#declare Half = 2;
#declare Burner = mesh {
    triangle { <-Half, 0, -1.5>, <-Half, 0, 1.5>, <Half, 0, 1.5> }
    triangle { <-Half, 0, -1.5>, <Half, 0, 1.5>, <Half, 0, -1.5> }
    texture {
        pigment { color rgb <1, 0.36, 0.08> }
        finish { ambient 0.75 diffuse 0.3 }
    }
}

#declare Spacing = 0.25;
#declare Tube = union {
    cylinder { -Half * x, Half * x, 0.2 }
    #for (I, -7, 7)
        cylinder { (I * Spacing - 0.02) * x, (I * Spacing + 0.02) * x, 0.36 }
    #end
    texture { Copper }
}

object { Burner }
#for (Row, -1, 1)
    object { Tube translate <0, 0.8, Row> }
#end
