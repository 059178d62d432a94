; stack.s - saves registers on a stack for functions that call functions.

        .ifndef stack.s
        .equ    stack.s, 1

        .include "core.s"

        .reg    stack, r207

; Reserves a stack of `words` words. It must be used once, at the start.
        .macro  begin_stack words
        .data
stack.words:
        .space  \words
        .code
        EX      stack, stack.words
        .endm

; Save and restore `count` registers from `first` on.
        .macro  push first, count
        ELEN    stack, \count
        SWAP    [r0], \first, [stack]
        IX      stack, 64 * (\count)
        .endm
        .macro  pop first, count
        IX      stack, -64 * (\count)
        ELEN    stack, \count
        SWAP    [stack], \first, [r0]
        .endm

        .endif
