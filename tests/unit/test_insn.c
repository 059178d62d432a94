/* test_insn.c - the instruction table. The fields of every instruction, each with a
 * different value, are encoded, decoded and compared. Known words are compared, too. A
 * field at another place, two instructions with the same code, or a letter of an
 * operand without a field fails here. */
#include "tests/unit/unit.h"

#include <ctype.h>

/* Checks the columns of each row, its name and its fields. */
TEST(rows)
{
    const char *of_bits = c205_operation_specials(C205_OPERATION_none);
    for (size_t i = 0; i < c205_insn_count; i++) {
        const c205_insn *insn = &c205_insns[i];
        c205_fields fields = { insn->opcode, 0x81, 0x12, 0x23, 0x34, 0x45,
                               0x56,         0x67, 0xAB, 0xBC, 0xCD, -2 };
        fields.g = (uint8_t)((fields.g & ~insn->subop_mask) | insn->subop);
        if (insn->format == C205_FORMAT_REQUEST)
            fields.immediate = 0xFE;
        if (insn->format == C205_FORMAT_JUMP)
            fields.immediate = INT64_C(0xFEDCBA987654);
        c205_word word = c205_encode(insn, &fields);
        c205_fields back = c205_decode(insn, word);
        assert_int_equal(back.f, insn->opcode);
        assert_true(c205_encode(insn, &back) == word);
        assert_ptr_equal(insn,
                         c205_insn_coded((uint8_t)(word >> 56), (uint8_t)(word >> 48)));
        if (c205_format_halves(insn->format) == 1)
            assert_int_equal(word & 0xFFFFFFFF, 0);
        assert_ptr_equal(c205_insn_named(insn->mnemonic, strlen(insn->mnemonic)), insn);
        assert_non_null(strchr("PSDR", insn->provenance));
        assert_int_equal(c205_timing_is_vector(insn->timing),
                         c205_unit_is_vector(insn->unit));
        FAIL_IF((insn->flags & C205_INSN_PADZ) && (insn->flags & C205_INSN_PADO),
                "%s is padded with zeros and ones", insn->mnemonic);
        /* Only operations on numeric operands have a rule for special values. */
        const char *rule = c205_operation_specials(insn->operation);
        bool has_numbers = strpbrk(insn->operands, "fvFV") != NULL;
        FAIL_IF(has_numbers && strcmp(rule, of_bits) == 0, "%s: numbers, but %s",
                insn->mnemonic, rule);
        FAIL_IF(!has_numbers && strcmp(rule, of_bits) != 0
                    && insn->operation != C205_OPERATION_copy,
                "%s: bits, but %s", insn->mnemonic, rule);
    }
    assert_string_equal(c205_insn_named("AdDnVx", 5)->mnemonic, "ADDNV");
    assert_null(c205_insn_named("ADDNVX", 6));
    assert_null(c205_insn_named("ADD", 3));
    assert_null(c205_insn_named("", 0));
    assert_string_equal(c205_unit_name(C205_UNIT_DIVIDE), "divide");
    assert_string_equal(c205_timing_name(C205_TIMING_vlink), "vlink");
    assert_string_equal(c205_format_name(C205_FORMAT_SIEVE), "SIEVE");
}

static c205_word encoded(const char *name, c205_fields fields)
{
    return c205_encode(c205_insn_named(name, strlen(name)), &fields);
}

static c205_fields decoded(const char *name, c205_word word)
{
    return c205_decode(c205_insn_named(name, strlen(name)), word);
}

TEST(layout)
{
    c205_fields f;
    memset(&f, 0, sizeof f);
    f.r = 1, f.s = 2, f.t = 3, f.immediate = -5;
    assert_true(encoded("addn", f) == UINT64_C(0x6201020300000000));
    assert_true(encoded("shifti", f) == UINT64_C(0x3001FB0300000000));
    assert_true(encoded("es", f) == UINT64_C(0x3E01FFFB00000000));
    assert_true(encoded("ex", f) == UINT64_C(0xBE01FFFFFFFFFFFB));
    f.immediate = 0xFF;
    assert_true(encoded("exit", f) == UINT64_C(0x090102FF00000000));
    assert_int_equal(decoded("EXIT", encoded("exit", f)).immediate, 0xFF);
    f.g = 0x88, f.x = 4, f.a = 5, f.y = 6, f.b = 7, f.z = 8, f.c = 9;
    assert_true(encoded("ADDNV", f) == UINT64_C(0x8288040506070809));
    assert_true(encoded("SQRTV", f) == UINT64_C(0x9388040500000809));
    assert_true(encoded("INTVLV", f) == UINT64_C(0xDF88000500070809));
    assert_true(encoded("LINKV", f) == UINT64_C(0x5600000000000000));
}

