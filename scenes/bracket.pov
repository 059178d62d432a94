// bracket.pov - a bearing bracket: a casting, drilled, bored and faced.
//
// The solids are made as in a workshop: what a tool removes is subtracted and
// leaves a bright surface.  Cones chamfer the edges, and tori fill the inner
// corners.  The scene is made for square pictures of a million pixels.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 4 }

background { color rgb <0.16, 0.2, 0.26> }

camera {
    location <-5.6, 6.3, -11.4>
    right x * image_width / image_height
    angle 37
    look_at <-0.15, 1.5, -0.5>
}

light_source { <-7, 13, -9>, color rgb <0.95, 0.91, 0.84> }
light_source { <10, 8, -7>, color rgb <0.3, 0.36, 0.46> }

#declare Cast = texture {
    pigment { color rgb <0.045, 0.16, 0.2> }
    finish { ambient 0.14 diffuse 0.75 phong 0.3 phong_size 14 }
}
#declare Cut = texture {
    pigment { color rgb <0.47, 0.49, 0.52> }
    finish { ambient 0.12 diffuse 0.6 specular 0.7 roughness 0.03 }
}
#declare Bronze = texture {
    pigment { color rgb <0.72, 0.42, 0.12> }
    finish { ambient 0.12 diffuse 0.6 specular 0.8 roughness 0.02 }
}
#declare Blackened = texture {
    pigment { color rgb <0.07, 0.07, 0.08> }
    finish {
        ambient 0.12 diffuse 0.6 specular 0.9 roughness 0.03
        reflection 0.12
    }
}

// Densities for rt205 mass, in grams per cubic centimetre.
#declare Cast_Density = 7.2;
#declare Bronze_Density = 8.8;
#declare Blackened_Density = 7.85;

// The lower face of the plate is y = 0; the bore is parallel to z.
#declare Wide = 3.2;       // half width of the plate
#declare Deep = 1.75;
#declare Thick = 0.45;
#declare Corner = 0.65;
#declare Screw_X = Wide - Corner;
#declare Screw_Z = Deep - Corner;
#declare Axis = 2.85;      // height of the bore's axis
#declare Shell = 1.4;      // outer radius of the housing
#declare Face = 1.3;       // half length of the housing, along z
#declare Bore = 0.92;
#declare Hole = 0.2;       // radius of a screw hole
#declare Head = 0.34;      // radius of a screw head
#declare Skim = 0.03;      // depth of the cut off the front

// --- The plate: cylinders round its corners ----------------------------------

#macro At_Corners(Thing)
    object { Thing translate <-Screw_X, 0, -Screw_Z> }
    object { Thing translate <Screw_X, 0, -Screw_Z> }
    object { Thing translate <-Screw_X, 0, Screw_Z> }
    object { Thing translate <Screw_X, 0, Screw_Z> }
#end

#declare Round = cylinder { 0, Thick * y, Corner }
#declare Way = cylinder { -y, y, Head + 0.1 }    // space inside a boss
#declare Plate = difference {
    union {
        box { <-Screw_X, 0, -Deep>, <Screw_X, Thick, Deep> }
        box { <-Wide, 0, -Screw_Z>, <Wide, Thick, Screw_Z> }
        At_Corners(Round)
    }
    At_Corners(Way)
    texture { Cast }
}

// A boss for a screw: a cylinder with a fillet at its foot, which is a disk
// minus a torus.  Its top is drilled, counterbored and chamfered.
#declare Boss = 0.52;
#declare Fillet = 0.13;
#declare Screw_Boss = difference {
    union {
        cylinder { 0, 0.62 * y, Boss }
        difference {
            cylinder { 0, (Thick + Fillet) * y, Boss + Fillet }
            torus { Boss + Fillet, Fillet translate (Thick + Fillet) * y }
        }
    }
    cylinder { -y, y, Hole texture { Cut } }
    cylinder { 0.36 * y, y, Head + 0.06 texture { Cut } }
    cone { 0.56 * y, Head, 0.66 * y, Head + 0.16 texture { Cut } }
    texture { Cast }
}

// --- The web: walls with a hollow transition to the plate --------------------

#declare Run = 1.1;        // radius of the hollow between wall and plate
#declare Waist = 1.3;
#declare Web = difference {
    union {
        box { <-Waist, 0.1, -0.5>, <Waist, Axis, 0.5> }
        difference {
            box { <-Waist - Run, 0.1, -0.5>, <Waist + Run, Thick + Run, 0.5> }
            cylinder { -z, z, Run translate <-Waist - Run, Thick + Run, 0> }
            cylinder { -z, z, Run translate <Waist + Run, Thick + Run, 0> }
        }
    }
    cylinder { -z, z, Bore + 0.2 translate Axis * y }
    texture { Cast }
}

