// bench.pov - the scene for the comparison of times with POV-Ray: a sphere, a box
// and cylinders under difference and intersection, a torus, a checkered plane,
// one light with shadows and one mirror sphere.
#version 3.7;
global_settings { assumed_gamma 1.0 }

background { color rgb <0.35, 0.45, 0.6> }

camera {
    location <-0.6, 4.3, -8.2>
    right x * image_width / image_height
    angle 44
    look_at <0.1, 0.75, 0>
}

light_source { <-6, 9, -7>, color rgb 1 }

#declare Lacquer = finish {
    ambient 0.16 diffuse 0.7 specular 0.5 roughness 0.02
}

// A box and a sphere with the same centre, with three bores.
difference {
    intersection {
        box { -1, 1 }
        sphere { 0, 1.36 }
    }
    cylinder { -2 * x, 2 * x, 0.62 pigment { color rgb <0.8, 0.6, 0.1> } }
    cylinder { -2 * y, 2 * y, 0.62 pigment { color rgb <0.8, 0.6, 0.1> } }
    cylinder { -2 * z, 2 * z, 0.62 pigment { color rgb <0.8, 0.6, 0.1> } }
    pigment { color rgb <0.65, 0.07, 0.05> }
    finish { Lacquer }
    rotate 32 * y
    translate <-1.55, 1, 0.2>
}

torus {
    0.85, 0.26
    pigment { color rgb <0.1, 0.35, 0.5> }
    finish { Lacquer }
    translate <0.65, 0.26, -1.7>
}

// the mirror sphere
sphere {
    <1.75, 1.25, 0.6>, 1.25
    pigment { color rgb 0.04 }
    finish { ambient 0.1 diffuse 0.4 specular 0.8 roughness 0.01
             reflection 0.8 }
}

plane {
    y, 0
    pigment {
        checker color rgb <0.62, 0.62, 0.58>, color rgb <0.2, 0.22, 0.26>
    }
    finish { ambient 0.16 diffuse 0.7 }
}
