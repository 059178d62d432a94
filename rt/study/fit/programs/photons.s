; photons.s - photons in a slab by the Monte Carlo method, one after the other
; and all at a time.
;
; Photons enter at x = 0 along the axis of a slab.  Each flies a distance
; -ln u1, is reflected or transmitted if it leaves the slab there, is absorbed
; with the probability 1 - SURVIVAL, or else flies on in a direction whose
; cosine is 2 u3 - 1.  Every photon draws its numbers from a row of its own, so
; that all forms do the same operations on the same numbers and their tallies
; agree.
;
; Three forms, each a region: scalar, a FORTRAN program with its calls
; (photons_scalar.inc); in_registers, the same without (photons_registers.inc);
; vector (photons_vector.inc).  Published is, for the vector form of GAMTEB, 15
; to 18 times the speed of its scalar one.  Per flight that program does more
; than this one, which is little but draws and a logarithm.
;
; Sources: F. B. Brown and W. R. Martin, Monte Carlo methods for radiation
; transport analysis on vector computers, Prog. Nucl. Energy 14 (1984), of the
; method; Vectorization of Monte Carlo particle transport: an architectural
; study using the LANL benchmark GAMTEB, Supercomputing 1989 (the abstract), of
; the ratio.

        .include "frame/linkage.s"
        .include "photons.inc"

        .equ    APART, 1025     ; draws from the row of one to that of the next, odd

        .data
seeds:          .space PHOTONS
        .code

; The tallies of the three forms, and where these return to.
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
        load_at photon_constants, PHOTON_CONSTANTS, offset
        stream_load at
        stream_vector_load
        ES      minus, -1

; jump := a to the power APART; the seeds are its powers.
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

        load_at common_tallies, 3, reflected
        ES      failed, 1
        compare reflected
        compare transmitted
        compare absorbed
        ES      failed, 0
differs:
        EXIT    failed
; expect: failed = 0
