; Registers are compared with words worked out by hand after instructions that set, add
; to or move a register or a part of it.  A wrong sign, carry, half or length field, or
; a change of register 0, makes a word differ.
; tests: ES EX IS IX ELEN ADDLEN LTOR EXH IXH RTOR RTORH

        .include "scalar.inc"

        .reg    by, r160
        .regs   r130, up, down, wrapped, length, none, vector, longer, shorter, less
        .regs   r139, high, longest

; ES: R := I16, sign extended to 48 bits; high 16 bits zero
        EX      r11, -1                 ; replaces all 64 bits
        ES      r10, 5
        ES      r11, -2
        ES      r12, 32767
        ES      r13, -32768
        register_is ES, r10, 5
        register_is ES, r11, X'0000 FFFF FFFF FFFE'
        register_is ES, r12, 32767
        register_is ES, r13, X'0000 FFFF FFFF 8000'
        ES      r0, 7                   ; register 0 keeps no value
        flags_are ES, X'0000 0000 0000 0000'
; EX: R := I48; high 16 bits zero
        .data
EX.place: .word   42
        .code
        EX      r10, X'1234 5678 9ABC'
        EX      r11, -1
        EX      r12, EX.place
        LOD     [r12], r13
        EX      r0, 5
        register_is EX, r10, X'0000 1234 5678 9ABC'
        register_is EX, r11, X'0000 FFFF FFFF FFFF'
        register_is EX, r12, EX.place
        register_is EX, r13, 42
; IS: low 48 bits of R += I16
        ES      up, 5
        IS      up, 300
        register_is IS, up, 305
        ES      down, 5
        IS      down, -6
        register_is IS, down, X'0000 FFFF FFFF FFFF'
        EX      wrapped, X'FFFF FFFF FFFF'
        IS      wrapped, 2
        register_is IS, wrapped, 1
; the high 16 bits are kept and receive no carry
        EX      length, X'FFFF FFFF FFFF'
        ELEN    length, 10
        IS      length, 1
        register_is IS, length, X'000A 0000 0000 0000'
        IS      r0, 1
; IX: low 48 bits of R += I48
        ES      r10, 5
        IX      r10, X'1000 0000 0000'
        register_is IX, r10, X'0000 1000 0000 0005'
        ES      r11, 5
        IX      r11, -6
        register_is IX, r11, X'0000 FFFF FFFF FFFF'
; the high 16 bits are kept and receive no carry: a descriptor advances by a word
        EX      r12, X'FFFF FFFF FFFF'
        ELEN    r12, 10
        IX      r12, 65
        register_is IX, r12, X'000A 0000 0000 0040'
        IX      r0, 1
; ELEN: length field of R := I16
        EX      r10, X'1234 5678 9ABC'
        ELEN    r10, 1000
        register_is ELEN, r10, X'03E8 1234 5678 9ABC'
        ES      r11, 0
        ELEN    r11, 65535              ; the longest vector
        register_is ELEN, r11, X'FFFF 0000 0000 0000'
        EX      r12, -1
        ELEN    r12, 7
        ELEN    r12, 0
        register_is ELEN, r12, X'0000 FFFF FFFF FFFF'
        ELEN    r0, 3
; ADDLEN: T := R with its length field increased by S
        EX      vector, X'FFFF 0000 0040'
        ELEN    vector, 100
        ES      by, 5
        ADDLEN  vector, by, longer
        register_is ADDLEN, longer, X'0069 FFFF 0000 0040'
        EX      less, -30
        ADDLEN  vector, less, shorter
        register_is ADDLEN, shorter, X'0046 FFFF 0000 0040'
; 16 bits: the length wraps and the address is kept
        EX      by, 65535
        ADDLEN  vector, by, wrapped
        register_is ADDLEN, wrapped, X'0063 FFFF 0000 0040'
        ADDLEN  vector, by, r0
; LTOR: T := length field of R, as an integer
        EX      vector, X'FFFF 0000 0040'
        ELEN    vector, 100
        LTOR    vector, length
        register_is LTOR, length, 100
        ELEN    vector, 65535
        LTOR    vector, longest
        register_is LTOR, longest, 65535
        LTOR    r0, none
        register_is LTOR, none, 0
; EXH: R := I24, as an integer
        EXH     h20, 5
        EXH     h21, -1                 ; the left half stays
        half_register_is EXH, h20, 5
        register_is EXH, r10, X'0000 0005 00FF FFFF'
        EXH     h22, X'FF FFFF'
        EXH     h23, 0x800000
        register_is EXH, r11, X'00FF FFFF 0080 0000'
        EXH     h24, -0x800000
        half_register_is EXH, h24, X'0080 0000'
        EXH     h255, 9
        register_is EXH, r127, X'0000 0000 0000 0009'
        EXH     h0, 7                   ; h0 and h1 are constants
        EXH     h1, 7
        flags_are EXH, X'0000 0000 0000 0000'
; IXH: low 24 bits of R += I24
        EXH     h20, 5
        IXH     h20, 300
        EXH     h21, 5
        IXH     h21, -6
        half_register_is IXH, h20, 305
        half_register_is IXH, h21, -1
        EXH     h22, X'FF FFFF'
        EXH     h23, 0
        IXH     h22, 2
        register_is IXH, r11, X'0000 0001 0000 0000'
; the high 8 bits are kept and receive no carry
        fetch_half half_left, X'0AFF FFFF'
        IXH     half_left, 1
        half_register_is IXH, half_left, X'0A00 0000'
        IXH     h0, 1
        IXH     h1, 1
        flags_are IXH, X'0000 0000 0000 0000'
; RTOR: T := R
        .data
RTOR.word: .word   X'7ABC 0123 4567 89AB'
        .code
        EX      r9, RTOR.word
        LOD     [r9], r10
        RTOR    r10, r11                ; copies all 64 bits
        RTOR    r10, r10
        RTOR    r10, r0
        ES      r12, 5
        RTOR    r0, r12                 ; as bits, register 0 is 0
        register_is RTOR, r10, X'7ABC 0123 4567 89AB'
        register_is RTOR, r11, X'7ABC 0123 4567 89AB'
        register_is RTOR, r12, 0
        flags_are RTOR, X'0000 0000 0000 0000'
; RTORH: T := R
        fetch_half half_left, X'7ABC 0123'      ; copies all 32 bits
        EXH     h201, 7
        RTORH   half_left, h200              ; from left to left
        RTORH   h200, h203              ; from left to right; keeps the other half
        RTORH   h203, h205              ; from right to right
        RTORH   h205, h206              ; from right to left
        RTORH   h206, h206
        register_is RTORH, r100, X'7ABC 0123 0000 0007'
        register_is RTORH, r101, X'0000 0000 7ABC 0123'
        register_is RTORH, r102, X'0000 0000 7ABC 0123'
        register_is RTORH, r103, X'7ABC 0123 0000 0000'
        RTORH   half_left, h0
        RTORH   half_left, h1
        EXH     h208, 5
        EXH     h209, 5
        RTORH   h0, h208                ; as bits, h0 and h1 are 0
        RTORH   h1, h209
        register_is RTORH, r104, 0
        flags_are RTORH, X'0000 0000 0000 0000'
; expect: r0 = 0
        EXIT
