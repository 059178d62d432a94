// functions.pov - functions that the scene declares, and values that #read reads from a file.
#version 3.7;
#declare K = 3;
#declare F = function(a, b) { a*b + K }
#declare G = function { F(x, y) - z*-2 }
#declare H = function(x) { select(x, -1, 0, 1) + (x > 2 & x <= 5)*max(x, 1, 2) }
#declare I = function(x, y) { -x - +y*2/(1 + x*x) + K }
#declare J = function(p, q) { (p = q) + 2*(p != q) + 4*(p < q) + 8*(p >= q | q > 3) }
#declare O = function(a) { (a | 0 & 0) + 2*(a & 0 | 1) + 4*(a = 1 + 1e-12) + 8*(a <= 1 - 1e-12) + 16*(1e-12 & 1) }
#declare L = function(t1) { atan2(sin(t1), cos(t1)) + pow(t1, 2) + mod(7, t1) + ln(exp(t1)) + int(2.7) }
#declare M = function { transform { translate <1, 2, 3> scale 2 rotate 90*z } }
#declare N = function(q) { M(q, 2*q, 3*q).y + M(q, 0, 0).x }
#declare P = function { pigment { bozo } }
#declare Q = function(a, b, c) { P(a, b, c).red + a }
#declare K = 5;
#macro Show(A) #debug concat(str(A, 0, 5), "\n") #end
Show(F(2, 4))
Show(G(1, 2, 3))
#for (T, -3, 6, 1.5)
    Show(H(T))
    Show(I(T, T*2))
    Show(J(T, 3))
#end
Show(O(1))
Show(L(1.25))
Show(N(.5))
#debug concat(vstr(3, M(0, 0, 1), ", ", 0, 4), "\n")
#declare S = function(x) { sin(x)*F(x, x) }
Show(S(S(.3)) + 2*S(1) - -S(2))
#fopen Data "functions.csv" read
#while (defined(Data))
    #read (Data, A, B, C, D)
    #debug concat(str(A, 0, 2), " ", str(B, 0, 2), " ", vstr(3, C, ", ", 0, 2), " ", D, "\n")
#end
#fopen Data "functions.csv" read
#read (Data A, B)
Show(A + B)
#fclose Data
#fopen Data "functions.csv" read
#while (defined(Data))
    #read (Data, A B, C D E)
    #debug concat(str(A, 0, 2), " ", D, "\n")
#end
#ifdef (Data) #debug "still open\n" #else #debug "closed\n" #end
