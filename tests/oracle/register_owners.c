/* register_owners.c - records the names under which registers are written, and reports
 * reads under other names (register_owners.h). */
#include "tests/oracle/register_owners.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "tests/oracle/operand_letters.h"
#include "tests/oracle/reference.h"

enum { ANYONE = -1, KEPT_WORDS = 1 << 12, MAX_FOUND = 1000, MAX_NAMES = 16 };

/* A word that a SWAP saved in memory. */
struct kept {
    uint64_t address; /* 0: no word */
    uint64_t begin;   /* address of the saved vector */
    unsigned first;   /* first register of the saved vector */
    c205_word word;
    long owner;
};

struct found {
    uint64_t address;
    size_t name;      /* name under which the register is read */
    long owner;       /* name of the register's value */
    uint64_t written; /* address of the instruction that wrote the value */
};

/* The operands of an instruction of the table. */
struct row {
    char letters[ROLES];
    bool reads[ROLES], writes[ROLES];
    bool offsets; /* X and Y may be offsets */
    bool target;  /* Y and B form a branch target */
};

/* The names that an instruction mentions. */
struct names {
    const struct asm_mention *first;
    size_t count;
};
enum { KNOWN_NAMES = 1 << 12 };

struct register_owners {
    /* A cache of names by address. */
    struct known_names {
        uint64_t address;
        struct names names;
    } known[KNOWN_NAMES];
    const struct object *program;
    long owner[C205_REGISTERS]; /* index of a name, or ANYONE */
    uint64_t written[C205_REGISTERS];
    struct kept kept[KEPT_WORDS];
    struct found found[MAX_FOUND];
    size_t found_count;
    uint64_t read;
    struct row rows[]; /* parallel to c205_insns */
};

static struct row row_of(const c205_insn *insn)
{
    const char *syntax = c205_format_syntax(insn->format);
    struct row row = { .offsets = strpbrk(syntax, "ab+") != NULL,
                       .target = strchr(syntax, '@') != NULL };
    row.offsets |= insn->format == C205_FORMAT_SPARSE || row.target;
    for (int role = 0; role < ROLES; role++) {
        char letter = letter_of(insn, (enum role)role);
        row.letters[role] = letter;
        row.reads[role] = letter && !strchr("wWpk", letter);
        row.writes[role] = letter && strchr("wWpkmM", letter);
    }
    return row;
}

struct register_owners *register_owners_new(const struct object *program)
{
    struct register_owners *owners = calloc(1,
                                            sizeof *owners
                                                + c205_insn_count * sizeof(struct row));
    if (!owners)
        return NULL;
    owners->program = program;
    for (size_t i = 0; i < c205_insn_count; i++)
        owners->rows[i] = row_of(&c205_insns[i]);
    for (size_t i = 0; i < C205_REGISTERS; i++)
        owners->owner[i] = ANYONE;
    return owners;
}

void register_owners_free(struct register_owners *owners)
{
    free(owners);
}

/* ---- Names -------------------------------------------------------------- */

static unsigned whole_number(const struct asm_register *name)
{
    return name->half ? name->number / 2u : name->number;
}

/* Returns the names in the instruction at an address. */
static struct names names_at(const struct object *program, uint64_t address)
{
    struct names names = { program->mentions, 0 };
    size_t low = 0, high = program->mention_count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (program->mentions[middle].address < address)
            low = middle + 1;
        else
            high = middle;
    }
    names.first = program->mentions + low;
    while (low + names.count < program->mention_count
           && names.first[names.count].address == address)
        names.count++;
    return names;
}

static struct names known_names(struct register_owners *owners, uint64_t address)
{
    struct known_names *known = &owners->known[address / 32 % KNOWN_NAMES];
    if (known->address != address)
        *known = (struct known_names){ address, names_at(owners->program, address) };
    return known->names;
}

/* Returns the last name of a register in an instruction: results follow sources. */
static long name_of(const struct object *program, struct names names, unsigned number)
{
    long found = ANYONE;
    for (size_t i = 0; i < names.count; i++)
        if (whole_number(&program->registers[names.first[i].name]) == number)
            found = (long)names.first[i].name;
    return found;
}

