; Elements that are gathered or scattered, by index or with a period, are compared with
; words worked out by hand, for every use and for results that overlap their sources.  A
; wrong index, order, length or control bit makes a word differ.
; tests: VGATHP VSCATP VTOVX VXTOV
; warns: zero-length VGATHP VSCATP VTOVX VXTOV

        .include "vector.inc"

        .regs   r200, vtable, period

; VGATHP: C(i) := B(i x A)
        .data
VGATHP.table0: .word   20.0, 21.0, 22.0, 23.0, X'7ABC 0123 4567 89AB', 25.0, 26.0
        .word   27.0, 28.0, 29.0, 30.0, 31.0, 32.0, 33.0, 34.0, 35.0
VGATHP.back: .word   X'1234 FFFF FFFF FFFE'
VGATHP.chain: .word   5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 11.0
        .code
        ES      by, 1
        descriptor vz, z, n
        EX      vtable, VGATHP.table0          ; its length is ignored
        ES      period, 3
        of_two  VGATHP, plain, period, [vtable], [to]
        of_two  VGATHP, where_ones, period, [vtable], [to] ? [vz]
        of_two  VGATHP, where_zeros, period, [vtable], [to] ?! [vz]
        of_two  VGATHP, offset_result, period, [vtable], [to, by] ? [vz] ; also offsets the control vector
        into    VGATHP.short_result, 2
        VGATHP  period, [vtable], [to]
        of_two  VGATHP, again, r0, [vtable], [to] ; r0 is a period of 0
        into    VGATHP.nothing, 0
        VGATHP  period, [vtable], [to]
