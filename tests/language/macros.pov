// macros.pov - macros, their arguments and their names.
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

#macro Product(A, B) A*B #end
Number(Product(2, 3) + 1) Number(Product(1 + 1, 3)) Number(-Product(2, 3))
#macro Three() 3 #end
Number(Three()*2) Number(<Three(), 1, Three()>.z)
#macro Row(A) <A, A + 1, A + 2> #end
#declare Here = Row(3);
Number(Here.z) Number(Row(4).y) Number(vlength(Row(0)*2))

// An argument that is a name alone is passed by reference.
#macro Increase(A) #declare A = A + 1; #end
#declare Value = 1;
Increase(Value) Number(Value)
Increase((Value)) Number(Value)
#macro Both(Value) #declare Value = Value + 1; Number(Value) #end
Both(5) Number(Value) Both((Value)) Number(Value) Both(Value) Number(Value)
#macro Locally(A) #local A = A + 10; Number(A) #end
Locally(Value) Number(Value) Locally(3)
#macro Forget(A) #undef A Number(defined(A)) #end
Forget(Value) Number(Value)
#macro Outer(A) Increase(A) Increase(A) #end
Outer(Value) Number(Value)
#macro Swap(A, B) #local T = A; #declare A = B; #declare B = T; #end
#declare P = 1; #declare Q = 2;
Swap(P, Q) Number(P) Number(Q)

// Scopes of names.
#macro Inner() #declare Level = 7; #end
#macro Around() #local Level = 1; Inner() Number(Level) #end
Around() Number(defined(Level))
#macro Global() #declare Made = 3; #local Gone = 4; #end
Global() Number(Made) Number(defined(Gone))
#local Here = 3;
#macro Change() #declare Here = 4; #end
Change() Number(Here)
#macro Shadow() #local Here = 9; #declare Here = 8; Number(Here) #end
Shadow() Number(Here)
#macro Counter() #for (Here, 5, 6) #end Number(Here) #end
Counter() Number(Here)

// Nested calls, and the end of a macro by #break.
#macro Down(N) #if (N > 0) Number(N) Down(N - 1) #end #end
Down(4)
#macro Until(A) #if (A) Text("leaving") #break #end Text("staying") #end
Until(1) Until(0)
#macro Define() #macro Defined(A) Number(A*2) #end #end
Define() Defined(21)
Number(defined(Defined))

// Macros that contain parts of statements.
#macro Look() pigment { rgb 1 } scale 2 #end
#macro Ball(R) sphere { 0, R } #end
#macro Open() union { #end
#macro Close() } #end
#declare One = Ball(2);
#declare Two = object { One Look() }
Open() Ball(1) Ball(2) object { Two } Close()
sphere { #if (0) 0 #else x #end, Three() Look() }
#macro Moved(T) sphere { 0, 1 transform { T } } #end
#local T = transform { translate x }
Moved(T)
#debug "\n"