/* Returns the name `count` registers after a name, if declared in sequence. */
static long name_behind(const struct object *program, long name, size_t count)
{
    const struct asm_register *first, *behind;
    if (name == ANYONE || (size_t)name + count >= program->register_count)
        return ANYONE;
    first = &program->registers[name];
    behind = first + count;
    return !first->half && !behind->half && behind->number == first->number + count
               ? name + (long)count
               : ANYONE;
}

/* ---- Reading and writing ------------------------------------------------ */

static bool is_known(const struct register_owners *owners, uint64_t address,
                     size_t name, long owner)
{
    for (size_t i = 0; i < owners->found_count; i++)
        if (owners->found[i].address == address && owners->found[i].name == name
            && owners->found[i].owner == owner)
            return true;
    return false;
}

static void find(struct register_owners *owners, uint64_t address, size_t name,
                 unsigned number)
{
    long owner = owners->owner[number];
    if (owners->found_count < MAX_FOUND && !is_known(owners, address, name, owner))
        owners->found[owners->found_count++] = (struct found){
            address, name, owner, owners->written[number]
        };
}

/* Records a read of a register under a name that is not its owner. If the instruction
 * mentions the register under several names, one of them must be the owner. */
static void read_register(struct register_owners *owners, uint64_t address,
                          struct names names, unsigned number)
{
    const struct object *program = owners->program;
    long owner = owners->owner[number], name;
    name = name_of(program, names, number);
    if (number == 0 || owner == ANYONE || name == ANYONE)
        return;
    owners->read++;
    for (size_t i = 0; i < names.count; i++) {
        const struct asm_register *mentioned = &program->registers[names.first[i].name];
        if (whole_number(mentioned) == number && (long)mentioned->owner == owner)
            return;
    }
    find(owners, address, (size_t)name, number);
}

static void write_register(struct register_owners *owners, uint64_t address,
                           unsigned number, long name)
{
    if (number >= C205_REGISTERS)
        return;
    owners->owner[number] = name == ANYONE
                                ? ANYONE
                                : (long)owners->program->registers[name].owner;
    owners->written[number] = address;
}

/* ---- SWAP --------------------------------------------------------------- */

static struct kept *kept_at(struct register_owners *owners, uint64_t address)
{
    return &owners->kept[address / 64 % KEPT_WORDS];
}

static unsigned count_of(c205_word descriptor, unsigned first)
{
    unsigned count = (unsigned)(descriptor >> 48);
    return count < C205_REGISTERS - first ? count : C205_REGISTERS - first;
}

static void save(struct register_owners *owners, const c205 *machine, c205_word to,
                 unsigned first)
{
    uint64_t address = to & 0xFFFFFFFFFFFF;
    for (unsigned i = 0; i < count_of(to, first); i++, address += 64) {
        struct kept *kept = kept_at(owners, address);
        kept->address = address;
        kept->begin = to & 0xFFFFFFFFFFFF;
        kept->first = first;
        kept->owner = owners->owner[first + i];
        if (!c205_read(machine, address, &kept->word, 1))
            kept->address = 0;
    }
}

static void load(struct register_owners *owners, const c205 *machine, uint64_t pc,
                 c205_word from, unsigned first, long name)
{
    uint64_t address = from & 0xFFFFFFFFFFFF;
    for (unsigned i = 0; i < count_of(from, first); i++, address += 64) {
        const struct kept *kept = kept_at(owners, address);
        write_register(owners, pc, first + i, name_behind(owners->program, name, i));
        if (kept->address == address && kept->first == first
            && kept->begin == (from & 0xFFFFFFFFFFFF)
            && kept->word == c205_register(machine, first + i))
            owners->owner[first + i] = kept->owner;
    }
}

/* A SWAP does not change its descriptors, unless they may be among the loaded
 * registers. In this case all owners become unknown. */
