/* test_dap_values.c - the values that c205 debug --dap shows are compared with the
 * machine: elements with their control bits in every range, and the accounts after
 * every step. The launch members that the editor's extension proposes must be accepted.
 * A value of another element, or a cause without its clocks, fails here. */
#include "base/file.h"
#include "base/json.h"
#include "tests/unit/dap_session.h"
#include "tests/unit/plain_run.h"
#include "tests/unit/saved_machine.h"

/* ---- Displayed values
 * --------------------------------------------------------------------- */

static const char masked_text[] = "        .include \"vectors.s\"\n"
                                  "        .regs   r16, a, b, mask\n"
                                  "        words   a, 1.5, -2.0, 3.0, 4.0\n"
                                  "        words   b\n"
                                  "        bits    mask, \"1010\"\n"
                                  "        ADDNV   [a], [a], [b] ? [mask]\n"
                                  "        EXIT\n";

TEST(elements)
{
    static const char *const values[] = { "1.5  X'FFD2 6000 0000 0000'  ? 1",
                                          "-2  X'FFD2 8000 0000 0000'  ? 0",
                                          "3  X'FFD3 6000 0000 0000'  ? 1",
                                          "4  X'FFD4 4000 0000 0000'  ? 0" };
    FREED_BY(client_leave) struct dap_client client;
    client_enter(&client, masked_text);
    client_stop_at(&client, "{\"line\": 6}");
    client_go(&client, "continue", "breakpoint");
    const struct json_value *list = client_variables(&client, "Operands");
    const struct json_value *item = element_with(list, "name", "ADDNV [a]");
    assert_string_equal(the_text(item, "value"), "4 words from 800000 on");
    assert_int_equal(the_whole(item, "indexedVariables"), 4);
    int reference = (int)the_whole(item, "variablesReference");
    for (int start = 0; start < 4; start++)
        for (int count = 0; count < 6; count++) {
            int i = start;
            const char *range =
                formatted(", \"filter\": \"indexed\", \"start\": %d, \"count\": %d",
                          start, count);
            item = client_inside(&client, reference, range)->first;
            for (; item; item = item->next, i++)
                assert_string_equal(the_text(item, "value"), values[i]);
            assert_int_equal(i, count == 0 || start + count > 4 ? 4 : start + count);
        }
    assert_string_equal(value_of(list, "ADDNV [mask]"), "bits from 800200 on");
    item = element_with(client_variables(&client, "Registers"), "name", "mask");
    item = client_inside(&client, (int)the_whole(item, "variablesReference"), "");
    assert_int_equal(length_of(item), 2 + 4); /* the same bits can be shown as words */
}

/* The time that is shown must equal the machine's accounts after every step. */
static void check_accounts(struct dap_client *client, const c205 *machine)
{
    const struct json_value *time = client_variables(client, "Time");
    uint64_t sum = 0;
    for (size_t i = 0; i < c205_account_count(machine); i++) {
        const c205_account *account = c205_account_at(machine, i);
        const char *name = *account->name ? account->name : "outside regions";
        const struct json_value *list = client_inside(client, reference_of(time, name),
                                                      "");
        for (int cause = 0; cause < C205_CAUSES; cause++) {
            uint64_t clocks = strtoull(value_of(list,
                                                c205_cause_name((c205_cause)cause)),
                                       NULL, 10);
            assert_int_equal(clocks, account->clocks[cause]);
            sum += clocks;
        }
        assert_int_equal(strtoull(value_of(list, "elements"), NULL, 10),
                         account->elements);
    }
    assert_int_equal(strtoull(value_of(time, "clock"), NULL, 10), sum);
}

TEST(time)
{
    FREED_BY(client_leave) struct dap_client client;
    SCOPED(object) *object = good(client_program);
    SCOPED(c205) *machine = machine_with(&object->program, prior_model);
    c205_stop stop;

    client_launch(&client, client_program,
                  ", \"stopOnEntry\": true, \"stopOnEnd\": "
                  "true, \"model\": \"cyber205-2pipe-prior\"");
    client_ask(&client, "configurationDone", NULL);
    client_stopped(&client, "entry");
    check_accounts(&client, machine);
    while (c205_step(machine, &stop)) {
        client_go_finely(&client, "stepIn");
        check_accounts(&client, machine);
    }
}

/* ---- The extension --------------------------------------------------------------- */

static const struct json_value *read_file(struct arena *arena, const char *name)
{
    size_t length;
    const char *whole = formatted("docs/editors/vscode/%s", name);
    FREED char *text = file_read(whole, FILE_LARGEST, &length, &failure);
    FAIL_IF(!text, "%s: %s", whole, failure.message);
    const struct json_value *tree = json_read(arena, text, length, &failure);
    FAIL_IF(!tree, "%s: %s", whole, failure.message);
    return tree;
}

/* Writes the members with the editor's defaults. `program` is the test's program. */
static void put_defaults(struct json *json, const struct json_value *properties)
{
    for (const struct json_value *item = properties->first; item; item = item->next) {
        const char *type = the_text(item, "type");
        const struct json_value *value = the(item, "default");
        if (strcmp(item->key, "program") == 0)
            json_text(json, "program", client_path);
        else if (strcmp(type, "string") == 0)
            json_text(json, item->key, value->text);
        else if (strcmp(type, "boolean") == 0)
            json_bool(json, item->key, value->truth);
        else {
            (strcmp(type, "array") == 0 ? json_array : json_object)(json, item->key);
            json_end(json);
        }
    }
}

/* The package's entry starts the adapter, which accepts the entry's members. */
TEST(extension)
{
    FREED_BY(client_leave) struct dap_client client;
    SCOPED_VALUE(text_buffer) launch_text = { 0 };
    SCOPED_VALUE(arena) arena = { 0 };
    const struct json_value *package = read_file(&arena, "package.json");
    const struct json_value *entry = the(the(package, "contributes"), "debuggers")
                                         ->first;
    struct json *json = json_open_line(&launch_text, &failure);

    read_file(&arena, "language-configuration.json");
    read_file(&arena, "c205.tmLanguage.json");
    assert_string_equal(the_text(package, "version"), C205_VERSION);
    assert_string_equal(the_text(entry, "runtime"), "c205");
    assert_string_equal(the(entry, "args")->first->text, "debug");
    assert_string_equal(the(entry, "args")->first->next->text, "--dap");
    client_write(client_program);
    put_defaults(json, the(the(the(entry, "configurationAttributes"), "launch"),
                           "properties"));
    assert_true(json_close(json, &failure));
    client_begin(&client, NULL);
    client_ask(&client, "initialize", NULL);
    client_ask(&client, "launch", "%s", launch_text.text);
    client_event(&client, "initialized");
    client_ask(&client, "configurationDone", NULL);
    client_stopped(&client, "entry");
}
