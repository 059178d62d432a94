// An island with two peaks in a reflecting sea: a formula gives its heights.
//     rt205 render scenes/terrain.pov -o terrain.png --samples 3 -W 640 -H 400
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 }
camera {
    location <0, 1, -3.4>
    right x*image_width/image_height
    look_at <0, .22, 0>
    angle 44
}
light_source { <-6, 4.5, -3>, rgb <1, .93, .82> }
light_source { <4, 6, -9>, rgb .25 shadowless }
sky_sphere {
    pigment { gradient y color_map { [0 rgb <.85, .87, .9>] [.5 rgb <.25, .45, .8>] } }
}

// The height of a hill at a and b, and the roughness of the terrain.
#declare Hill = function(x, y, a, b, wide) {
    exp(-((x - a)*(x - a) + (y - b)*(y - b))/(wide*wide))
};
#declare Waves = function(x, y) {
    sin(23*x + 4*sin(9*y))*cos(19*y + 3*sin(11*x))
    + .5*sin(47*x + 31*y + 3*sin(17*x)) + .25*sin(97*y - 61*x)
};
#declare Height = function(x, y) {
    max(.55*Hill(x, y, .4, .45, .2) + .4*Hill(x, y, .68, .62, .14)
        + .12*Hill(x, y, .5, .5, .38), .02)
    *(1 + .16*Waves(x, y))
};

height_field {
    function 100, 100 { min(Height(x, y), 1) }
    smooth water_level .06
    pigment {
        gradient y
        color_map {
            [.06 rgb <.85, .78, .55>]
            [.1 rgb <.35, .5, .2>]
            [.32 rgb <.25, .38, .17>]
            [.45 rgb <.45, .4, .36>]
            [.55 rgb <.95, .96, 1>]
        }
    }
    finish { ambient .12 diffuse .85 }
    translate <-.5, -.06, -.5> scale <2.7, 1.3, 2.7>
}

plane {
    y, 0
    pigment { rgb <.05, .14, .22> }
    finish { reflection .45 specular .5 roughness .02 }
}
