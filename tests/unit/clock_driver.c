/* clock_driver.c - charges a clock with instructions and effects of the test. */
#include "clock_driver.h"

uint64_t driven_pc;
const struct effect no_effect;

struct clock *clock_of(const char *text)
{
    SCOPED(c205_model) *model = NON_NULL(c205_model_parse("test", text, &failure));
    return NON_NULL(clock_new(model, &failure));
}

struct clock *two_pipes(void)
{
    return clock_of("title T\nlike cyber205-2pipe-prior\n");
}

struct decoded insn(const char *name, unsigned r, unsigned s, unsigned t)
{
    struct decoded decoded = { .insn = c205_insn_named(name, strlen(name)),
                               .pc = driven_pc };
    assert_non_null(decoded.insn);
    decoded.next = driven_pc + 32 * c205_format_halves(decoded.insn->format);
    decoded.flops = (uint8_t)c205_operation_flops(decoded.insn->operation);
    if (r)
        decoded.source[decoded.source_count++] = (uint16_t)r;
    if (s)
        decoded.source[decoded.source_count++] = (uint16_t)s;
    if (t)
        decoded.result[decoded.result_count++] = (uint16_t)t;
    return decoded;
}

void charge(struct clock *clock, struct decoded decoded, const struct effect *effect)
{
    clock_charge(clock, &decoded, effect);
    driven_pc = effect->taken ? effect->target : decoded.next;
}

void scalar(struct clock *clock, const char *name, unsigned r, unsigned s, unsigned t)
{
    charge(clock, insn(name, r, s, t), &no_effect);
}

void branch(struct clock *clock, const char *name, uint64_t target)
{
    const struct effect effect = { .taken = true, .target = target };
    charge(clock, insn(name, 0, 0, 0), &effect);
}

void at_address(struct clock *clock, const char *name, uint64_t address)
{
    const struct effect effect = { .touch_count = 1,
                                   .touch[0] = { .address = address, .bits = 64 } };
    charge(clock, insn(name, 1, 0, 9), &effect);
}

uint64_t clocks_for(const struct clock *clock, c205_cause cause)
{
    uint64_t sum = 0;
    for (size_t i = 0; i < clock_account_count(clock); i++)
        sum += clock_account(clock, i)->clocks[cause];
    return sum;
}

void assert_total(struct clock *clock, uint64_t expected)
{
    clock_drain(clock);
    assert_int_equal(clock_now(clock), expected);
    clock_reset(clock);
}