; expect: [VGATHP.plain] = 20.0, 23.0, 26.0, 29.0, 32.0, 35.0
; expect: [VGATHP.where_ones] = 20.0, 9.0, 26.0, 29.0, 9.0, 9.0
; expect: [VGATHP.where_zeros] = 9.0, 23.0, 9.0, 9.0, 32.0, 35.0
; expect: [VGATHP.offset_result] = 9.0, 9.0, 23.0, 26.0, 9.0, 9.0
; expect: [VGATHP.short_result] = 20.0, 23.0, 9.0, 9.0, 9.0, 9.0
; expect: [VGATHP.again] = 20.0, 20.0, 20.0, 20.0, 20.0, 20.0
; expect: [VGATHP.nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
; A negative period: the table is read backwards.  Only 48 bits of it are used.
        EX      place, VGATHP.back
        LOD     [place], period
        EX      vtable, VGATHP.table0 + 64*14
        of_two  VGATHP, backwards, period, [vtable], [to]
; expect: [VGATHP.backwards] = 34.0, 32.0, 30.0, 28.0, 26.0, X'7ABC 0123 4567 89AB'
; The result overlaps the table: stored elements are gathered again.
        ES      period, 2
        EX      vtable, VGATHP.chain
        descriptor to, VGATHP.chain + 64, 4
        VGATHP  period, [vtable], [to]
; expect: [VGATHP.chain] = 5.0, 5.0, 7.0, 9.0, 11.0, 10.0, 11.0
        flags_are VGATHP, X'0000 0000 0000 0000'
; VSCATP: C(i x A) := B(i)
        .data
VSCATP.b: .word   30.0, 31.0, 32.0, 33.0, X'7ABC 0123 4567 89AB', 35.0
VSCATP.chain: .word   5.0, 6.0, 7.0, 8.0, 9.0, 10.0
        .code
        .macro  scatters name, a, b, mask=, first=0
        .data
VSCATP.\name: .word 9.0, 9.0, 9.0, 9.0, 9.0, 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
        .code
        EX      to, VSCATP.\name + 64*\first ; its length is ignored
        VSCATP  \a, \b, [to] \mask
        .endm
        descriptor vb, VSCATP.b, n
        descriptor vz, z, n
        ES      period, 2
        ES      twice, 2
        scatters plain, period, [vb]
        scatters where_ones, period, [vb], ? [vz]
        scatters where_zeros, period, [vb], ?! [vz]
        scatters offset_source, period, [vb, twice] ; shortens the source
        scatters again, r0, [vb] ; the last store to the place wins
        ES      period, -1
        scatters backwards, period, [vb], , 8
        ELEN    vb, 0
        scatters nothing, period, [vb]
; expect: [VSCATP.plain] = 30.0, 9.0, 31.0, 9.0, 32.0, 9.0, 33.0, 9.0
; expect: [VSCATP.plain + 8*64] = X'7ABC 0123 4567 89AB', 9.0, 35.0
; expect: [VSCATP.where_ones] = 30.0, 9.0, 9.0, 9.0, 32.0, 9.0, 33.0, 9.0, 9.0, 9.0
; expect: [VSCATP.where_zeros] = 9.0, 9.0, 31.0, 9.0, 9.0, 9.0, 9.0, 9.0
; expect: [VSCATP.where_zeros + 8*64] = X'7ABC 0123 4567 89AB', 9.0, 35.0
; expect: [VSCATP.offset_source] = 32.0, 9.0, 33.0, 9.0, X'7ABC 0123 4567 89AB', 9.0
; expect: [VSCATP.offset_source + 6*64] = 35.0, 9.0, 9.0, 9.0, 9.0
; expect: [VSCATP.again] = 35.0, 9.0, 9.0
; expect: [VSCATP.backwards] = 9.0, 9.0, 9.0, 35.0, X'7ABC 0123 4567 89AB', 33.0, 32.0
; expect: [VSCATP.backwards + 7*64] = 31.0, 30.0, 9.0, 9.0
; expect: [VSCATP.nothing] = 9.0, 9.0, 9.0
; The source overlaps the result: scattered elements are read again.
        descriptor vb, VSCATP.chain, 3
        EX      to, VSCATP.chain + 64
        ES      period, 1
        VSCATP  period, [vb], [to]
; expect: [VSCATP.chain] = 5.0, 5.0, 5.0, 5.0, 9.0, 10.0
        flags_are VSCATP, X'0000 0000 0000 0000'
; VTOVX: C(A(i)) := B(i)
        .data
VTOVX.a: .word   3, 0, -1, 2, 2, X'7123 0000 0000 0001'
VTOVX.b: .word   30.0, 31.0, 32.0, 33.0, 34.0, 35.0
VTOVX.scalars:
        .word   8.0, 1
VTOVX.chain: .word   5.0, 6.0, 7.0, 8.0
VTOVX.next: .word   1, 2, 3
        .bitvector VTOVX.own, 3, "110"
        .space  2
VTOVX.places: .word   0, 1, 2
VTOVX.values: .word   X'2000 0000 0000 0000', 5.0, 6.0
        .code
        .macro  stores name, a, b, mask=
        .data
VTOVX.\name: .word 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
        .code
        EX      to, VTOVX.\name + 64    ; its length is ignored
        VTOVX   \a, \b, [to] \mask
        .endm
        operands_of_two VTOVX.
        stores plain, [va], [vb] ; the last store to a place wins
        stores broadcast, [va], x
        stores where_ones, [va], [vb], ? [vz]
        stores where_zeros, [va], [vb], ?! [vz]
        stores offset_source, [va], [vb, twice] ; shortens the source
        stores offset_list, [va, twice], [vb] ; shortens the list
        stores short_list, [short_a], [vb]
        stores short_source, [va], [short_b] ; padded with machine zeros
        ELEN    va, 0
        stores nothing, [va], [vb]
; expect: [VTOVX.plain] = 32.0, 31.0, 35.0, 34.0, 30.0, 9.0
; expect: [VTOVX.broadcast] = 8.0, 8.0, 8.0, 8.0, 8.0, 9.0
; expect: [VTOVX.where_ones] = 32.0, 9.0, 9.0, 33.0, 30.0, 9.0
; expect: [VTOVX.where_zeros] = 9.0, 31.0, 35.0, 34.0, 9.0, 9.0
; expect: [VTOVX.offset_source] = 34.0, 33.0, 0.0, 0.0, 32.0, 9.0
; expect: [VTOVX.offset_list] = 30.0, 9.0, 33.0, 32.0, 9.0, 9.0
; expect: [VTOVX.short_list] = 32.0, 31.0, 9.0, 33.0, 30.0, 9.0
; expect: [VTOVX.short_source] = 0.0, 31.0, 0.0, 0.0, 30.0, 9.0
; expect: [VTOVX.nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
; The source overlaps the result: scattered elements are read again.
        descriptor va, VTOVX.next, 3
        descriptor vb, VTOVX.chain, 3
        EX      to, VTOVX.chain
        VTOVX   [va], [vb], [to]
; expect: [VTOVX.chain] = 5.0, 5.0, 5.0, 5.0
; The control vector overlaps the result: its later bits are those stored.
        descriptor va, VTOVX.places, 3
        descriptor vb, VTOVX.values, 3
        EX      vz, VTOVX.own
        EX      to, VTOVX.own
        VTOVX   [va], [vb], [to] ? [vz]
; expect: [VTOVX.own] = X'2000 0000 0000 0000', 0, 6.0
        flags_are VTOVX, X'0000 0000 0000 0000'
; VXTOV: C(i) := B(A(i))
        .data
VXTOV.a: .word   3, 0, -1, 2, 2, X'7123 0000 0000 0001'
VXTOV.table0: .word   X'7ABC 0123 4567 89AB'
VXTOV.table: .word   20.0, 21.0, 22.0, 23.0
VXTOV.scalars:
        .word   1, 1
VXTOV.chain: .word   5.0, 6.0, 7.0, 8.0
VXTOV.next: .word   1, 2, 0
        .code
        operands VXTOV.
        EX      vtable, VXTOV.table           ; its length is ignored
        of_two  VXTOV, plain, [va], [vtable], [to]
        of_two  VXTOV, where_ones, [va], [vtable], [to] ? [vz]
        of_two  VXTOV, where_zeros, [va], [vtable], [to] ?! [vz]
        of_two  VXTOV, offset_result, [va], [vtable], [to, by] ? [vz] ; also offsets the control vector
        of_two  VXTOV, short_list, [short_a], [vtable], [to] ; one result per index
        into    VXTOV.short_result, 2
        VXTOV   [va], [vtable], [to]
        into    VXTOV.nothing, 0
        VXTOV   [va], [vtable], [to]
        of_two  VXTOV, offset_list, [va, twice], [vtable], [to] ; shortens the list
; expect: [VXTOV.offset_list] = X'7ABC 0123 4567 89AB', 22.0, 22.0, 21.0, 9.0, 9.0
; expect: [VXTOV.plain] = 23.0, 20.0, X'7ABC 0123 4567 89AB', 22.0, 22.0, 21.0
; expect: [VXTOV.where_ones] = 23.0, 9.0, X'7ABC 0123 4567 89AB', 22.0, 9.0, 9.0
; expect: [VXTOV.where_zeros] = 9.0, 20.0, 9.0, 9.0, 22.0, 21.0
; expect: [VXTOV.offset_result] = 9.0, 9.0, 20.0, X'7ABC 0123 4567 89AB', 9.0, 9.0
; expect: [VXTOV.short_list] = 23.0, 20.0, X'7ABC 0123 4567 89AB', 22.0, 9.0, 9.0
; expect: [VXTOV.short_result] = 23.0, 20.0, 9.0, 9.0, 9.0, 9.0
; expect: [VXTOV.nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
; The result overlaps the table: stored elements are gathered again.
        descriptor va, VXTOV.next, 3
        EX      vtable, VXTOV.chain
        descriptor to, VXTOV.chain, 3
        VXTOV   [va], [vtable], [to]
; expect: [VXTOV.chain] = 6.0, 7.0, 6.0, 8.0
        flags_are VXTOV, X'0000 0000 0000 0000'
        EXIT
; expect-warning: zero-length
