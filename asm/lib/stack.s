; stack.s - registers kept on a stack, by functions that call others or themselves.

        .ifndef stack.s
        .equ    stack.s, 1

        .include "core.s"

        .reg    stack, r207

; Once, at the beginning: room for so many words.
        .macro  begin_stack words
        .data
stack.words:
        .space  \words
        .code
        EX      stack, stack.words
        .endm

; So many registers, from the first on, to the stack and back.
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
