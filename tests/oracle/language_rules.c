/* language_rules.c - the rules of the random scene language. */
#include "tests/oracle/language_parts.h"

#define PLACE_OFF "translate <^4.1:.2^, ^4.1:.2^, ^4.1:.2^>\n"
#define SHARE(word, most) word " $3[rgb @.02:" most "@|~.02:" most "~$]\n"
#define SHIFT "translate <^4-.4:.4^, ^4-.4:.4^, ^4-.4:.4^>\n"
/* Hides an object from some kinds of rays. */
#define HIDDEN(in) \
    "$" in "[no_shadow\n|$]$" in "[$6[no_image off|no_image$]\n|$]$" in \
    "[no_reflection\n|$]"
#define AFTER_TURNED "location <.021, .033, -8>\ndirection <.02, .01, ^31.2:2^>\n"
/* The patterns with a map. Rules name all other patterns, which have arguments. */
#define CHOICE_map(name) #name "|"
#define CHOICE_gradient(name)
#define CHOICE_list(name)
#define CHOICE_checker(name)
#define CHOICE_unsupported(name)

const struct language_rule language_rules[] = {
    /* --- values --- */
    { "name_or_number", NULL, "$?N[$=N;|^30:3^$]" },
    { "float_leaf", NULL,
      "$12[$?turning[I|$name_or_number;$]|$name_or_number;|$name_or_number;"
      "|$name_or_number;"
      "|$?List[$=List;$4[[dimension_size(List0, 1) - 1]|[^#0:4^]$]|^30:3^$]"
      "|$?V[$=V;$[.x|.y|.z$]|^30:3^$]"
      "|$?Color[$=Color;$[.red|.green|.blue|.gray|.transmit$]|^30:3^$]"
      "|$[pi|true|no|on|clock|version|image_width/20|1.5e-1|2.5E+0|.5$]"
      "|$?streams[rand(Stream)|^30:3^$]|^30:3^$]" },
    { "arrow", NULL, "~.5:2~$2[*| * $]vnormalize(<.013, .027, .041> + $v2;)" },
    { "color", NULL,
      "$?Color3[$[|color $]$?library2[$[Red|SteelBlue|Gold|Gray60|Orange$]|$=Color;$]"
      "$4[*(~.3:1~)|*<.6, .8, .9>|$]"
      "|$?Palette5[$=Palette;$?turning2[[mod(I, 4)]|[^#0:4^]$]|$made_color;$]$]" },
    { "made_color", NULL,
      "$6[$[rgb |color rgb |srgb $]~.2:1~|red ~0:1~ green ~0:1~ blue ~0:1~"
      "|$[rgb |rgb |color rgb |srgb |color srgb $]@.05:1@$]" },
    /* --- declarations --- */
    { "declare", NULL, "$[#declare |#local $]" },
    { "float", NULL, "$declare;$+N; = $f3;;\n$!N;" },
    { "vector", NULL, "#declare $+V; = <.1, .2, .3> + $v2;;\n$!V;" },
    { "named_color", NULL, "#declare $+Color; = $color;;\n$!Color;" },
    { "array", declare_array, NULL },
    { "palette", declare_palette, NULL },
    { "function", NULL,
      "#declare $+Wave; = function$[(a, b) { sin(a)*b + a/(2 + b*b) }"
      "|(a, b) { a - b - 1 + (a > b & a != 0) }"
      "|(a, b) { select(a - b, 1, 2, pow(abs(a), 1.5)) }"
      "|(a, b) { min(a, b, 2)*max(a, .3) - -b }"
      "|(a, b) { mod(abs(a) + 3, 1.7) + sqrt(abs(b)) }"
      "|(x, y) { x*x*x - y*y/3 + atan2(y, 1 + x*x) }$]\n$!Wave;" },
    { "value", NULL,
      "#macro $+Bent;$[(A, B) (A*.3 + sin(B)) #end|(A, B) max(A, 2*B, .5) #end"
      "|(A, B) #local C = A - B; (C*C > 1 ? C : B) #end$]\n$!Bent;" },
    { "declaration", NULL,
      "$8[$vector;|$named_color;|$array;|$palette;|$function;|$value;|$float;$]" },
    { "look_declaration", NULL, "$4[$motion;|$solid;|$declared_look;$]" },
    { "motion", NULL, "#declare $+Motion; = transform {\n$turn;$turn;}\n$!Motion;" },
    { "solid", declare_solid, NULL },
    { "declared_look", NULL,
      "$[$declare;$+Paint; = pigment {\n$2[$mapped;|$checker;$]}\n$!Paint;"
      "|$declare;$+Shine; = finish {\n$5[$mirror_words;|$shine_words;$]}\n$!Shine;"
      "|$declare;$+Look; = texture {\n$texture_words;}\n$!Look;$]" },
    /* --- motions --- */
    { "turn", NULL,
      "$5[rotate @-90:90@|rotate ~-90:90~$[*x|*y|*z$]|scale @.6:1.2@|scale ~.7:1.1~"
      "|matrix <1, ^3-.3:.3^, 0, ^3-.3:.3^, .9, 0, 0, ^3-.3:.3^, 1, 0, ^3-.2:.2^, 0>$]\n" },
    /* Rotations and scales about the origin. */
    { "turns", NULL,
      "$*0:3[$?Motion5[transform { $=Motion;$[| inverse$] }\n|$turn;$]$]" },
    /* --- pigments --- */
    /* The steps of a pattern must not be in the planes of the objects, where rounding
     * would decide the colour. */
    { "pattern_place", NULL, "scale ^4.3:.9^\n$2[$turn;|$]" PLACE_OFF },
    { "checker", NULL, "checker$8[| $color;$[, | $]$color;$]\n$pattern_place;" },
    { "map", write_map, NULL },
    { "gradient", NULL, "gradient $arrow;$6[\n|$map;$]$pattern_place;" },
    /* More than two repetitions would make the edges as narrow as a pixel. */
    { "waves", NULL,
      "$2[$[ramp_wave|triangle_wave|sine_wave|scallop_wave|cubic_wave|poly_wave$]\n|$]"
      "$6[poly_wave ^3.3:4^\n|$]$3[frequency ~-2:2~\n|$]$3[phase ~-1:2~\n|$]" },
    { "pattern", NULL,
      "$5[hexagon $4[|$color;$[, | $]$color;$[, | $]$color;$]\n"
      "|brick $4[|$color;$[, | $]$color;$]\n"
      "brick_size <^3.5:1.5^, ^3.3:1^, ^3.4:1.2^>\n$.mortar ^3.05:.2^\n"
      "|$["
#define PATTERN(KIND, name, pigment, ...) CHOICE_##pigment(name)
#include "rt/scene/patterns.def"
      "gradient x|gradient <1, 1, .5>$]$6[\n|$map;$]$waves;$]$pattern_place;" },
    { "mapped", NULL, "$2[$gradient;|$pattern;$]" },
    { "plain_color", write_plain_color, NULL },
    { "clear_color", NULL,
      "$4[rgbf <^2.4:1^, ^2.4:1^, ^2.4:1^, ~.5:.9~>|color rgbt ~.3:.9~"
      "|rgbft <^2.4:1^, ^2.4:1^, ^2.4:1^, .5, ~.1:.4~>"
      "|$color;$[ transmit .6| filter .7| filter .4 transmit .3$]$]\n" },
    { "pigment", NULL,
      "pigment {\n$8[$?Paint[$=Paint;\n$turns;|$checker;$]|$checker;|$checker;|$mapped;"
      "|$mapped;|$plain_color;$]}\n" },
    /* A pigment for unbounded objects. It is not a gradient, because POV-Ray reduces
     * its values modulo 1.00001 below -1, which matters at large distances. */
    { "far_pigment", NULL, "pigment {\n$2[$checker;|$plain_color;$]}\n" },
    /* ---- Finishes ---- */
    { "reflection", NULL,
      "$3[reflection { ^3.1:.5^ }\n|" SHARE("reflection", ".5") "$]" },
    /* Metals are not used where light is transmitted. If the colours of a checker
     * transmit different fractions, POV-Ray computes a metal differently. */
    { "metallic", NULL, "$?metals3[$3[metallic\n|metallic ~.2:1~\n$]|$]" },
    /* A mirror whose reflection depends on the angle. */
    { "turned_mirror", NULL,
      "reflection {\nrgb <^30:.4^, ^30:.4^, ^30:.4^>, ^3.2:.9^\n"
      "$2[fresnel\n|$2[falloff ~.5:4~\n|$]$]$metallic;}\n" },
    { "finish_words", NULL,
      "$2[" SHARE(
          "ambient",
          ".4") "|$]$2[diffuse ~.4:.9~\n|$]$4[brilliance ~.4:4~\n|$]"
                "$5[" SHARE(
                    "emission",
                    ".3") "|$]"
                          "$3[phong ~.2:.9~\n$2[phong_size ~8:60~\n|$]|$]"
                          "$3[specular ~.2:.9~\n$2[roughness ~.02:.2~\n|$]|$]$metallic;" },
    { "shine_words", NULL, "$?Shine4[$=Shine;\n|$]$finish_words;" },
    { "mirror_words", NULL, "$shine_words;$2[$turned_mirror;|$reflection;$]" },
    { "finish", NULL, "finish {\n$5[$mirror_words;|$shine_words;$]}\n" },
    { "ground_finish", NULL, "finish {\n$3[$mirror_words;|$shine_words;$]}\n" },
    /* --- normals --- */
    /* These patterns use no functions and no numbers of other streams, so that the
     * other random choices do not depend on normals. */
    { "bump", NULL,
      "$[gradient x|gradient <1, -1, .5>|radial frequency 3|"
#define PATTERN(KIND, name, pigment, ...) CHOICE_##pigment(name)
#include "rt/scene/patterns.def"
      "quilted$]"
      "$[| sine_wave| triangle_wave| scallop_wave| cubic_wave$] bump_size $steepness;"
      "$4[ phase ^30:1^|$] scale ^4.2:.6^" },
    { "steepness", write_steepness, NULL },
    { "bump_entry", NULL, " normal { $bump; }" },
    { "bump_list", NULL,
      "$[checker$2[, $steepness;|$bump_entry;$bump_entry;$]"
      "|hexagon$2[, $steepness;|$bump_entry;$bump_entry;$bump_entry;$]"
      "|brick$2[, $steepness;|$bump_entry;$bump_entry;$]"
      " brick_size <.713, .427, .531> mortar .061$]\n" },
    { "bump_map", write_bump_map, NULL },
    { "slopes", write_slopes, NULL },
    { "own_normal", NULL,
      "normal {\n$6[$bump_list;|$bump_map;|$slopes;|$bump;\n$]scale <1, ^4.6:1.2^, 1>\n"
      "$.rotate <^2-60:60^, ^2-60:60^, 0>\n$." PLACE_OFF
      "$?copied[|$6[no_bump_scale\n|$]$]}\n" },
    { "copied", begin_copy, NULL },
    { "normal", write_normal, NULL },
    { "steep_normal", write_steep_normal, NULL },
    /* --- textures --- */
    { "texture_words", NULL,
      "$?Look3[$=Look;\n$copied;$3[$pigment;|$]$3[$finish;|$]|$pigment;$finish;$]"
      "$normal;$turns;" },
    { "look", NULL,
      "$4[$pigment;$steep_normal;|$pigment;$finish;$normal;"
      "|texture {\n$texture_words;}\n$]" },
    { "clear_look", write_clear_look, NULL },
    /* ---- Shapes ---- */
    /* The radius is positive. With a negative radius POV-Ray's bounding box is
     * inverted, and the ball is visible only if there are fewer than three objects. */
    { "ball", NULL, "sphere {\n@-.2:.2@$[, | $]^4.4:.9^\n" },
    { "box", NULL, "box {\n@-.8:-.2@, @.2:.8@\n" },
    { "cylinder", NULL, "cylinder {\n@-.7:-.2@, @.2:.7@, ~.2:.6~\n" },
    { "cone", NULL, "cone {\n@-.7:-.2@, ~.3:.6~, @.2:.7@, $3[0|~.2:.6~$]\n" },
    /* The tube does not intersect itself. Otherwise POV-Ray returns normals of another
     * part for surfaces that are only visible from inside. */
    { "torus", NULL, "torus {\n~.5:.8~, ~.1:.4~\nsturm\n" },
    { "ellipsoid", NULL, "quadric {\n@1.4:4@, @-.5:.5@, @-.2:.2@, -^4.6:1^\n" },
    /* x^4 + y^4 + z^4 and terms of the second order. */
    { "quartic", NULL,
      "quartic {\n<2, 0,0,0, ^30:1^,0,0, ^30:1^,0,^3-1:1^, 0,0,0,0,0,^3-.5:.5^, 0,0,0,0, "
      "3, 0,0, ^30:1^,0,^3-1:.5^, 0,0,0,0, 2, 0,^3-.7:.5^,0, -^3.4:1^>\nsturm\n" },
    { "component", write_component, NULL },
    { "blob_begin", NULL,
      "blob {\nthreshold ^4.2:.6^\n$.sphere { <^3-.3:.3^, 0, ^3-.3:.3^>, .8, 1.3 }\n" },
    { "shape", open_solid, NULL },
    /* Unbounded shapes, which are used to cut. */
    { "plane", NULL, "plane {\n$arrow;, ^4-.2:.5^\n" },
    { "quadric", open_quadric, NULL },
    { "cubic", NULL,
      "$2[cubic {\n|poly { 3,\n$]<^3.2:1^, 0,0,.2, 0,0,0, 0,0,1, ^3-.5:.5^, 0,0, 0,0,1, "
      "^3-1:-.2^, .1,-1, .02>\nsturm\n" },
    { "endless", NULL, "$6[$quadric;|$cubic;|$plane;$]" },
    /* Shapes without an inside. Some have textures of their own. */
    { "disc", NULL, "disc {\n@-.2:.2@, $arrow;, ^4.5:1^$2[, ^4.1:.4^|$]\n" },
    { "triangle", open_lone_triangle, NULL },
    { "bent_triangle", open_bent_triangle, NULL },
    { "mesh", NULL, "mesh {\n$*1:4[$bent_triangle;}\n$]" },
    { "net", open_net, NULL },
    { "bicubic", open_bicubic, NULL },
    /* An outline with a hole, or a star that intersects itself. */
    { "polygon", NULL,
      "polygon {\n$3[6, <0, .9>, <.53, -.73>, <-.86, .28>, <.86, .28>, <-.53, -.73>, "
      "<0, .9>|5, <-.8, -.7>, <.8, -.6>, <.7, .8>, <-.9, .6>, <-.8, -.7>$]\n" },
    /* Characters with few curves. POV-Ray stores curves in 32 bits, which is visible in
     * highlights. */
    { "sign", NULL,
      "text {\nttf \"timrom.ttf\" \"$[A|H|M|L$]\" ^3.1:.5^, ^20:.2^*x\n" },
    { "sheet", NULL,
      "$12[$sign;|$[$disc;|$disc;|$triangle;|$mesh;|$net;|$bicubic;|$polygon;$]$]" },
    /* ---- Modifiers ---- */
    { "place", NULL, "translate <~-2.2:2.2~, ~-1:1.6~, ~-2:2~>\n" },
    /* Moves a part of a solid, so that no faces coincide. */
    { "shift", NULL, SHIFT },
    { "clip", write_clip, NULL },
    { "cuts", NULL, "$8[$clip;|$]$10[hollow\n|$]" HIDDEN("10") },
    /* A texture before, between or after transforms. */
    { "dress", NULL, "$turns;$look;$turns;" },
    /* ---- Solids ---- */
    { "listed_solid", write_listed_solid, NULL },
    { "great_solid", write_great_solid, NULL },
    { "reference", NULL,
      "object {\n$=Solid;\n$2[$copied;$look;|$]$turns;" SHIFT "}\n" },
    /* ---- Objects ---- */
    { "shape_thing", NULL, "$shape;$dress;$cuts;$place;}\n" },
    { "sheet_thing", NULL, "$sheet;$dress;" HIDDEN("8") "$place;}\n" },
    /* These words have no effect here. */
    { "solid_thing", NULL,
      "object {\n$great_solid;$2[$?Look[$copied;|$]$look;|$]$turns;"
      "$6[$[hollow|hollow off|no_radiosity|photons { }$]\n|$]" HIDDEN(
          "8") "$place;}\n" },
    { "named_thing", NULL,
      "object {\n$=Solid;\n$turns;$copied;$look;$turns;$cuts;$place;}\n" },
    /* A list of solids and sheets. */
    { "listed", NULL, "$3[$sheet;$turns;" SHIFT "}\n|$listed_solid;$]" },
    { "group", NULL,
      "union {\n$2[|$listed;$]$listed;$listed;$dress;" HIDDEN("12") "$place;}\n" },
    /* An object inside a box or a ball, which is its bound. */
    { "bounded_thing", NULL,
      "union {\nbox {\n@-.6:-.1@, @.1:.6@\n$2[$look;|$]}\n"
      "sphere {\n@-.6:-.1@, ~.2:.5~\n$2[$look;|$]}\n"
      "bounded_by {\n$2[box { -1.7, 1.7 }|sphere { 0, 1.9 }$]\n}\n$dress;$place;}\n" },
    /* Closed solids without an opening. In POV-Ray a camera ray enters an open solid
     * from the back; here the ray leaves it. */
    { "clear_thing", NULL, "$2[$bent;|$unbent;$]" HIDDEN("6") "$place;}\n" },
    { "bent", NULL, "$unbent;interior { ior ~1.1:1.7~ }\n" },
    { "unbent", write_clear_look, NULL },
    { "small", NULL, "$shape;$turns;$look;scale ^3.3:.6^\n" },
    { "for", write_for, NULL },
    { "while", NULL,
      "#declare Turn = 0;\n#while (Turn < ^#2:4^)\n$4[#if (Turn > 2) #break #end\n|$]"
      "$small;translate <^3.7:1.2^*Turn - ^31:2.2^, ^3-1:1.5^, ^3-2:2^*mod(Turn, 2)>\n}\n"
      "#declare Turn = Turn + 1;\n#end\n" },
    { "condition", NULL,
      "$[#if (|#if (|#if (0.3 > $]$f2;)\n$shape_thing;$3[#elseif ($f2;)\n$shape_thing;|$]"
      "#else\n$shape_thing;#end\n" },
    { "switch", NULL,
      "#switch (mod(floor(2*abs($f2;)), 4))\n#case (0)\n$shape_thing;$2[#break\n|$]"
      "#range (1, 2.5)\n$sheet_thing;#break\n#else\n$shape_thing;#end\n" },
    { "defined", NULL,
      "$2[#ifdef (N0)|#ifndef (Nobody)$]\n$shape_thing;#else\n$sheet_thing;#end\n" },
    { "thing", NULL,
      "$18[$?Solid[$named_thing;|$other_thing;$]|$other_thing;|$other_thing;"
      "|$any_thing;$]" },
    { "other_thing", NULL, "$?clear[$clear_thing;|$any_thing;$]" },
    { "macro", write_macro, NULL },
    { "any_thing", NULL,
      "$[$shape_thing;|$shape_thing;|$sheet_thing;|$sheet_thing;|$sheet_thing;"
      "|$solid_thing;|$solid_thing;|$solid_thing;|$group;|$bounded_thing;|$for;|$while;"
      "|$condition;|$switch;|$defined;$]" },
    /* ---- Cameras, lights, the ground ---- */
    { "width", NULL,
      "$[right x*image_width/image_height|right 4/3*x|right -x*4/3|right x*4/3 up y"
      "|up 1.2*y right 1.6*x$]\n" },
    { "aim", NULL, "look_at @-.4:.4@\n$4[sky <~-.6:.6~, 1, .2>\n|$]" },
    /* A camera that is defined by its vectors, and rotated as a whole. */
    { "turned_camera", NULL,
      "$3[orthographic\n" AFTER_TURNED "$.right ^35:8^*x up ^34:6^*y\n"
      "|" AFTER_TURNED "$2[$width;|$]$]rotate <~-5:35~, ~-180:180~, ~-20:20~>\n" },
    { "looking_camera", write_looking_camera, NULL },
    /* The point is below all lamps. */
    { "point_at", NULL, "point_at @-3:3@\n" },
    { "spotlight", NULL,
      "spotlight\n$point_at;$2[radius ~5:60~\n|$]$2[falloff ~10:100~\n|$]"
      "$2[tightness ~0:8~\n|$]" },
    { "light_cylinder", NULL,
      "cylinder\n$point_at;$2[radius ~.5:3~\n|$]$2[falloff ~1:6~\n|$]"
      "$2[tightness ~0:8~\n|$]" },
    { "area", write_area, NULL },
    { "fading", NULL, "$area;$5[fade_distance ~1:12~\nfade_power ~.5:4~\n|$]" },
    /* Only a cone of rays that are not parallel fades. POV-Ray fades the far side of
     * other beams differently (docs/povray.md). */
    { "beam", NULL,
      "$2[$4[parallel\n$point_at;|$spotlight;$fading;$]"
      "|$4[parallel\n$point_at;|$light_cylinder;$]$]" },
    { "lamp", NULL,
      "light_source {\n<~-9:9~, ~4:12~, ~-9:9~>, $color;\n"
      "$5[shadowless\n$fading;|$3[$beam;|$fading;$]$]"
      "$5[translate <^3-2:2^, 1, .5>\n|$]}\n" },
    /* The ground is below all objects. It is hollow, because an orthographic picture
     * may start below it, and POV-Ray shows no fog inside a body that is not hollow. */
    { "ground", NULL,
      "$2[plane {\ny, -2.6137 hollow\n$far_pigment;|disc {\n-2.6137*y, y, 6\n$pigment;$]"
      "$3[$ground_finish;|$]}\n" },
};
const size_t language_rule_count = sizeof language_rules / sizeof *language_rules;