#declare Rib = difference {
    box { <-0.2, 0.1, -0.5 - Run>, <0.2, Thick + Run, 0.5 + Run> }
    cylinder { -x, x, Run translate <0, Thick + Run, -0.5 - Run> }
    cylinder { -x, x, Run translate <0, Thick + Run, 0.5 + Run> }
    texture { Cast }
}

// --- The housing: faced, chamfered by cones, bored, with screw holes ---------

#declare Edge = Shell - 0.12;    // end radius, with a chamfer of 45 degrees
#declare Housing = difference {
    intersection {
        cylinder { -Face * z, Face * z, Shell }
        cone { -Face * z, Edge, Face * z, Edge + 2 * Face }
        cone { -Face * z, Edge + 2 * Face, Face * z, Edge }
    }
    // the facing cut at the front
    plane { z, -Face + Skim texture { Cut } }
    cylinder { -2 * z, 2 * z, Bore texture { Cut } }
    cylinder { -2 * z, (0.12 - Face) * z, Bore + 0.14 texture { Cut } }
    #for (I, 0, 5)
        cylinder {
            <0, Bore + 0.29, -2>, <0, Bore + 0.29, 0.4 - Face>, 0.075
            rotate (I * 60 + 30) * z
            texture { Blackened }
        }
    #end
    cylinder { 0, 2 * y, 0.12 texture { Cut } }
    translate Axis * y
    texture { Cast }
}

// The oil inlet: a boss rounded by a torus, with a conical opening.
#declare Oil_Boss = difference {
    union {
        cylinder { (Bore + 0.2) * y, (Shell + 0.2) * y, 0.4 }
        cylinder { (Shell + 0.2) * y, (Shell + 0.3) * y, 0.3 }
        torus { 0.3, 0.1 translate (Shell + 0.2) * y }
    }
    cylinder { 0, 2 * y, 0.12 texture { Cut } }
    cone { (Shell + 0.16) * y, 0.1, (Shell + 0.32) * y, 0.26 texture { Cut } }
    translate Axis * y
    texture { Cast }
}

// A bush with a collar; a torus cuts the oil groove.
#declare Bush = difference {
    union {
        cylinder { -Face * z, (Face + 0.08) * z, Bore - 0.01 }
        cylinder { (-Face - 0.08) * z, (0.11 - Face) * z, Bore + 0.13 }
    }
    cylinder { -2 * z, 2 * z, 0.72 }
    cone { (-Face - 0.1) * z, 0.84, (-Face + 0.02) * z, 0.72 }
    torus { 0.72, 0.07 rotate 90 * x translate -0.55 * z }
    translate Axis * y
    texture { Bronze }
}

// --- Screws: the hexagon is the intersection of three slabs ------------------

#declare Flats = 0.17;
#declare Slab = box { <-Flats, 0.2, -1>, <Flats, 1, 1> }
#declare Screw = union {
    difference {
        intersection {
            cylinder { 0, 0.4 * y, Head }
            cone { -y, Head - 0.06 + 1.4, 0.4 * y, Head - 0.06 }
        }
        intersection {
            object { Slab }
            object { Slab rotate 60 * y }
            object { Slab rotate 120 * y }
        }
    }
    cylinder { -1.1 * y, 0, 0.17 }
    texture { Blackened }
}

// --- The complete bracket ---------------------------------------------------

object { Plate }
At_Corners(Screw_Boss)
object { Web }
object { Rib }
object { Housing }
object { Oil_Boss }
object { Bush }
object { Screw rotate 10 * y translate <Screw_X, 0.36, -Screw_Z> }
object { Screw rotate 25 * y translate <-Screw_X, 0.36, Screw_Z> }
object { Screw rotate 40 * y translate <Screw_X, 0.36, Screw_Z> }
// one screw lies next to the bracket
object {
    Screw
    rotate <-81.5, 0, 0>
    rotate 118 * y
    translate <-1.7, Head - 0.03, -2.75>
}

plane {
    y, 0
    pigment {
        checker color rgb <0.12, 0.115, 0.11>, color rgb <0.075, 0.075, 0.08>
        scale 2
        rotate 25 * y
    }
    finish { ambient 0.15 diffuse 0.7 reflection 0.25 }
}
