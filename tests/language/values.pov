// values.pov - floats, vectors and their functions.
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

// Signs and precedence.
Number(2-3-4) Number(12/3/2) Number(-2*-3) Number(2+3*4) Number(-(2+3)*4)
Number(5/2) Number(1e-3) Number(.5) Number(5.) Number(1.5e+2)
Number((true & false | true)) Number((1 | 0 & 0)) Number(!0) Number(2*!0)
Number(!5) Number(!!5)

// Numbers that differ by less than 1e-10 are equal; < and > have no tolerance.
Number((1 = 1 + 1e-11)) Number((1 = 1 + 1e-9)) Number((1 != 1 + 1e-11))
Number((1 < 1 + 1e-11)) Number((1 > 1 - 1e-11)) Number((1 > 1 + 1e-11))
Number((1 >= 1 + 1e-11)) Number((1 >= 1 + 1e-9)) Number((1 <= 1 - 1e-11))
Number((1 <= 1 - 1e-9)) Number((1 < 1)) Number((1 > 1)) Number((3 > 2) + 1)
Number((1e-11 ? 1 : 0)) Number((1e-9 ? 1 : 0)) Number(!1e-11)
Number((1e-11 & 1)) Number((1e-11 | 0)) Number((0 ? 2 : 0 ? 5 : 6))
Number((1 ? 2 : 3)) Number(("b" > "a")) Number(("a" != "a"))
Number(("abc" = "abc")) Number(("abc" < "abd"))

// Functions.
Number(abs(-2)) Number(int(-1.5)) Number(int(1.5)) Number(floor(-1.5))
Number(ceil(1.2)) Number(ceil(-1.2)) Number(div(-7, 3)) Number(div(7, 3))
Number(mod(-7, 3)) Number(mod(7, -3)) Number(mod(7.5, 2))
Number(min(3, 1, 2)) Number(max(3, 1, 2)) Number(min(4, 5)) Number(max(-1, -2))
Number(select(-1, 1, 2)) Number(select(0, 1, 2)) Number(select(1, 1, 2))
Number(select(0, 1, 2, 3)) Number(select(1, 1, 2, 3)) Number(select(-1, 1, 2, 3))
Number(pow(2, .5)) Number(pow(-2, 3)) Number(pow(2, -2)) Number(sqrt(2))
Number(exp(1)) Number(ln(2)) Number(log(100)) Number(degrees(pi))
Number(radians(180)) Number(sin(1)) Number(cos(1)) Number(tan(1))
Number(asin(1)) Number(acos(0)) Number(atan2(1, 2)) Number(atan2(-1, -2))
Number(sinh(1)) Number(cosh(1)) Number(tanh(1)) Number(asinh(1))
Number(acosh(2)) Number(atanh(.5))
Number(bitwise_and(6, 3)) Number(bitwise_or(6, 3)) Number(bitwise_xor(6, 3))
Number(bitwise_and(7, 3, 1)) Number(bitwise_xor(7.9, 1))

// Random numbers.
#declare First = seed(42);
#declare Second = seed(42);
#declare Third = seed(-1.5);
Number(First) Number(Second) Number(Third)
Number(rand(First)) Number(rand(First)) Number(rand(First))
Number(rand(Second)) Number(rand(Third)) Number(rand(Third))

// Vectors.
Vector(<1, 2, 3>*<2, 2, 2> + 1) Vector(x + 2*y - z/4) Vector(-<1, 2, 3>)
Vector(vcross(x, y)) Vector(vcross(<1, 2, 3>, <4, 5, 6>))
Vector(vnormalize(<1, 2, 2>)) Vector(vrotate(x, <0, 30, 40>))
Vector(vrotate(<1, 2, 3>, <10, 20, 30>)) Vector(vaxis_rotate(x, <1, 2, 3>, 33))
Vector(vaxis_rotate(<1, 2, 3>, z, 90)) Vector((1 ? x : y))
Number(vdot(x, <1, 2, 3>)) Number(vlength(<3, 4, 0>))
Text(vstr(4, <1, 2, 3, 4>/2, ", ", 0, 3)) Text(vstr(2, <1, 2> + 1, ", ", 0, 3))
#declare Colour = rgbft <1, 2, 3, 4, 5>;
Number(Colour.red) Number(Colour.filter) Number(Colour.transmit)
Number(Colour.gray)
#declare Five = Colour*2;
Text(vstr(5, Five, ", ", 0, 3)) Number(Five.transmit) Number(<7, 8, 9>.y)

// Values that a scene of a still picture can use.
Number(clock) Number(clock_on) Number(clock_delta) Number(frame_number)
Number(initial_frame) Number(final_frame) Number(initial_clock)
Number(final_clock) Number(version) Number(pi) Number(yes) Number(off)
#debug "\n"
