// strings.pov - strings and their functions.
#version 3.7;
global_settings { assumed_gamma 1 }
// Number prints four numbers on a line.
#declare Column = 0;
#macro Number(Value)
    #declare Column = mod(Column + 1, 4);
    #debug concat(str(Value, 0, 9), #if (Column) " " #else "\n" #end)
#end
#macro Text(Value) #declare Column = 0; #debug concat(Value, "\n") #end
#macro Vector(Value) Text(vstr(3, Value, ", ", 0, 9)) #end

Text(str(3.14159, 8, 2)) Text(str(3.14159, -8, 2)) Text(str(3.7, 0, 0))
Text(str(3.7, 0, -1)) Text(str(-2.5, 10, 3)) Text(str(-2.5, -10, 3))
Text(str(1e10, 0, 3)) Text(str(.5, 0, 0)) Text(str(1/3, 0, 20))
Text(str(1234.5, 3.7, 1.9)) Text(str(2, 0, -3))
Text(vstr(2, <1, 2>, " ", 5, 1)) Text(vstr(4, <1, 2>, "|", 0, 0))
Text(vstr(5, x, "|", 0, 0)) Text(vstr(3, <1, 2, 3>, ", ", -7, 2))
Text(chr(65)) Text(substr("abcdef", 2, 3)) Text(substr("abcdef", 1, 6))
Text(strupr("aBc1")) Text(strlwr("aBc1"))
Text(concat("a")) Text(concat("a", "b", chr(99), str(4, 0, 0)))
Number(strlen("abc")) Number(strlen("")) Number(asc("A")) Number(asc(""))
Number(val("1.5e2")) Number(val("12abc")) Number(val("")) Number(val("  7"))
Number(strcmp("abc", "abd")) Number(strcmp("a", "c")) Number(strcmp("a", "a"))
Number(strcmp("abcd", "abc"))
#declare Name = "first";
#declare Other = concat(Name, "-", Name)
#declare Third = Other
Text(Third)
#debug "tab\there, \"quoted\", back\\slash, \u0041\n"
#debug "one " #debug concat("line", "\n")
#macro Join(A, B) concat(A, "/", B) #end
Text(Join("x", Join(Name, "z")))
#declare Joined = Join("p", "q");
Text(Joined)
#include concat("colors", ".inc")
Number(Red.red)
Number(file_exists("colors.inc")) Number(file_exists("no such file.inc"))
#debug "\n"