TEST(immediates)
{
    c205_word word = UINT64_C(0xBE01800000000000);
    assert_true(decoded("EX", word).immediate == -(INT64_C(1) << 47));
    assert_true(decoded("BIM", word).immediate == INT64_C(1) << 47);
    word = UINT64_C(0x3E017FFF00000000);
    assert_int_equal(decoded("ES", word).immediate, 32767);
    word = UINT64_C(0x300180AB00000000);
    assert_int_equal(decoded("SHIFTI", word).immediate, -128);
}

/* A relative branch has its distance in Y and B. */
TEST(relative)
{
    c205_fields f;
    memset(&f, 0, sizeof f);
    f.g = C205_G_RELATIVE;
    f.a = 1, f.x = 2, f.z = 3, f.c = 4;
    f.immediate = -258;
    c205_word word = encoded("IBXLT", f);
    assert_true(word == UINT64_C(0xB3400201FEFE0304));
    assert_int_equal(decoded("IBXLT", word).immediate, -258);
    assert_int_equal(decoded("IBXLT", word).y, 0xFE);
    assert_int_equal(decoded("IBXLT", word).b, 0xFE);
    assert_true(encoded("CFPLT", f) == UINT64_C(0xB3C00001FEFE0300));
    f.g = 0, f.y = 9, f.b = 8;
    word = encoded("IBXLT", f);
    assert_true(word == UINT64_C(0xB300020109080304));
    assert_int_equal(decoded("IBXLT", word).immediate, 0);
}

TEST(no_overlap)
{
    for (size_t i = 0; i < c205_insn_count; i++) {
        const c205_insn *a = &c205_insns[i];
        assert_int_equal(a->subop & ~a->subop_mask, 0);
        for (size_t j = 0; j < i; j++) {
            const c205_insn *b = &c205_insns[j];
            unsigned both = a->subop_mask & b->subop_mask;
            if (a->opcode == b->opcode)
                assert_int_not_equal(a->subop & both, b->subop & both);
        }
    }
    assert_null(c205_insn_coded(0x00, 0));
    assert_null(c205_insn_coded(0xFF, 0));
}

/* Returns the letters of the operand at this position, and advances it. */
static const char *allowed_letters(const char **syntax, bool *bracket)
{
    for (;; ++*syntax) {
        const char *at = *syntax;
        if (*at == '[' || *at == ']')
            *bracket = *at == '[';
        if (*at == '+') { /* an offset has no letter of its own */
            ++*syntax;
            continue;
        }
        if (*at == '@' || *at == '\0' || isalpha((unsigned char)*at))
            break;
        if (*at == '?' || *at == '!')
            return *syntax += 2, "z";
    }
    char c = *(*syntax)++;
    if (c == '\0')
        return NULL;
    if (c == '@')
        return "t";
    if (islower((unsigned char)c))
        return "vulV";
    if (c != 'I')
        return *bracket ? "ivuldeqcogxbD" : "fiwpmkFIWM";
    while (isdigit((unsigned char)**syntax))
        ++*syntax;
    return "n";
}

TEST(operand_letters)
{
    for (size_t i = 0; i < c205_insn_count; i++) {
        const c205_insn *insn = &c205_insns[i];
        const char *syntax = c205_format_syntax(insn->format);
        const char *operand = insn->operands, *letters;
        bool bracket = false;
        while ((letters = allowed_letters(&syntax, &bracket)) != NULL) {
            FAIL_IF(!*operand || !strchr(letters, *operand),
                    "%s: operand %s is not one of %s", insn->mnemonic, operand,
                    letters);
            operand++;
        }
        assert_int_equal(*operand, '\0');
    }
}
