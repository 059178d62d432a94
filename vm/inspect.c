/* inspect.c - gives the host access to memory, registers and clock of a machine. */
#include "vm/machine.h"
#include "vm/shared.h"

/* ---- Memory ------------------------------------------------------------- */

bool c205_map(c205 *machine, uint64_t address, size_t words, c205_access access,
              c205_error *error)
{
    return memory_map(&machine->memory, address, words, access, error);
}

bool c205_map_shared(c205 *machine, uint64_t address, const c205_shared *shared,
                     c205_error *error)
{
    return shared_map(shared, &machine->memory, address, error);
}

void c205_warm(c205 *machine)
{
    uint64_t address = memory_next_page(&machine->memory, 0);
    for (; address <= ADDRESS_MASK;
         address = memory_next_page(&machine->memory, address + PAGE_BITS))
        clock_warm_page(machine->clock, address, PAGE_BITS);
}

bool c205_next_page(const c205 *machine, uint64_t from, c205_page *page)
{
    uint64_t address = memory_next_page(&machine->memory, from & ~(PAGE_BITS - 1));
    const struct page *found;
    if (from > ADDRESS_MASK || address > ADDRESS_MASK)
        return false;
    found = memory_peek(&machine->memory, address);
    page->address = address;
    page->touched = !memory_is_untouched(found);
    page->writable = !page->touched || memory_may_write(found);
    return true;
}

static bool host_may_copy(const c205 *machine, uint64_t address, size_t count)
{
    uint64_t fault;
    return address % WORD_BITS == 0 && address <= ADDRESS_MASK
           && (uint64_t)count <= ADDRESS_SPACE_WORDS
           && memory_check(&machine->memory, address, (uint64_t)count * WORD_BITS,
                           false, &fault)
                  == C205_TRAP_NONE;
}

bool c205_read(const c205 *machine, uint64_t address, c205_word *words, size_t count)
{
    if (!host_may_copy(machine, address, count))
        return false;
    memory_read_words(&machine->memory, address, words, count);
    return true;
}

bool c205_write(c205 *machine, uint64_t address, const c205_word *words, size_t count)
{
    if (!host_may_copy(machine, address, count))
        return false;
    memory_write_words(&machine->memory, address, words, count);
    return true;
}

/* ---- Registers ---------------------------------------------------------- */

c205_word c205_register(const c205 *machine, unsigned number)
{
    return number < C205_REGISTERS ? machine->slot[number] : 0;
}

/* Sets a register other than register 0, which is constant. */
void c205_set_register(c205 *machine, unsigned number, c205_word word)
{
    if (number > 0 && number < C205_REGISTERS)
        machine->slot[number] = word;
}

uint64_t c205_pc(const c205 *machine)
{
    return machine->pc;
}

void c205_set_pc(c205 *machine, uint64_t address)
{
    machine_clear_resume(machine);
    clock_commit(machine->clock);
    machine->pc = address & ADDRESS_MASK;
}

c205_word c205_data_flags(const c205 *machine)
{
    return machine_flags(machine);
}

uint64_t c205_loaded_program(const c205 *machine)
{
    return machine->program;
}

/* ---- Time --------------------------------------------------------------- */

uint64_t c205_clock(const c205 *machine)
{
    return clock_now(machine->clock);
}

const c205_model *c205_machine_model(const c205 *machine)
{
    return machine->model;
}

size_t c205_account_count(const c205 *machine)
{
    return clock_account_count(machine->clock);
}

const c205_account *c205_account_at(const c205 *machine, size_t i)
{
    return clock_account(machine->clock, i);
}

void c205_reset_clock(c205 *machine)
{
    machine_raise_flags(machine);
    if (machine->timer)
        machine->timer -= clock_now(machine->clock);
    clock_reset(machine->clock);
}
