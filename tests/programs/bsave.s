; BSAVE: R := address of the next instruction; go to T + 32 S

        .regs   r10, link, target, sum, two, halves, here

; a call and the return from it, twice
        ES      two, 2
        EX      target, routine
        BSAVE   link, [target]
first_return:
        EX      target, routine - 96
        ES      halves, 3
        BSAVE   link, [target, halves]
second_return:
; expect: r12 = 4
; expect: r10 = second_return

; the target may be in the register that gets the link
        EX      here, past
        BSAVE   here, [here]
linked: ES      sum, 0
past:
; expect: r15 = linked

        EX      target, last
        BSAVE   r0, [target]            ; no link is kept
        ES      sum, 0
last:
; expect: r0 = 0

        EXIT

routine:
        ADDX    sum, two, sum
        BSAVE   r0, [link]
