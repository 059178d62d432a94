/* lessons.c - writes the lessons of the course, and answers the request `grade`. */
#include <string.h>

#include "asm/lesson/lesson.h"
#include "web/engine/engine_internal.h"

static void put_goals(const struct lesson_test *test, struct json *reply)
{
    if (!test->has_goals)
        return;
    json_object(reply, "goals");
    for (int i = MEDAL_GOLD; i > MEDAL_NONE; i--)
        json_count(reply, medal_name((enum medal)i), test->goals[i]);
    json_end(reply);
}

static void put_lesson(const struct lesson *lesson, struct json *reply)
{
    json_object(reply, NULL);
    json_count(reply, "number", lesson->number);
    json_text(reply, "name", lesson->name);
    json_text(reply, "title", lesson->title);
    json_text(reply, "start", lesson->start);
    json_array(reply, "tests");
    for (size_t i = 0; i < lesson->test_count; i++) {
        json_object(reply, NULL);
        json_text(reply, "name", lesson->tests[i].name);
        json_text(reply, "tries", lesson->tests[i].tries);
        json_bool(reply, "warm", lesson->tests[i].warm);
        put_goals(&lesson->tests[i], reply);
        json_end(reply);
    }
    json_end(reply);
    json_end(reply);
}

bool put_lessons(struct json *reply, c205_error *error)
{
    struct lessons lessons = { .count = 0 };
    bool good = lessons_open(&lessons, error);
    json_array(reply, "lessons");
    for (size_t i = 0; good && i < lessons.count; i++)
        put_lesson(&lessons.items[i], reply);
    json_end(reply);
    lessons_free(&lessons);
    return good;
}

/* ---- grade -------------------------------------------------------------------- */

static bool put_lesson_words(const struct lesson_verdict *verdict, struct json *reply,
                             c205_error *error)
{
    struct text_buffer text = { .text = NULL };
    struct sink sink = text_buffer_sink(&text);
    lesson_verdict_put(verdict, &sink);
    return put_buffer(reply, "words", &text, error);
}

static bool grade(const struct lesson *lesson, const char *name, const char *text,
                  struct json *reply, c205_error *error)
{
    static const struct lesson_draws no_draws;
    struct lesson_verdict verdict = { .lesson = NULL };
    bool good = lesson_grade(&verdict, lesson, no_draws, name, text, strlen(text),
                             error);
    if (good)
        lesson_verdict_json(&verdict, reply);
    good = good && put_lesson_words(&verdict, reply, error);
    lesson_verdict_free(&verdict);
    return good;
}

/* Grades a program in one slice. The limits of the tests end endless loops. */
bool answer_grade(struct engine *engine, const struct json_value *request,
                  struct json *reply, c205_error *error)
{
    const char *wanted, *name = "answer.s", *text;
    struct lessons lessons = { .count = 0 };
    const struct lesson *lesson;
    bool good = false;
    (void)engine;
    if (!take_text(request, "lesson", &wanted, error)
        || !take_text(request, "text", &text, error)
        || !take_text_or(request, "name", &name, error))
        return false;
    if (lessons_open(&lessons, error)) {
        lesson = lessons_find(&lessons, wanted, error);
        good = lesson && grade(lesson, name, text, reply, error);
    }
    lessons_free(&lessons);
    return good;
}
