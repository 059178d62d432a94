/* test_asm_records.c - the offsets that .record assigns to fields are compared with
 * those computed by hand, and wrong records with a table of their errors. A field at
 * another word, or a record that is accepted without its end, fails here.
 */
#include "tests/unit/asm_helper.h"

#include "tests/random.h"

static void assert_place(const struct object *object, const char *name, int64_t place)
{
    const struct asm_symbol *symbol = object_symbol(object, name);

    if (!symbol || symbol->is_label || symbol->value != place)
        fail_msg("%s: %ld, not %ld", name, symbol ? (long)symbol->value : -1,
                 (long)place);
}

TEST(places)
{
    SCOPED(object) *object = good(" .equ n, 2\n"
                                  " .record BALL\n"
                                  " .field BALL_CENTER, 3\n"
                                  " .field radius\n"
                                  " .field none, 0\n"
                                  " .field BALL_COLOR, 3 * n\n"
                                  " .at BALL_COLOR + 1\n"
                                  " .field BALL_GREEN\n"
                                  " .endrecord\n"
                                  " .record EMPTY\n"
                                  " .endrecord\n"
                                  " .record PADDED\n"
                                  " .field PADDED_ONE\n"
                                  " .at 16\n"
                                  " .endrecord\n"
                                  " .equ radius, 3\n"
                                  " .word BALL_SIZE\n");

    assert_place(object, "BALL_CENTER", 0);
    assert_place(object, "radius", 3);
    assert_place(object, "none", 4);
    assert_place(object, "BALL_COLOR", 4);
    assert_place(object, "BALL_GREEN", 5);
    assert_place(object, "BALL_SIZE", 10);
    assert_place(object, "EMPTY_SIZE", 0);
    assert_place(object, "PADDED_ONE", 0);
    assert_place(object, "PADDED_SIZE", 16);
    assert_null(object_symbol(object, "BALL"));
    assert_int_equal(object->program.segment_count, 1);
    assert_int_equal(word_of(&object->program, 0x400000), 10);
}

/* A random record: its text, and the expected offsets of its fields. */
enum { MAX_FIELDS = 30 };
struct random_record {
    size_t count;
    int64_t place[MAX_FIELDS], size;
    char text[4096];
};

static void say(struct random_record *record, const char *format, int64_t a, int64_t b)
{
    size_t used = strlen(record->text);

    snprintf(record->text + used, sizeof record->text - used, format, (long)a, (long)b);
}

/* Adds fields of random sizes. Some .at directives return to an earlier field or skip
 * words. */
static void make_record(struct random_record *record, uint64_t *seed)
{
    int64_t next = 0;

    memset(record, 0, sizeof *record);
    say(record, " .record R\n", 0, 0);
    while (record->count < MAX_FIELDS) {
        int64_t words = xorshift_between(seed, 0, 19);
        int64_t choice = xorshift_between(seed, 0, 7);

        if (choice == 0 && record->count > 0) {
            size_t field = xorshift(seed) % record->count;
            next = record->place[field];
            say(record, " .at f%ld\n", (int64_t)field, 0);
        } else if (choice == 1) {
            next += words;
            say(record, " .at %ld\n", next, 0);
        } else {
            record->place[record->count] = next;
            next += choice == 2 ? 1 : words;
            say(record, choice == 2 ? " .field f%ld\n" : " .field f%ld, %ld\n",
                (int64_t)record->count++, words);
        }
        record->size = next > record->size ? next : record->size;
    }
    say(record, " .endrecord\n", 0, 0);
}

TEST(random_records)
{
    uint64_t seed = RANDOM_SEED;

    for (size_t i = 0; i < 300; i++) {
        struct random_record record;
        char name[16];
        make_record(&record, &seed);
        SCOPED(object) *object = good(record.text);
        for (size_t field = 0; field < record.count; field++) {
            snprintf(name, sizeof name, "f%zu", field);
            assert_place(object, name, record.place[field]);
        }
        assert_place(object, "R_SIZE", record.size);
    }
}

static const struct asm_error wrong_texts[] = {
    { " .record\n", 1, 9, "expected the record's name" },
    { " .record a\n", 1, 2, "no .endrecord" },
    { " .record a b\n .endrecord\n", 1, 12, "the end of the statement" },
    { " .record a\n .record b\n .endrecord\n", 2, 2,
      "expected .endrecord first, for the .record in test.s:1" },
    { " .endrecord\n", 1, 2, "expected .record before this line" },
    { " .field a\n", 1, 2, "expected .record before this line" },
    { " .at 5\n", 1, 2, "expected .record before this line" },
    { " .record a\n .endrecord\n .field b\n", 3, 2, "expected .record before" },
    { " .record a\n .field 5\n .endrecord\n", 2, 9, "the field's name" },
    { " .record a\n .field b, -1\n .endrecord\n", 2, 12, "from 0 to" },
    { " .record a\n .field b 2\n .endrecord\n", 2, 11, "the end" },
    { " .record a\n .field b, 70000000\n .endrecord\n", 2, 12,
      "a number of words from 0 to 67108864" },
    { " .record a\n .field b, 60000000\n .field c, 60000000\n"
      " .endrecord\n",
      3, 12, "from 0 to 7108864" },
    { " .record a\n .field b, later\n .endrecord\nlater: EXIT\n", 2, 12,
      "not defined before" },
    { " .record a\n .at -1\n .endrecord\n", 2, 6, "a position in the record" },
    { " .record a\n .field b\n .field b\n .endrecord\n", 3, 9,
      "'b' is already defined, in test.s:2" },
    { " .equ a_SIZE, 5\n .record a\n .field b\n .endrecord\n", 4, 2,
      "'a_SIZE' is already defined, in test.s:1" },
};

TEST_CALL(errors, assert_asm_errors(wrong_texts, COUNT(wrong_texts)))
