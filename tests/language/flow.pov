// flow.pov - conditions, loops and switches.
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

#if (1.5) Text("1.5") #end #if (1e-12) Text("1e-12") #end
#if (-1) Text("-1") #else Text("not -1") #end
#if (1) #elseif (2) Text("elseif") #end
#if (0) #elseif (2) Text("2") #elseif (1) Text("1") #else Text("0") #end
#if (0) #elseif (0) Text("2") #else Text("else") #end
#if (0) #if (1) Text("in") #else Text("else") #end #else Text("out") #end
#declare Value = 4;
#if (Value = 4 & !(Value = 3)) Text("4") #end
#if (Value < 2 | Value > 3) Text("far") #end
#ifdef (Value) Text("defined") #else Text("not defined") #end
#ifndef (Nothing) Text("not defined") #end
#ifdef (sin) Text("a function") #else Text("a word") #end
Number(defined(Value)) Number(defined(Nothing)) Number(defined(pi))
#undef Value
Number(defined(Value))

#declare Turn = 0;
#while (Turn < 3)
    Number(Turn)
    #declare Turn = Turn + 1;
#end
Number(Turn)
#while (1)
    #declare Turn = Turn + 1;
    #if (Turn > 10) #break #end
    Text("turn")
#end
#for (I, 1, 3) #for (J, I, 3) #if (J = 2) #break #end Number(10*I + J) #end #end
#local Count = 0; #for (K, 0, 1, .1) #local Count = Count + 1; #end
Number(Count) Number(K)
#local Count = 0; #for (K, 1, 0, -.1) #local Count = Count + 1; #end
Number(Count) Number(K)
#local Count = 0; #for (K, 1, 0) #local Count = Count + 1; #end
Number(Count) Number(K)
#for (K, 0, 3) Number(K) #local K = K + 1; #end

#macro Choose(A)
    #switch (A)
        #case (1) Text("one")
        #case (2) Text("two")
        #case (3) Text("three") #break
        #range (4, 6) Text("four to six") #break
        #case (7) Text("seven")
        #else Text("else")
    #end
#end
Choose(1) Choose(2) Choose(3) Choose(5) Choose(7) Choose(9) Choose(3.5)
#switch (1.00000000001) #case (1) Text("near") #end
#switch (2) #case (2) #if (1) #break #end Text("not here") #end
#debug "\n"
