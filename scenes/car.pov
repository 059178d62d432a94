// car.pov - a car body of Steiner patches that join smoothly.
//
// 28 control points shape one half of it, as cell.inc explains.  x runs from the
// nose to the tail, z from the middle to the side.  POV-Ray has no Steiner
// patches and shows meshes instead; it finds the other files with +L.
#version 3.7;
global_settings { assumed_gamma 1.0 }
#ifndef (steiner_patch)
#include "steiner.inc"
#end

background { color rgb <0.5, 0.56, 0.62> }

camera {
    location <-5.6, 2.7, -6.2>
    right x * image_width / image_height
    angle 33
    look_at <-0.1, 0.52, 0>
}

light_source { <-4, 9, -7>, color rgb <1, 0.97, 0.93> }
light_source { <-9, 3, 4>, color rgb <0.28, 0.3, 0.36> shadowless }

#declare Enamel = texture {
    pigment { color rgb <0.55, 0.02, 0.03> }
    finish { ambient 0.12 diffuse 0.6 specular 0.8 roughness 0.012 }
}
#declare Glass = texture {
    pigment { color rgb <0.03, 0.05, 0.07> }
    finish { ambient 0.1 diffuse 0.4 specular 0.9 roughness 0.008 }
}
#declare Rubber = texture {
    pigment { color rgb 0.03 }
    finish { ambient 0.1 diffuse 0.6 phong 0.3 phong_size 12 }
}
#declare Chrome = texture {
    pigment { color rgb <0.55, 0.56, 0.58> }
    finish { ambient 0.12 diffuse 0.5 specular 0.9 roughness 0.015 }
}

// Seven cross sections, each with points at the middle, the shoulder and the sill.
#declare P01 = <-2.50, -0.15, -0.35>;
#declare P02 = <-2.40, -0.15, -0.75>;
#declare P03 = <-2.05, -0.20, -0.85>;

#declare P11 = <-2.20, 0.72, -0.35>;
#declare P12 = <-2.05, 0.76, -1.04>;
#declare P13 = <-2.00, 0.24, -0.98>;

#declare P21 = <-1.00, 0.84, -0.35>;
#declare P22 = <-1.00, 0.88, -1.10>;
#declare P23 = <-1.00, 0.24, -0.98>;

#declare P31 = <-0.10, 1.58, -0.35>;
#declare P32 = <-0.05, 0.90, -1.02>;
#declare P33 = <-0.05, -0.35, -0.98>;

#declare P41 = <1.05, 1.44, -0.35>;
#declare P42 = <1.00, 0.96, -1.06>;
#declare P43 = <1.00, 0.24, -0.98>;

#declare P51 = <2.10, 0.92, -0.35>;
#declare P52 = <2.00, 0.82, -1.06>;
#declare P53 = <2.00, 0.24, -0.98>;

#declare P61 = <2.50, 0.00, -0.35>;
#declare P62 = <2.40, 0.00, -0.80>;
#declare P63 = <2.10, -0.10, -0.85>;

// Mirrors a point to the other half.
#declare Mirror = <1, 1, -1>;

#declare Half = union {
    // along the middle: each window consists of four patches of glass
    #declare Skin0 = Enamel; #declare Skin1 = Enamel;
    #declare Skin2 = Enamel; #declare Skin3 = Enamel;
    #declare A0 = P01 * Mirror; #declare A1 = P01; #declare A2 = P02;
    #declare B0 = P11 * Mirror; #declare B1 = P11; #declare B2 = P12;
    #declare C0 = P21 * Mirror; #declare C1 = P21; #declare C2 = P22;
    #include "cell.inc"
    #declare Skin1 = Glass;
    #declare C0 = P31 * Mirror; #declare C1 = P31; #declare C2 = P32;
    #include "cell.inc"
    #declare Skin1 = Enamel; #declare Skin2 = Glass; #declare Skin3 = Glass;
    #declare C0 = P41 * Mirror; #declare C1 = P41; #declare C2 = P42;
    #include "cell.inc"
    #declare Skin1 = Glass; #declare Skin3 = Enamel;
    #declare C0 = P51 * Mirror; #declare C1 = P51; #declare C2 = P52;
    #include "cell.inc"
    #declare Skin1 = Enamel; #declare Skin2 = Enamel; #declare Skin3 = Glass;
    #declare C0 = P61 * Mirror; #declare C1 = P61; #declare C2 = P62;
    #include "cell.inc"

    // along the side
    #declare Skin3 = Enamel;
    #declare A0 = P01; #declare A1 = P02; #declare A2 = P03;
    #declare B0 = P11; #declare B1 = P12; #declare B2 = P13;
    #declare C0 = P21; #declare C1 = P22; #declare C2 = P23;
    #include "cell.inc"
    #declare C0 = P31; #declare C1 = P32; #declare C2 = P33;
    #include "cell.inc"
    #declare Skin0 = Glass;
    #declare C0 = P41; #declare C1 = P42; #declare C2 = P43;
    #include "cell.inc"
    #declare C0 = P51; #declare C1 = P52; #declare C2 = P53;
    #include "cell.inc"
    #declare Skin0 = Enamel;
    #declare C0 = P61; #declare C1 = P62; #declare C2 = P63;
    #include "cell.inc"
}

#declare Wheel = union {
    torus { 0.24, 0.11 rotate 90 * x texture { Rubber } }
    cone { -0.1 * z, 0.17, 0.05 * z, 0.28 texture { Chrome } }
    cone { -0.16 * z, 0, -0.1 * z, 0.08 texture { Chrome } }
}

// Headlights.
#declare Lamp = sphere {
    0, 0.15 scale <0.7, 0.8, 1> rotate -30 * y translate <-2.1, 0.52, -0.62>
    pigment { color rgb <0.9, 0.88, 0.75> }
    finish { ambient 0.25 diffuse 0.6 specular 0.8 roughness 0.01 }
}

union {
    object { Half }
    object { Half scale Mirror }
    object { Lamp }
    object { Lamp scale Mirror }
    object { Wheel translate <-1.5, 0.35, -0.85> }
    object { Wheel translate <1.5, 0.35, -0.85> }
    object { Wheel translate <-1.5, 0.35, -0.85> scale Mirror }
    object { Wheel translate <1.5, 0.35, -0.85> scale Mirror }
}

plane {
    y, 0
    pigment {
        checker color rgb <0.33, 0.34, 0.35>, color rgb <0.27, 0.28, 0.29>
    }
    finish { ambient 0.15 diffuse 0.7 }
}
