// arrays.pov - arrays and their elements.
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

#declare Row = array[3] { 5, 6, 7 }
Number(Row[0]) Number(Row[2]) Number(Row[1.7]) Number(Row[Row[0] - 4])
Number(dimensions(Row)) Number(dimension_size(Row, 1))
Number(dimension_size(Row, 2))
#declare Grid = array[2][3] { { 1, 2, 3 }, { 4, 5, 6 } }
Number(Grid[1][2]) Number(dimensions(Grid)) Number(dimension_size(Grid, 2))
#declare Copy = Row
#declare Copy[0] = 9;
Number(Copy[0]) Number(Row[0])
#declare Sparse = array[2.9];
#declare Sparse[1] = 4;
Number(dimension_size(Sparse, 1))
Number(defined(Sparse[1])) Number(defined(Sparse[0])) Number(defined(Sparse))
#ifdef (Sparse[0]) Text("set") #else Text("not set") #end
#ifdef (Sparse[1]) Text("set") #else Text("not set") #end
#declare Points = array[2] { <1, 2, 3>, <4, 5, 6>, }
Number(Points[1].z) Vector(Points[0] + Points[1]*2)
#declare Names = array[2] { "a", concat("b", "c") }
Text(Names[1])
#declare Nested = array[2] { array[2] { 1, 2 }, array[1] { 3 } }
Number(Nested[0][1]) Number(Nested[1][0]) Number(dimension_size(Nested[0], 1))
#declare Nested[0][1] = 8;
Number(Nested[0][1])

#macro Increase(A) #declare A = A + 1; #end
Increase(Row[1]) Number(Row[1])
#macro Fill(A, V)
    #for (I, 0, dimension_size(A, 1) - 1) #declare A[I] = V*I; #end
#end
Fill(Row, 2) Number(Row[0]) Number(Row[1]) Number(Row[2])
#macro Keep(A) #local B = A; #declare B[0] = 70; Number(A[0]) #end
Keep(Row)
#macro Set(A) #local A[0] = 71; #end
Set(Row) Number(Row[0])
#declare Solids = array[2] { sphere { 0, 1 }, box { 0, 1 } }
object { Solids[1] } union { object { Solids[0] } object { Solids[1] } }
#declare Moves = array[1] { transform { translate x } }
object { Solids[0] transform { Moves[0] } pigment { rgb Points[0] } }
#debug "\n"
