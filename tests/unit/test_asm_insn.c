/* test_asm_insn.c - instructions are compared with their encodings, from text to word
 * and back, for tables of examples, random words and every row of the instruction
 * table. A field at another place, or a word whose text does not restore it, fails
 * here. */
#include "tests/unit/asm_helper.h"

#include "asm/object/disassemble.h"
#include "tests/random.h"

static const char names[] = " .regs r16, a, x, b, y, c, o, z, s\n"
                            " .reg c2, c\n .regs h50, h, i, j\n";

static c205_word encoding(const char *instruction)
{
    SCOPED(object) *object = good(formatted("%sback: %s\nnext:\n", names, instruction));
    return word_of(&object->program, 0x400000);
}

TEST(encodings)
{
    static const struct {
        const char *text;
        c205_word word;
    } cases[] = { { "ADDN a, b, c", 0x6210121400000000 },
                  { "addn r1, R2, r3", 0x6201020300000000 },
                  { "SQRT a, b", 0x7310001200000000 },
                  { "LOD [a], c", 0x7E10001400000000 },
                  { "LOD [a, x], c", 0x7E10111400000000 },
                  { "SWAP [a], r32, [c]", 0x7D10201400000000 },
                  { "BEQ a, b, [c]", 0x2410121400000000 },
                  { "BSAVE a, [b]", 0x3610001200000000 },
                  { "BSAVE a, [b, x]", 0x3610111200000000 },
                  { "SHIFTI a, -64, c", 0x3010C01400000000 },
                  { "CNTOB [a], s", 0x1F10001700000000 },
                  { "EXIT", 0x0900000000000000 },
                  { "EXIT a", 0x0910000000000000 },
                  { "EXIT a, b, 255", 0x091012FF00000000 },
                  { "ES a, -1", 0x3E10FFFF00000000 },
                  { "ELEN a, 65535", 0x2A10FFFF00000000 },
                  { "EX a, X'8000 0000 0000'", 0xBE10800000000000 },
                  { "EX a, -1", 0xBE10FFFFFFFFFFFF },
                  { "EX a, next", 0xBE10000000400040 },
                  { "BIM next", 0xB600000000400040 },
                  { "BIM 64, a", 0xB610000000000040 },
                  { "IBXLT a, x, z, back, c", 0xB340111000001614 },
                  { "IBXLT a, x, z, next", 0xB340111000021600 },
                  { "IBXLT a, x, z, [y, b], c", 0xB300111013121614 },
                  { "IBXLT a, x, z, [y]", 0xB300111013001600 },
                  { "IBXEQ a, x, z, 0x3FFFE0, c", 0xB0401110FFFF1614 },
                  { "CFPGE a, z, next", 0xB2C0001000021600 },
                  { "CFPGE a, z, [y, b]", 0xB280001013121600 },
                  { "ADDNV [a], [b], [c]", 0x8200001000120014 },
                  { "ADDNV a, [b], [c]", 0x8210001000120014 },
                  { "ADDNV [a], b, [c]", 0x8208001000120014 },
                  { "ADDNV [a, x], [b, y], [c, o]", 0x8220111013120014 },
                  { "ADDNV [a], [b], [c] ? [z]", 0x8200001000121614 },
                  { "ADDNV [a], [b], [c, o] ?! [z]", 0x8260001000121614 },
                  { "ADDNV -[a], [b], [c]", 0x8202001000120014 },
                  { "ADDNV |[a]|, |[b]|, [c]", 0x8205001000120014 },
                  { "ADDNV -|a|, |b|, [c]", 0x821F001000120014 },
                  { "ORNV [a], b, [c]", 0x9D0D001000120014 },
                  { "INTVLV a, b, [c]", 0xDF00001000120014 },
                  { "SUMV [a], c ? [z]", 0xDA00001000001614 },
                  { "CPSV [a], [c] ? [z]", 0xBC00001000001614 },
                  { "CPSV a, [c] ?! [z]", 0xBC50001000001614 },
                  { "ACPSV [a], b, [c], [z]", 0xCF08001000121614 },
                  { "VXTOV [a], [b], [c, o]", 0xBA20001000120014 },
                  { "VTOVX [a], b, [c]", 0xB708001000120014 },
                  { "VGATHP a, [b], [c, o] ?! [z]", 0xB960001000121614 },
                  { "VSCATP a, [b, y], [c] ? [z]", 0xCC00001013121614 },
                  { "XORB [a], [b], [c]", 0xF000001000120014 },
                  { "LINKV", 0x5600000000000000 },
                  { "ADDNH h, h255, i", 0x4232FF3300000000 },
                  { "RTORH h0, H9", 0x5800000900000000 },
                  { "CON a, h", 0x7610003200000000 },
                  { "EXTH i, a", 0x5C33001000000000 },
                  { "LODH [a, x], j", 0x5E10113400000000 },
                  { "STOH [a], h", 0x5F10003200000000 },
                  { "BHLT h, i, [c]", 0x2332331400000000 },
                  { "EXH h, -1", 0xCD32FFFFFF000000 },
                  { "IXH h3, X'800000'", 0xCE03800000000000 },
                  { "WJTIME a", 0x3A10000000000000 },
                  { "RJTIME a", 0x3700001000000000 },
                  { "ADDNV,H [a], [b], [c]", 0x8280001000120014 },
                  { "addnv,h -|h|, [b, y], [c, o] ?! [z]", 0x82F6003213121614 },
                  { "ANDV,H [a], j, [c]", 0x9D89001000340014 },
                  { "INTVLV,H h, i, [c]", 0xDF80003200330014 },
                  { "SUMV,H [a], h ? [z]", 0xDA80001000001632 },
                  { "MAXV,H [a], s, h254", 0xD8800010001700FE },
                  { "SELEQV,H [a], h, s", 0xC088001000320017 },
                  { "SCHEQV,H h, [b], [c, o]", 0xC8B0003200120014 },
                  { "VXTOV,H [a], [b], [c]", 0xBA80001000120014 },
                  { "VTOVX,H [a], h, [c]", 0xB788001000320014 },
                  { "ADDNS [a, x], [b, y], [c], [z]", 0xA200111013121614 },
                  { "ADDNS,H [a, x], [b, y], [c] ? [z]", 0xA2A0111013121614 },
                  { "ADDNS |[a, x]|, |[b, y]|, [c] ? [z]",
                    0xA220111013121614
                        | (uint64_t)(C205_G_MAGNITUDE_A | C205_G_MAGNITUDE_B) << 48 },
                  { "VGATHP,H a, [b], [c]", 0xB980001000120014 },
                  { "VSCATP,H a, [b], [c]", 0xCC80001000120014 },
                  { "CPSV,H h, [c] ? [z]", 0xBC90003200001614 },
                  { "CONV s, [c, o]", 0x9630001700000014 },
                  { "EXTV -h, [c]", 0x9C12003200000014 } };
    for (size_t i = 0; i < COUNT(cases); i++)
        FAIL_IF(encoding(cases[i].text) != cases[i].word, "%s: %016llX", cases[i].text,
                (unsigned long long)encoding(cases[i].text));
}

