// flake.pov - a flake of balls: each carries nine of a third of its size.
// Of depth 1, 2, 3, 4, 5 it has 10, 91, 820, 7,381, 66,430 of them.
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

#declare Gold = color rgb <0.85, 0.6, 0.25>;
#declare Blue = color rgb <0.3, 0.5, 0.75>;

// They lie about a ball as in a close packing: six around it, three above,
// where above is away from the ball that it lies on.
#macro Flake(Center, Radius, Up, Levels)
    #local Share = Levels / max(Depth, 1);
    sphere {
        Center, Radius
        pigment { color Share * Gold + (1 - Share) * Blue }
    }
    #if (Levels > 0)
        #local Side = vnormalize(vcross(Up, <0.3, 0.1, 0.95>));
        #local Across = vcross(Up, Side);
        #for (I, 0, 8)
            #local Angle = radians(I < 6 ? 60 * I : 120 * I + 30);
            #local Height = (I < 6 ? 0 : sqrt(2 / 3));
            #local Out = Height * Up + sqrt(1 - Height * Height)
                       * (cos(Angle) * Side + sin(Angle) * Across);
            Flake(Center + 4 / 3 * Radius * Out, Radius / 3, Out, Levels - 1)
        #end
    #end
#end

union {
    Flake(0, 1, y, Depth)
    finish { ambient 0.1 diffuse 0.7 specular 0.3 roughness 0.03 }
}
