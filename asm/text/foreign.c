/* foreign.c - the mnemonics of other machines, and what this machine has instead. */
#include "asm/text/suggest.h"

#include <ctype.h>
#include <string.h>

#define EXCHANGE(mnemonic) "exchange the sources and use " mnemonic

static const struct {
    const char *names; /* each followed by a blank */
    const char *advice;
} foreign[] = {
    { "ADD FADD PLUS ", "ADDN adds numbers, ADDX adds integers" },
    { "SUB FSUB MINUS ", "SUBN subtracts numbers, SUBX subtracts integers" },
    { "MUL MULT MPY FMUL TIMES ", "MPYS multiplies numbers, MPYX multiplies integers" },
    { "DIV FDIV IDIV ", "DIVS divides numbers; TRU of its result is an integer" },
    { "INC ADDI ", "IS adds a constant to a register" },
    { "DEC SUBI ", "IS adds a constant, which may be negative, to a register" },
    { "NEG ", "SUBN with r0 as its first source changes the sign" },
    { "VADD ADDV ", "ADDNV adds vectors in memory" },
    { "VSUB SUBV ", "SUBNV subtracts vectors in memory" },
    { "VMUL MULV MPYV ", "MPYSV multiplies vectors in memory" },
    { "VDIV DIVV ", "DIVSV divides vectors in memory" },
    { "MOV MOVE MV COPY CPY ",
      "RTOR copies a register, ES and EX set it to a constant, VTOV copies a vector" },
    { "MVI MOVI LI LDI LA LEA SET ",
      "ES sets a register to a constant, EX sets it to an address" },
    { "LD LDR LW LDA LOAD FLD ", "LOD [address, index], register loads a word" },
    { "ST STR SW STA STORE FST ", "STO [address, index], register stores a word" },
    { "VLD LDV LV VST STV SV ",
      "a vector instruction reads and writes memory, so vectors are neither loaded nor "
      "stored" },
    { "JMP JUMP JP J BR BRA B GOTO ", "BIM branches to an address" },
    { "CALL JSR BL BAL JAL ",
      "BSAVE calls a routine, as does the macro call of core.s" },
    { "RET RTS RETURN BX ",
      "BIM 0, register returns to a saved address, as does the macro return of core.s" },
    { "LOOP DJNZ ", "DBNZ subtracts 1 from a register and branches while it is not 0" },
    { "HALT HLT STOP END QUIT ", "EXIT ends the program" },
    { "NOP NOOP PASS ",
      "no instruction without effect exists, because the machine waits for its operands" },
    { "PUSH POP ", "the macros push and pop of stack.s save registers" },
    { "PRINT WRITE ", "the macros of print.s print numbers and vectors" },
    { "SHL SHR SLL SRL SRA LSL LSR ASR ROL ",
      "SHIFTI shifts a register by a constant" },
    { "CMP TEST FCMP ",
      "BEQ, BNE, BGE and BLT compare and branch, CMPEQV and its kind compare vectors" },
    { "CMPEQ CMPNE CMPGE CMPLT ",
      "CFP.. compares registers and branches, CMP..V compares vectors" },
    { "CMPGT CMPLE ",
      "CFPGT and CFPLE compare registers and branch; for vectors, exchange the sources "
      "and use CMPLTV or CMPGEV" },
    { "BGT ", EXCHANGE("BLT") },
    { "BLE ", EXCHANGE("BGE") },
    { "BHGT ", EXCHANGE("BHLT") },
    { "BHLE ", EXCHANGE("BHGE") },
    { "CMPGTV ", EXCHANGE("CMPLTV") },
    { "CMPLEV ", EXCHANGE("CMPGEV") },
    { "SELGTV ", EXCHANGE("SELLTV") },
    { "SELLEV ", EXCHANGE("SELGEV") },
    { "SCHGTV ", EXCHANGE("SCHLTV") },
    { "SCHLEV ", EXCHANGE("SCHGEV") },
    { "BEQZ BZ JZ JE BNEZ BNZ JNZ JNE ",
      "BEQ and BNE compare two registers and branch; r0 is 0" },
};

static bool is_same(const char *a, const char *b, size_t length)
{
    for (size_t i = 0; i < length; i++)
        if (toupper((unsigned char)a[i]) != toupper((unsigned char)b[i]))
            return false;
    return true;
}

const char *foreign_advice(const char *name, size_t length)
{
    for (size_t i = 0; i < sizeof foreign / sizeof *foreign; i++)
        for (const char *at = foreign[i].names; *at; at = strchr(at, ' ') + 1)
            if (strcspn(at, " ") == length && is_same(at, name, length))
                return foreign[i].advice;
    return NULL;
}