TEST(errors)
{
    static const struct {
        const char *text;
        size_t column;
        const char *message;
    } cases[] = { { "ADDM a, b, c", 1, "an instruction or a macro" },
                  { "ADDN a, b", 10, "','" },
                  { "ADDN a, b, c, z", 13, "the end of the statement" },
                  { "ADDN [a], b, c", 6, "without brackets" },
                  { "ADDN a, b, 5", 12, "a register" },
                  { "ADDN a, b, r256", 12, "a register" },
                  { "ADDN a, b, nowhere", 12, "a register" },
                  { "LOD a, c", 5, "'['" },
                  { "LOD [a, x, x], c", 10, "']'" },
                  { "BEQ a, b, [c, o]", 13, "no offset" },
                  { "ADDNV [a], -[b], [c]", 12, "only the first source" },
                  { "ANDV -[a], [b], [c]", 6, "no sign control" },
                  { "ANDV [a], |[b]|, [c]", 11, "no sign control" },
                  { "ADDNV |[a], [b], [c]", 11, "'|'" },
                  { "ADDNV [a], [b], c", 17, "'['" },
                  { "ADDNV [a], [b], [c, y]", 21, "expected r21" },
                  { "ADDNV 5, [b], [c]", 7, "a vector [..] or a register" },
                  { "ADDNV [a], [b], [c] [z]", 21, "a control vector" },
                  { "ADDNV [a], [b], [c] ? z", 23, "'['" },
                  { "CPSV [a], [c]", 14, "a control vector" },
                  { "VXTOV [a], [b, x], [c]", 14, "no offset" },
                  { "ADDNS [a, x], [b, y], [c, o], [z]", 25, "no offset" },
                  { "ADDNS [a, x], [b, y], [c] [z]", 27, "',' or '?'" },
                  { "ADDNS [a, x], [b, y], [c] ?! [z]", 28, "'['" },
                  { "ES a, 65536", 7, "from -32768 to 65535" },
                  { "ES a, -32769", 7, "from -32768 to 65535" },
                  { "ES a, 1.5", 7, "an integer" },
                  { "SHIFTI a, 64, c", 11, "from -64 to 63" },
                  { "EXIT a, b, 256", 12, "from 0 to 255" },
                  { "BIM -1", 5, "from 0 to" },
                  { "IBXLT a, x, z, 0x700000, c", 1, "half words away" },
                  { "IBXLT a, x, z, 0x500000, c", 1, "half words away" },
                  { "IBXLT a, x, z, 0x2FFFE0, c", 1, "half words away" },
                  { "IBXLT a, x, z, 0x400010, c", 1, "on a half word" },
                  { "ADDN a, h, c", 9,
                    "a whole register, r0 .. r255, found the half register h50" },
                  { "ADDNH h, i, a", 13,
                    "a half register, h0 .. h255, found the whole register r16" },
                  { "ADDNH h, i, h256", 13, "a register" },
                  { "ADDNV [a], h, [c]", 12, "a whole register" },
                  { "ADDNV,H [a], b, [c]", 14, "a half register" },
                  { "ADDNV,H [h], [b], [c]", 10, "a whole register" },
                  { "SUMV,H [a], s", 13, "a half register" },
                  { "SELEQV,H [a], [b], h", 20, "a whole register" },
                  { "ADDNV,H [a, h], [b], [c]", 13, "a whole register" },
                  { "ADDNV,H [a], [b], [c] ? [h]", 26, "a whole register" },
                  { "VXTOV,H [h], [b], [c]", 10, "a whole register" },
                  { "CONV h, [c]", 6, "a whole register" },
                  { "EXTV s, [c]", 6, "a half register" },
                  { "LINKV,H", 6, "LINKV has no form with ,H" },
                  { "ADDNH,H h, i, j", 6, "ADDNH has no form with ,H" },
                  { "ADDNV,Q [a], [b], [c]", 7, "expected H, for 32-bit operands" },
                  { "EXH h, 0x1000000", 8, "from -8388608 to 16777215" },
                  { "SUMV [a], s", 11, "an even register" },
                  { "SUMV,H [a], h255", 13, "an even register" },
                  { "ADDNV [a], [b], [r255, r0]", 17, "r255 is the last register" },
                  { "SUMV a, c", 6, "a source must be a vector" },
                  { "SELEQV a, b, s", 8, "a source must be a vector" },
                  { "ACPSV a, b, [c], [z]", 7, "a source must be a vector" },
                  { "ADDNV [a], [b], [c] ? [r0]", 23, "r0 cannot be a control vector" },
                  { "CPSV [a], [c] ?! [r0]", 18, "r0 cannot be a control vector" } };
    for (size_t i = 0; i < COUNT(cases); i++) {
        char text[300];
        snprintf(text, sizeof text, "%s%s\n", names, cases[i].text);
        assert_asm_errors(&(struct asm_error){ text, 4, cases[i].column,
                                               cases[i].message },
                          1);
    }
}

