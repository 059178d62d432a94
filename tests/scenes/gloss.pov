#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <.3,.5,.8> }
camera { location <0, 2.5, -7> look_at <0, .4, 0> angle 50 }
light_source { <-5, 9, -6>, rgb .9 }
light_source { <6, 5, -4>, rgb <.3,.25,.2> }
#default { finish { ambient .1 diffuse .6 } }
sphere { <-2.4,.8,0>, .8 pigment { rgb <.8,.5,.2> } finish { brilliance 3 phong .6 phong_size 20 metallic } }
sphere { <-.8,.8,0>, .8 pigment { rgb <.8,.5,.2> } finish { brilliance .5 specular .6 roughness .03 metallic .5 reflection { .5 metallic } } }
sphere { <.8,.8,0>, .8 pigment { rgb <.2,.3,.4> } finish { emission .2 specular .6 reflection { rgb .05, rgb <.9,.8,.7> falloff 3 } } }
sphere { <2.4,.8,0>, .8 pigment { rgbf <.9,.95,.95,.9> } finish { ambient 0 diffuse .1 specular .6 reflection { 0, 1 fresnel } } interior { ior 1.5 } }
sphere { <1.6,.4,-2.2>, .4 pigment { rgbf <.9,.5,.2,.5> } finish { ambient .2 diffuse .4 phong .8 phong_size 5 metallic reflection { .2 metallic } } interior { ior 1.2 } }
box { -.4, .4 rotate 30*y translate <0,.4,-2> pigment { checker rgb <.8,.2,.1>, rgb .9 scale .25 } finish { reflection { .1, .7 metallic } phong .5 metallic } }
plane { y, 0 pigment { checker rgb .65, rgb .45 } finish { brilliance 2 reflection { 0, .5 } } }
