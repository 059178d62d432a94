/* view.c - the requests `view` and `accounts`, which return the state of the program
 * and its clocks.
 */
#include <math.h>

#include "base/accounts.h"
#include "web/engine/engine_internal.h"

const c205 *engine_machine(const struct engine *engine)
{
    return debugger_machine(engine->debugger);
}

/* ---- The accounts --------------------------------------------------------------- */

static void put_causes(const uint64_t clocks[C205_CAUSES], uint64_t all,
                       struct json *reply)
{
    json_array(reply, "causes");
    for (int i = 0; i < C205_CAUSES; i++) {
        if (clocks[i] == 0)
            continue;
        json_object(reply, NULL);
        json_text(reply, "cause", c205_cause_name((c205_cause)i));
        json_count(reply, "clocks", clocks[i]);
        json_number(reply, "percent", 100 * (double)clocks[i] / (double)all);
        json_end(reply);
    }
    json_end(reply);
}

static double mean_length(const c205_account *account)
{
    return account->vector_instructions > 0
               ? (double)account->elements / (double)account->vector_instructions
               : NAN;
}

static void put_account(const struct accounts *accounts, const c205_account *account,
                        struct json *reply)
{
    json_count(reply, "clocks", accounts_clocks(account));
    json_count(reply, "instructions", account->instructions);
    json_count(reply, "vector", account->vector_instructions);
    json_count(reply, "elements", account->elements);
    json_number(reply, "mflops", accounts_rate(accounts->model, account));
    json_number(reply, "mean_length", mean_length(account));
    put_causes(account->clocks, accounts->clocks, reply);
}

/* Writes the accounts. Regions without clocks are omitted. */
bool put_accounts(const struct engine *engine, struct json *reply, c205_error *error)
{
    struct accounts accounts = { .model = engine->model };
    c205_account all;
    if (!accounts_add(&accounts, engine_machine(engine))) {
        accounts_free(&accounts);
        return error_set(error, "out of memory");
    }
    all = accounts_together(&accounts);
    json_object(reply, "accounts");
    put_account(&accounts, &all, reply);
    json_array(reply, "regions");
    for (size_t i = 0; i < accounts.count; i++) {
        if (accounts_clocks(&accounts.items[i]) == 0)
            continue;
        json_object(reply, NULL);
        json_text(reply, "region", accounts_region(&accounts.items[i]));
        put_account(&accounts, &accounts.items[i], reply);
        json_end(reply);
    }
    json_end(reply);
    json_end(reply);
    accounts_free(&accounts);
    return true;
}

bool put_table(struct table *table, const char *key, struct json *reply,
               c205_error *error)
{
    bool good = table && table_json(table, reply, key);
    table_free(table);
    return good || error_set(error, "out of memory");
}

/* Writes the accounts in the form of c205 run --json. */
bool answer_accounts(struct engine *engine, const struct json_value *request,
                     struct json *reply, c205_error *error)
{
    struct accounts accounts = { .model = engine->model };
    bool good;
    (void)request;
    json_count(reply, "clocks", c205_clock(engine_machine(engine)));
    good = accounts_add(&accounts, engine_machine(engine))
               ? put_table(accounts_by_cause(&accounts), "causes", reply, error)
                     && put_table(accounts_by_region(&accounts), "regions", reply,
                                  error)
               : error_set(error, "out of memory");
    accounts_free(&accounts);
    return good;
}

/* ---- view ---------------------------------------------------------------- */

static void put_place(const struct engine *engine, struct json *reply)
{
    const c205 *machine = engine_machine(engine);
    const c205_stop *halt = debugger_halt(engine->debugger);
    uint64_t clock = c205_clock(machine);
    json_count(reply, "step", debugger_step(engine->debugger));
    json_count(reply, "steps", debugger_known(engine->debugger));
    json_bool(reply, "ended", halt);
    if (halt) {
        json_text(reply, "trap", c205_trap_name(halt->trap));
        json_number(reply, "status", (double)halt->status);
    }
    json_count(reply, "clock", clock);
    json_number(reply, "microseconds", 1e6 * accounts_seconds(engine->model, clock));
    json_count(reply, "pc", c205_pc(machine));
    json_count(reply, "line", program_line(engine, c205_pc(machine)));
    json_text(reply, "region", object_region(engine->object, c205_pc(machine)));
}

static bool put_printed(const struct engine *engine, struct json *reply,
                        c205_error *error)
{
    const struct printed *printed = &engine->printed;
    uint64_t step = debugger_step(engine->debugger);
    size_t length = printed_until(printed, step);
    struct arena arena = { 0 };
    char *text = arena_text(&arena, length > 0 ? printed->text.text : "", length);
    if (text) {
        json_text(reply, "printed", text);
        json_bool(reply, "printed_cut", printed_is_cut(printed, step));
    }
    arena_free(&arena);
    return text || error_set(error, "out of memory");
}

bool answer_view(struct engine *engine, const struct json_value *request,
                 struct json *reply, c205_error *error)
{
    bool all = false;
    if (!take_truth(request, "all-registers", &all, error))
        return false;
    put_place(engine, reply);
    put_next_insn(engine, reply);
    put_registers(engine, all, reply);
    return put_last_insn(engine, reply, error) && put_accounts(engine, reply, error)
           && put_vectors(engine, request, reply, error)
           && put_printed(engine, reply, error) && put_warnings(engine, reply, error);
}