/* Disassembles a word and assembles the text again, which must give the word. */
static void check_round_trip(c205_word word)
{
    char one[DISASSEMBLE_TEXT_SIZE], text[DISASSEMBLE_TEXT_SIZE + 40];
    uint64_t address = 0x40000000;
    unsigned halves = disassemble_one(word, address, one);
    snprintf(text, sizeof text, " .org 0x40000000\n %s\n", one);
    SCOPED(object) *object = good(text);
    c205_word made = word_of(&object->program, address);
    if (halves == 1)
        word &= 0xFFFFFFFF00000000;
    FAIL_IF(made != word, "%s", one);
}

TEST(round_trip)
{
    uint64_t seed = 205;
    for (size_t i = 0; i < c205_insn_count; i++) {
        const c205_insn *insn = &c205_insns[i];
        for (int j = 0; j < 100; j++) {
            c205_word word = xorshift(&seed);
            word = word << 8 >> 8 | (c205_word)insn->opcode << 56;
            word &= ~((c205_word)insn->subop_mask << 48);
            word |= (c205_word)insn->subop << 48;
            if (j % 2) /* fewer one-bits, so that more words are valid instructions */
                word &= 0xFFFF00FF00FFFFFF;
            check_round_trip(word);
        }
    }
    for (int j = 0; j < 2000; j++)
        check_round_trip(xorshift(&seed));
}

