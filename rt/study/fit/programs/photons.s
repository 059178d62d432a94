; photons.s - simulates photons in a slab by the Monte Carlo method, one photon
; at a time and all photons at the same time.
;
; Photons enter at x = 0 along the axis of a slab.  Each photon flies a distance
; -ln u1.  If it leaves the slab, it is reflected or transmitted.  Else it is
; absorbed with the probability 1 - SURVIVAL, or it continues in a direction
; whose cosine is 2 u3 - 1.  Every photon has its own sequence of random
; numbers, so all forms do the same operations on the same numbers and their
; tallies agree.
;
; There are three forms, each in a region: scalar, a FORTRAN program with its
; calls (photons_scalar.inc); in_registers, the same without calls
; (photons_registers.inc); vector (photons_vector.inc).  The published speedup
; of the vector form of GAMTEB over its scalar form is 15 to 18.  GAMTEB does
; more work per flight; here a flight is mainly random numbers and a logarithm.
;
; Sources: F. B. Brown and W. R. Martin, Monte Carlo methods for radiation
; transport analysis on vector computers, Prog. Nucl. Energy 14 (1984), for the
; method; Vectorization of Monte Carlo particle transport: an architectural
; study using the LANL benchmark GAMTEB, Supercomputing 1989 (abstract), for the
; ratio.

        .include "frame/linkage.s"
        .include "photons.inc"

        .equ    APART, 1025     ; distance of two sequences in the stream, odd

        .data
seeds:          .space PHOTONS
        .code

; The tallies of the three forms, and the return address.
        .share  main
        .regs   r20, reflected, transmitted, absorbed
        .regs   r23, reflected_r, transmitted_r, absorbed_r
        .regs   r26, reflected_v, transmitted_v, absorbed_v
        .regs   r29, back, failed
        .endshare
        .reg    jump, r31

        .include "photons_scalar.inc"
        .include "photons_registers.inc"
        .include "photons_vector.inc"

        .macro  run form
        EX      target, \form
        BSAVE   back, [target]
        .endm

        .macro  compare tally
        IBXNE   \tally, r0, \tally\()_r, differs
        IBXNE   \tally, r0, \tally\()_v, differs
        .endm

        .entry  photons
photons:
        load_words photon_constants, PHOTON_CONSTANTS, offset
        stream_load at
        stream_vector_load
        ES      minus, -1

; jump := a^APART.  The seeds are the powers of jump.
        ES      count, APART
        stream_power count, jump, seed, at
        EX      at, seeds
        ES      count, PHOTONS
        ES      seed, 1
sow:    MPYL    seed, jump, seed
        STO     [at], seed
        IX      at, 64
        IBXNE   count, minus, r0, sow, count

        run     one_by_one
        run     by_hand
        run     all_at_a_time

        load_words common_tallies, 3, reflected
        ES      failed, 1
        compare reflected
        compare transmitted
        compare absorbed
        ES      failed, 0
differs:
        EXIT    failed
; expect: failed = 0
