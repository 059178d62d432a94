/* test_asm_records.c - the offsets that .record assigns to fields are compared with
 * offsets computed by hand, and wrong records with a table of their errors. A field at
 * another word, or a record that is accepted without its end, fails here. */
#include "tests/unit/asm_helper.h"

#include "tests/random.h"

static void assert_place(const struct object *object, const char *name, int64_t place)
{
    const struct asm_symbol *symbol = object_symbol(object, name);
    FAIL_IF(!symbol || symbol->is_label || symbol->value != place, "%s: %ld, not %ld",
            name, symbol ? (long)symbol->value : -1, (long)place);
}

TEST(places)
{
    static const struct {
        const char *name;
        int64_t place;
    } places[] = {
        { "none", 4 },       { "BALL_GREEN", 5 }, { "PADDED_ONE", 0 },
        { "radius", 3 },     { "BALL_SIZE", 10 }, { "BALL_CENTER", 0 },
        { "BALL_COLOR", 4 }, { "EMPTY_SIZE", 0 }, { "PADDED_SIZE", 16 },
    };
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
    for (size_t i = 0; i < COUNT(places); i++)
        assert_place(object, places[i].name, places[i].place);
    assert_null(object_symbol(object, "BALL"));
    assert_int_equal(object->program.segment_count, 1);
    assert_int_equal(word_of(&object->program, 0x400000), 10);
}

/* A random record: its text, and the expected offsets of its fields. */
enum { MAX_FIELDS = 30 };
struct random_record {
    size_t count;
    int64_t place[MAX_FIELDS], size;
    struct text_buffer text;
};

/* Adds fields of random sizes. Some .at directives go back or skip words. */
static void make_record(struct random_record *record, uint64_t *seed)
{
    struct sink text = text_buffer_sink(&record->text);
    int64_t next = 0;
    sink_print(&text, " .record R\n");
    while (record->count < MAX_FIELDS) {
        int64_t words = xorshift_between(seed, 0, 19);
        int64_t choice = xorshift_between(seed, 0, 7);
        if (choice == 0 && record->count > 0) {
            size_t field = xorshift(seed) % record->count;
            next = record->place[field];
            sink_print(&text, " .at f%zu\n", field);
        } else if (choice == 1) {
            next += words;
            sink_print(&text, " .at %ld\n", (long)next);
        } else {
            record->place[record->count] = next;
            next += choice == 2 ? 1 : words;
            sink_print(&text, " .field f%zu", record->count++);
            if (choice != 2)
                sink_print(&text, ", %ld", (long)words);
            sink_print(&text, "\n");
        }
        record->size = next > record->size ? next : record->size;
    }
    sink_print(&text, " .endrecord\n");
}

TEST(random_records)
{
    uint64_t seed = RANDOM_SEED;
    for (size_t i = 0; i < 300; i++) {
        struct random_record record = { 0 };
        make_record(&record, &seed);
        SCOPED(object) *object = good(record.text.text);
        for (size_t field = 0; field < record.count; field++)
            assert_place(object, formatted("f%zu", field), record.place[field]);
        assert_place(object, "R_SIZE", record.size);
        text_buffer_free(&record.text);
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
    { " .record a\n .field b, 60000000\n .field c, 60000000\n .endrecord\n", 3, 12,
      "from 0 to 7108864" },
    { " .record a\n .field b, later\n .endrecord\nlater: EXIT\n", 2, 12,
      "not defined before" },
    { " .record a\n .at -1\n .endrecord\n", 2, 6, "a position in the record" },
    { " .record a\n .field b\n .field b\n .endrecord\n", 3, 9,
      "'b' is already defined, in test.s:2" },
    { " .equ a_SIZE, 5\n .record a\n .field b\n .endrecord\n", 4, 2,
      "'a_SIZE' is already defined, in test.s:1" },
};

TEST_CALL(errors, assert_asm_errors(wrong_texts, COUNT(wrong_texts)))