/* Fails unless a row disassembles to its mnemonic in a size that it supports. */
static void check_written(const c205_insn *insn, uint8_t g)
{
    c205_fields fields = { insn->opcode, 0, 0, 7, 0, 8, 9, 10, 7, 8, 10, 3 };
    char text[DISASSEMBLE_TEXT_SIZE];
    fields.g = (uint8_t)(insn->subop | g);
    c205_word word = c205_encode(insn, &fields);
    disassemble_one(word, 0x40000000, text);
    FAIL_IF(strncmp(text, insn->mnemonic, strlen(insn->mnemonic)) != 0
                || (strstr(text, ",H") != NULL) != (g != 0),
            "%s: %s", insn->mnemonic, text);
    check_round_trip(word);
}

TEST(sizes)
{
    for (size_t i = 0; i < c205_insn_count; i++) {
        check_written(&c205_insns[i], 0);
        if (c205_insns[i].flags & C205_INSN_HALF)
            check_written(&c205_insns[i], C205_G_HALF);
    }
}

/* Words that no machine executes are not disassembled to instructions. */
TEST(refused)
{
    static const c205_word words[] = {
        0xDA10001000000014, /* SUMV r16, r20 */
        0xC018001000120017, /* SELEQV r16, r18, r23 */
        0xD810001000170014, /* MAXV r16, r23, r20 */
        0xDA00001000000017, /* SUMV [r16], r23 */
        0x82200010001200FF, /* ADDNV [r16], [r18], [r255, r0] */
        0x8240001000120014, /* ADDNV [r16], [r18], [r20] ?! [r0] */
        0xBC00001000000014, /* CPSV [r16], [r20] ? [r0] */
        0xF080001000120014  /* XORB with 32-bit operands */
    };
    char text[DISASSEMBLE_TEXT_SIZE];
    for (size_t i = 0; i < COUNT(words); i++) {
        assert_int_equal(disassemble_one(words[i], 0, text), 1);
        assert_memory_equal(text, ".half", 5);
    }
}
