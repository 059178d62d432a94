; Registers and memory are compared after exchanges of several lengths, also with the
; descriptors' own registers.  A wrong length, order or address fails.
; tests: SWAP
; SWAP: stores registers S, S+1, .. in vector T, then loads registers S, S+1, ..
; from vector R

        .regs   r10, load, save

        .data
new:    .word   101, 102, 103, 104
old:    .word   9.0, 9.0, 9.0, 9.0
only_old:
        .word   9.0, 9.0
exchange:
        .word   201, 202
        .code
        ES      r30, 1
        ES      r31, 2
        ES      r32, 3
        ES      r33, 4
        ES      r34, 5
; three words are saved and four are loaded
        EX      load, new
        ELEN    load, 4
        EX      save, old
        ELEN    save, 3
        SWAP    [load], r30, [save]
; expect: [old] = 1, 2, 3, 9.0
; expect: r30 = 101
; expect: r31 = 102
; expect: r32 = 103
; no word is loaded
        ELEN    load, 0
        EX      save, only_old
        ELEN    save, 2
        SWAP    [load], r33, [save]
; expect: [only_old] = 104, 5
; expect: r33 = 104
; expect: r34 = 5
; no word is moved
        ELEN    save, 0
        SWAP    [load], r30, [save]
; the saved words are loaded if both descriptors name the same vector
        ES      r40, 301
        ES      r41, 302
        EX      load, exchange
        ELEN    load, 2
        EX      save, exchange
        ELEN    save, 1
        SWAP    [load], r40, [save]
; expect: [exchange] = 301, 202
; expect: r40 = 301
; expect: r41 = 202
; the registers may include the descriptors themselves
        EX      load, new
        ELEN    load, 2
        ELEN    save, 0
        SWAP    [load], load, [save]
; expect: r10 = 101
; expect: r11 = 102
        EXIT
; expect-flags: X'0000 0000 0000 0000'