static void swap(struct register_owners *owners, const c205 *machine,
                 const c205_event *event, struct names names)
{
    const c205_fields *fields = &event->fields;
    c205_word from = fields->r ? c205_register(machine, fields->r) : 0;
    c205_word to = fields->t ? c205_register(machine, fields->t) : 0;
    read_register(owners, event->pc, names, fields->r);
    read_register(owners, event->pc, names, fields->t);
    if (fields->r && (fields->r >= fields->s || fields->t >= fields->s)) {
        for (unsigned i = fields->s; i < C205_REGISTERS; i++)
            owners->owner[i] = ANYONE;
        return;
    }
    save(owners, machine, to, fields->s);
    load(owners, machine, event->pc, from, fields->s,
         name_of(owners->program, names, fields->s));
}

/* ---- Instructions without special rules --------------------------------- */

static void read_operands(struct register_owners *owners, const c205_event *event,
                          struct names names)
{
    const struct row *row = &owners->rows[event->insn - c205_insns];
    c205_fields fields = event->fields;
    const uint8_t offsets[] = { fields.x, fields.y };
    for (int role = 0; role < ROLES; role++)
        if (row->reads[role])
            read_register(owners, event->pc, names,
                          *field_of_role(&fields, event->insn, (enum role)role));
    for (size_t i = 0; row->offsets && i < 2; i++)
        read_register(owners, event->pc, names, offsets[i]);
    if (row->target)
        read_register(owners, event->pc, names, fields.b);
    if (reference_has_offset(event->insn, &fields))
        read_register(owners, event->pc, names, fields.c + 1u);
}

static void write_results(struct register_owners *owners, const c205_event *event,
                          struct names names)
{
    const struct object *program = owners->program;
    const struct row *row = &owners->rows[event->insn - c205_insns];
    c205_fields fields = event->fields;
    for (int role = 0; role < ROLES; role++) {
        if (!row->writes[role])
            continue;
        unsigned number = *field_of_role(&fields, event->insn, (enum role)role);
        long name = name_of(program, names, number);
        if (number == 0)
            continue;
        write_register(owners, event->pc, number, name);
        if (row->letters[role] == 'p')
            write_register(owners, event->pc, number + 1,
                           name_behind(program, name, 1));
    }
}

/* Half registers count as the register that contains them. */
void register_owners_listen(void *context, const c205 *machine, const c205_event *event)
{
    struct register_owners *owners = context;
    if (event->kind != C205_EVENT_INSTRUCTION)
        return;
    struct names names = known_names(owners, event->pc);
    if (event->insn->format == C205_FORMAT_SWAP) {
        swap(owners, machine, event, names);
        return;
    }
    read_operands(owners, event, names);
    write_results(owners, event, names);
}

/* ---- Results ------------------------------------------------------------ */

uint64_t register_owners_read(const struct register_owners *owners)
{
    return owners->read;
}

size_t register_owners_found(const struct register_owners *owners)
{
    return owners->found_count;
}

static const struct asm_line *line_at(const struct object *program, uint64_t address)
{
    static const struct asm_line nowhere = { .file = "?", .source = "" };
    for (size_t i = 0; i < program->line_count; i++)
        if (program->lines[i].address <= address
            && address < program->lines[i].address + 32 * program->lines[i].halves)
            return &program->lines[i];
    return &nowhere;
}

void register_owners_print(const struct register_owners *owners,
                           const struct sink *sink)
{
    const struct object *program = owners->program;
    for (size_t i = 0; i < owners->found_count; i++) {
        const struct found *found = &owners->found[i];
        const struct asm_register *name = &program->registers[found->name];
        const struct asm_line *read = line_at(program, found->address);
        const struct asm_line *written = line_at(program, found->written);
        sink_print(sink, "%s:%zu: r%u is read as '%s', but it is '%s' since %s:%zu\n",
                   read->file, read->number, whole_number(name), name->name,
                   found->owner == ANYONE ? "?" : program->registers[found->owner].name,
                   written->file, written->number);
    }
}
