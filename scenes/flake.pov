// flake.pov - a flake of balls: each ball carries nine of a third of its size.
// With depth 1, 2, 3, 4, 5 it has 10, 91, 820, 7,381, 66,430 balls.
#version 3.7;
global_settings { assumed_gamma 1.0 }

#declare Depth = 2;

background { color rgb <0.05, 0.07, 0.12> }

camera {
    location <3.1, 4.2, -5.4>
    right x * image_width / image_height
    angle 33
    look_at <0, 0.16, 0>
}

light_source { <-6, 10, -7>, color rgb <1, 0.97, 0.9> }
light_source { <9, 5, -4>, color rgb <0.35, 0.4, 0.5> }

#default { finish { ambient 0.1 diffuse 0.7 specular 0.3 roughness 0.03 } }
#declare Paint = array[Depth + 1];
#for (I, 0, Depth)
    #declare Paint[I] = I / max(Depth, 1) * <0.85, 0.6, 0.25>
                      + (1 - I / max(Depth, 1)) * <0.3, 0.5, 0.75>;
#end

// The nine balls lie around a ball as in a close packing: six in its equator
// and three above it.  "Above" is the direction away from the parent ball.
#declare Around = array[9];
#for (I, 0, 5)
    #declare Around[I] = vrotate(x, 60 * I * y);
#end
#for (I, 6, 8)
    #declare Around[I] = vrotate(<sqrt(1 / 3), sqrt(2 / 3), 0>,
                                 (120 * I + 30) * y);
#end

#macro Children(Center, Radius, Up, Levels)
    #local Side = vnormalize(vcross(Up, <0.3, 0.1, 0.95>));
    #local Across = vcross(Up, Side);
    #for (I, 0, 8)
        #local Out = Around[I].x * Side + Around[I].y * Up
                   + Around[I].z * Across;
        Flake(Center + 4 / 3 * Radius * Out, Radius / 3, Out, Levels)
    #end
#end

#macro Flake(Center, Radius, Up, Levels)
    sphere { Center, Radius pigment { color rgb Paint[Levels] } }
    #if (Levels > 0)
        Children(Center, Radius, Up, Levels - 1)
    #end
#end

Flake(<0, 0, 0>, 1, y, Depth)
