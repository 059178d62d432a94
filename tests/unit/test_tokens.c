/* test_tokens.c - the tokens that are recorded for macros and loops are compared with
 * tokens that a lexer reads again, for random texts and all starts and ends of a body.
 * A token that is lost or has another position fails here. */
#include "rt/scene/language/token.h"
#include "tests/unit/unit.h"

#include "tests/unit/draw.h"

enum { TEXTS = 200, CUTS = 60, PIECES = 40, MAX_TEXT = 200 };

/* Makes a text of pieces whose tokens depend on the following pieces. */
static void draw_text(char *text)
{
    static const char *const pieces[] = { "1",  "1e",   "e",    "+", "5",   ".",  "<",
                                          "=",  ">",    "!",    "/", "*",   "/*", "*/",
                                          "//", "\n",   " ",    "a", "end", "#",  "\"",
                                          "\\", "\x01", "1e+5", "{", "}" };
    text[0] = '\0';
    for (size_t i = 0; i < PIECES; i++)
        strcat(text, pieces[below(COUNT(pieces))]);
}

static struct text_place place_of(const struct scene_source *source, size_t at)
{
    struct text_place place = { 0, 1, 0 };
    for (; place.at < at; place.at++)
        if (source->text[place.at] == '\n') {
            place.line++;
            place.line_at = place.at + 1;
        }
    return place;
}

static void assert_same(const struct scene_token *a, const struct scene_token *b,
                        const char *text)
{
    FAIL_IF(a->kind != b->kind || a->source != b->source || a->text != b->text
                || a->length != b->length || a->sign != b->sign || a->depth != b->depth
                || a->main_line != b->main_line || a->fault != b->fault
                || memcmp(&a->number, &b->number, sizeof a->number) != 0
                || memcmp(&a->place, &b->place, sizeof a->place) != 0,
            "'%.*s' at %zu is kept as '%.*s' of\n%s", (int)a->length, a->text,
            a->place.at, (int)b->length, b->text, text);
}

/* Compares all tokens of a body. Sometimes goes back to an earlier token. */
static void compare(struct lexer *keeping, struct lexer *fresh,
                    const struct scene_source *source, size_t from, size_t end)
{
    struct text_place place = place_of(source, from);
    struct scene_token call = { .kind = TOKEN_WORD }, kept;
    assert_true(lexer_call(keeping, source, place, end, &call));
    do {
        struct text_place back = lexer_top(keeping)->place;
        memset(fresh->kept, 0, sizeof fresh->kept);
        assert_true(lexer_call(fresh, source, back, end, &call));
        kept = lexer_next(keeping);
        struct scene_token read = lexer_next(fresh);
        assert_same(&read, &kept, source->text);
        assert_memory_equal(&lexer_top(fresh)->place, &lexer_top(keeping)->place,
                            sizeof back);
        if (below(4) == 0) {
            lexer_jump(keeping, &back);
            kept = lexer_next(keeping);
            assert_same(&read, &kept, source->text);
        }
        lexer_close(fresh);
    } while (kept.kind != TOKEN_END);
    lexer_close(keeping);
}

TEST(any_cut)
{
    FREED struct lexer *keeping = NON_NULL(calloc(1, sizeof *keeping));
    FREED struct lexer *fresh = NON_NULL(calloc(1, sizeof *fresh));
    struct scene_source *sources = NULL;
    for (size_t i = 0; i < TEXTS; i++) {
        char text[MAX_TEXT];
        draw_text(text);
        struct scene_source *source = NON_NULL(
            source_add(&sources, "drawn", text, strlen(text), &failure));
        if (i % 2) { /* otherwise the body belongs to the main file */
            assert_true(lexer_open(keeping, source));
            assert_true(lexer_open(fresh, source));
        }
        for (size_t k = 0; k < CUTS; k++) {
            size_t from = below(source->length);
            compare(keeping, fresh, source, from,
                    from + below(source->length - from + 1));
        }
        if (i % 2) {
            lexer_close(keeping);
            lexer_close(fresh);
        }
    }
    sources_free(sources);
}
