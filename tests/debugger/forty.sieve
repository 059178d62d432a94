step 0, clock 0
=> 400000  EX r20, 0x400000000000        ; sieve.s:25: load_constant flag, 1.0  <- core.s:17: EX      flag, bits(1.0) & 0xFFFFFFFFFFFF
(c205) where
step 0, clock 0
=> 400000  EX r20, 0x400000000000        ; sieve.s:25: load_constant flag, 1.0  <- core.s:17: EX      flag, bits(1.0) & 0xFFFFFFFFFFFF
(c205) list
=> asm/examples/sieve.s:25	        load_constant flag, 1.0
   asm/examples/sieve.s:26	        descriptor fs, flags, limit
   asm/examples/sieve.s:28	        VTOV    flag, [fs]
   asm/examples/sieve.s:29	        STO     [fs], r0
   asm/examples/sieve.s:30	        ES      one, 1
   asm/examples/sieve.s:31	        STO     [fs, one], r0
   asm/examples/sieve.s:33	        ES      p, 2
   asm/examples/sieve.s:34	        ES      end, limit
   asm/examples/sieve.s:35	next:   LOD     [fs, p], flag
   asm/examples/sieve.s:36	        CFPEQ   flag, r0, composite
(c205) disassemble
=> 400000  EX r20, 0x400000000000        ; sieve.s:25: load_constant flag, 1.0  <- core.s:17: EX      flag, bits(1.0) & 0xFFFFFFFFFFFF
   400040  ELEN r20, -46                 ; sieve.s:25: load_constant flag, 1.0  <- core.s:18: ELEN    flag, bits(1.0) >> 48 & 0xFFFF
   400060  EX r10, 0x800000              ; sieve.s:26: descriptor fs, flags, limit  <- core.s:11: EX      fs, flags
   4000A0  ELEN r10, 200                 ; sieve.s:26: descriptor fs, flags, limit  <- core.s:12: ELEN    fs, limit
   4000C0  VTOV r20, [r10]               ; sieve.s:28: VTOV    flag, [fs]
   400100  STO [r10], r0                 ; sieve.s:29: STO     [fs], r0
   400120  ES r14, 1                     ; sieve.s:30: ES      one, 1
   400140  STO [r10, r14], r0            ; sieve.s:31: STO     [fs, one], r0
   400160  ES r15, 2                     ; sieve.s:33: ES      p, 2
   400180  ES r17, 200                   ; sieve.s:34: ES      end, limit
(c205) info symbols
4003A0  composite, code
800000  flags, 200 words
4001A0  next, code
803300  places, 200 words
803200  prime, 4 words
(c205) info pages
      400000  read and written
      800000  read and written
(c205) info regions
4000C0 .. 4004E0  sieve
(c205) step
step 1, clock 1
=> 400040  ELEN r20, -46                 ; sieve.s:25: load_constant flag, 1.0  <- core.s:18: ELEN    flag, bits(1.0) >> 48 & 0xFFFF
(c205) step 3
step 4, clock 4, region sieve
=> 4000C0  VTOV r20, [r10]               ; sieve.s:28: VTOV    flag, [fs]
(c205) 
step 7, clock 1187, region sieve
=> 400140  STO [r10, r14], r0            ; sieve.s:31: STO     [fs, one], r0
(c205) info operands
    fs (r10) = X'00C8 0000 0080 0000' (8388608)
    one (r14) = X'0000 0000 0000 0001' (1)
    r0 = X'0000 0000 0000 0000' (0)
(c205) why
   400120  ES r14, 1                     ; sieve.s:30: ES      one, 1
arrived at clock 1186, issued at 1186, its result at 1187, its unit free at 1187
         1  clocks, of these
         1  issue           
(c205) print step
X'0000 0000 0000 0000'  number 0  address 0
(c205) print clock * 2 + 1
2375  X'947'
(c205) info registers
register          word                   number                 length      address
r10  fs           X'00C8 0000 0080 0000' 1.34799733335754e67       200       800000
r14  one          X'0000 0000 0000 0001' 1                                        1
r20  flag         X'FFD2 4000 0000 0000' 1                       65490 400000000000
(c205) break insn EXIT
break 1: insn EXIT
(c205) tbreak insn EX if step > 4
break 2: insn EX if step > 4
(c205) watch 0x800000, 4
watch 3: 0x800000, 4
(c205) info breaks
1 break insn EXIT, hit 0 times
2 break insn EX if step > 4, once, hit 0 times
3 watch 0x800000, 4, hit 0 times
(c205) continue
watch 3: [800040] was 1, is 0
step 8, clock 1188, region sieve
=> 400160  ES r15, 2                     ; sieve.s:33: ES      p, 2
(c205) why
   400140  STO [r10, r14], r0            ; sieve.s:31: STO     [fs, one], r0
arrived at clock 1187, issued at 1187, its result at 1188, its unit free at 1188
         1  clocks, of these
         1  issue           
(c205) account
outside regions: 4 clocks, 4 instructions, 0 of them vector, 0 elements
         4  issue
sieve: 1184 clocks, 4 instructions, 1 of them vector, 200 elements
         3  issue
        51  vector start-up
       100  vector stream
        30  translation miss
      1000  page fault
1188 clocks in all
(c205) reverse-step 2
step 6, clock 1186, region sieve
=> 400120  ES r14, 1                     ; sieve.s:30: ES      one, 1
(c205) print pc
4194592  X'400120'
(c205) reverse-continue
watch 3: [800000] was 0, is 1
step 5, clock 5, region sieve
=> 400100  STO [r10], r0                 ; sieve.s:29: STO     [fs], r0
(c205) next 2
watch 3: [800000] was 1, is 0
step 6, clock 1186, region sieve
=> 400120  ES r14, 1                     ; sieve.s:30: ES      one, 1
(c205) until *0x400120
watch 3: [800040] was 1, is 0
step 8, clock 1188, region sieve
=> 400160  ES r15, 2                     ; sieve.s:33: ES      p, 2
(c205) account
outside regions: 4 clocks, 4 instructions, 0 of them vector, 0 elements
         4  issue
sieve: 1184 clocks, 4 instructions, 1 of them vector, 200 elements
         3  issue
        51  vector start-up
       100  vector stream
        30  translation miss
      1000  page fault
1188 clocks in all
(c205) goto 5
step 5, clock 5, region sieve
=> 400100  STO [r10], r0                 ; sieve.s:29: STO     [fs], r0
(c205) x/4 0x800000
     0               1               1               1               1
(c205) x/2x 0x800000
     0  FFD2 4000 0000 0000  FFD2 4000 0000 0000
(c205) set [0x800040] = 2.5
(c205) print [0x800040]
X'FFD3 5000 0000 0000'  number 2.5  length 65491, address 500000000000
(c205) assert [0x800040] == 2.5
(c205) delete 1
(c205) info breaks
2 break insn EX if step > 4, once, hit 0 times
3 watch 0x800000, 4, hit 3 times
(c205) goto clock 1100
step 6, clock 1186, region sieve
=> 400120  ES r14, 1                     ; sieve.s:30: ES      one, 1
(c205) reverse-step
step 5, clock 5, region sieve
=> 400100  STO [r10], r0                 ; sieve.s:29: STO     [fs], r0
(c205) run
watch 3: [800000] was 0, is 1
step 5, clock 5, region sieve
=> 400100  STO [r10], r0                 ; sieve.s:29: STO     [fs], r0
(c205) delete
(c205) continue
46
001101010001010001010001000001
step 145, clock 3190
the program has ended with status 0
ends with 0
