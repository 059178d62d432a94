/* sparse.c - executes arithmetic on sparse vectors. A sparse vector consists of its
 * present elements, packed, and of an order vector. The order vector has a one for each
 * present and a zero for each absent element.
 *
 * All order vectors are read before the first element is stored. If the order vector of
 * the result is computed, it is stored after the last element.
 */
#include "vm/vector.h"

enum {
    ORDER_BITS = C205_MAX_LENGTH + 1,
    ORDER_WORDS = ORDER_BITS / 64,
    ORDER_BYTES = ORDER_BITS / 8
};

/* The positions of the elements that are present. */
struct order_vector {
    struct vector vector;
    uint64_t *bits; /* [ORDER_WORDS]; zeros after the end */
    size_t ones;
};

/* The elements of the result that are present: present in either operand (EITHER), in
 * both operands (BOTH), or in the given vector Z (GIVEN). */
enum presence { EITHER, BOTH, GIVEN };

struct sparse {
    struct c205 *machine;
    enum presence presence;
    struct turn turn; /* the part of the order vectors that is processed now */
    struct source a, b;
    struct vector result;
    struct order_vector x, y, z;
    size_t next_a, next_b, next_result;
};

/* ---- Order vectors ----------------------------------------------------- */

/* Maximum number of order vectors that are read: X, Y, and Z if it is given. */
enum { ORDERS = 3 };

static size_t orders_read(const struct sparse *sparse)
{
    return sparse->presence == GIVEN ? ORDERS : ORDERS - 1;
}

/* Returns the saved order vectors of an interrupted instruction, one after another, or
 * NULL if there are none. They are saved because the result may overwrite them. */
static const uint64_t *kept_orders(const struct sparse *sparse)
{
    struct c205 *machine = sparse->machine;
    return machine->resume.kept == orders_read(sparse) * ORDER_WORDS
               ? machine_scratch(machine, SCRATCH_KEPT)
               : NULL;
}

static c205_trap keep_orders(const struct sparse *sparse)
{
    struct c205 *machine = sparse->machine;
    const struct order_vector *orders[ORDERS] = { &sparse->x, &sparse->y, &sparse->z };
    c205_word *kept = machine_scratch(machine, SCRATCH_KEPT);
    if (!kept)
        return C205_TRAP_NO_MEMORY;
    for (size_t i = 0; i < orders_read(sparse); i++)
        memcpy(kept + i * ORDER_WORDS, orders[i]->bits, ORDER_BYTES);
    machine->resume.kept = orders_read(sparse) * ORDER_WORDS;
    return C205_TRAP_NONE;
}

static c205_trap read_order(struct c205 *machine, struct order_vector *order,
                            const uint64_t *kept)
{
    struct vector *vector = &order->vector;
    c205_trap trap = claim_vector(machine, vector, vector->length, false);
    if (trap != C205_TRAP_NONE)
        return trap;
    memset(order->bits, 0, ORDER_BYTES);
    if (kept)
        memcpy(order->bits, kept, ORDER_BYTES);
    else
        memory_read_bits(&machine->memory, vector->address, order->bits,
                         vector->length);
    order->ones = count_ones(order->bits, vector->length);
    return C205_TRAP_NONE;
}

static c205_trap read_orders(struct sparse *sparse)
{
    struct order_vector *orders[ORDERS] = { &sparse->x, &sparse->y, &sparse->z };
    const uint64_t *kept = kept_orders(sparse);
    c205_word *bits = machine_scratch(sparse->machine, SCRATCH_ORDERS);
    c205_trap trap = bits ? C205_TRAP_NONE : C205_TRAP_NO_MEMORY;
    for (size_t i = 0; i < ORDERS && bits; i++)
        orders[i]->bits = bits + i * ORDER_WORDS;
    for (size_t i = 0; i < orders_read(sparse) && trap == C205_TRAP_NONE; i++)
        trap = read_order(sparse->machine, orders[i],
                          kept ? kept + i * ORDER_WORDS : NULL);
    return trap;
}

/* Computes the order vector of the result if it is not given. */
static void combine_orders(struct sparse *sparse)
{
    const struct order_vector *x = &sparse->x, *y = &sparse->y;
    struct order_vector *z = &sparse->z;
    for (size_t i = 0; i < ORDER_WORDS; i++)
        z->bits[i] = sparse->presence == EITHER ? x->bits[i] | y->bits[i]
                                                : x->bits[i] & y->bits[i];
    z->ones = count_ones(z->bits, z->vector.length);
}

static size_t ones_from(const struct order_vector *order, size_t first, size_t n)
{
    size_t count = 0;
    for (size_t i = first; i < first + n; i++)
        count += bit_at(order->bits, i);
    return count;
}

/* ---- Operands ---------------------------------------------------------- */

/* Evaluates the descriptors of the packed vectors. The fields X and Y name order
 * vectors and not offsets, and the result has no offset. */
static c205_trap describe_packed(struct sparse *sparse, const struct decoded *decoded)
{
    const struct c205 *machine = sparse->machine;
    struct decoded packed = *decoded;
    struct control z;
    packed.x = packed.y = 0;
    packed.fields.g &= (uint8_t)~C205_G_OFFSET;
    c205_trap trap = describe_a(&sparse->a, machine, &packed);
    if (trap == C205_TRAP_NONE)
        trap = describe_b(&sparse->b, machine, &packed);
    if (trap == C205_TRAP_NONE)
        trap = describe_result(&sparse->result, &z, machine, &packed);
    return trap;
}

/* Evaluates the descriptors of the order vectors. The number of positions is the length
 * of Z if it is given, and otherwise the larger length of X and Y. Bits after this
 * number are ignored. */
static void describe_orders(struct sparse *sparse, const struct decoded *decoded)
{
    const c205_word *slot = sparse->machine->slot;
    struct vector *x = &sparse->x.vector, *y = &sparse->y.vector;
    struct vector *z = &sparse->z.vector;
    *x = describe_bits(slot[decoded->x]);
    *y = describe_bits(slot[decoded->y]);
    *z = describe_bits(slot[decoded->z]);
    if (sparse->presence != GIVEN)
        z->length = x->length > y->length ? x->length : y->length;
    x->length = min_size(x->length, z->length);
    y->length = min_size(y->length, z->length);
}

static c205_trap claim_packed(struct sparse *sparse)
{
    struct c205 *machine = sparse->machine;
    struct order_vector *z = &sparse->z;
    sparse->result.length = z->ones;
    c205_trap trap = claim_source(machine, &sparse->a, sparse->x.ones);
    if (trap == C205_TRAP_NONE)
        trap = claim_source(machine, &sparse->b, sparse->y.ones);
    if (trap == C205_TRAP_NONE)
        trap = claim_vector(machine, &sparse->result, z->ones, true);
    if (trap == C205_TRAP_NONE && sparse->presence != GIVEN)
        trap = claim_vector(machine, &z->vector, z->vector.length, true);
    return trap;
}

static c205_trap open_sparse(struct sparse *sparse, struct c205 *machine,
                             const struct decoded *decoded, enum presence presence)
{
    sparse->machine = machine;
    sparse->presence = decoded->fields.g & C205_G_GIVEN ? GIVEN : presence;
    describe_orders(sparse, decoded);
    c205_trap trap = describe_packed(sparse, decoded);
    if (trap == C205_TRAP_NONE)
        trap = read_orders(sparse);
    if (trap != C205_TRAP_NONE)
        return trap;
    if (sparse->presence != GIVEN)
        combine_orders(sparse);
    return claim_packed(sparse);
}

/* ---- Elements ---------------------------------------------------------- */

/* Collects the operands of the results at n positions. An absent operand is machine
 * zero. Returns the number of results. */
static size_t take_pairs(struct sparse *sparse, size_t first, size_t n,
                         c205_word *pair_a, c205_word *pair_b)
{
    size_t count_a = ones_from(&sparse->x, first, n), count = 0;
    size_t count_b = ones_from(&sparse->y, first, n);
    const c205_word *a = source_read(&sparse->a, sparse->next_a, count_a);
    const c205_word *b = source_read(&sparse->b, sparse->next_b, count_b);
    for (size_t i = first; i < first + n; i++) {
        bool in_a = bit_at(sparse->x.bits, i);
        bool in_b = bit_at(sparse->y.bits, i);
        pair_a[count] = in_a ? *a++ : C205_MACHINE_ZERO;
        pair_b[count] = in_b ? *b++ : C205_MACHINE_ZERO;
        count += bit_at(sparse->z.bits, i);
    }
    sparse->next_a += count_a;
    sparse->next_b += count_b;
    return count;
}

/* Counts the elements of the result whose operand is a word that an earlier element was
 * stored to. */
static void record_recurrence_of_sparse(const struct sparse *sparse)
{
    const struct vector *a = &sparse->a.vector, *b = &sparse->b.vector;
    const struct vector *result = &sparse->result;
    size_t next_a = 0, next_b = 0, stored = 0;
    if (!operands_overlap(a, result) && !operands_overlap(b, result))
        return;
    for (size_t i = 0; i < sparse->z.vector.length; i++) {
        bool in_a = bit_at(sparse->x.bits, i), in_b = bit_at(sparse->y.bits, i);
        if (bit_at(sparse->z.bits, i)) {
            bool of_a = in_a && operand_recurs(a, next_a, result, stored);
            bool of_b = in_b && operand_recurs(b, next_b, result, stored);
            sparse->machine->effect.recurrent += of_a || of_b;
            stored++;
        }
        next_a += in_a;
        next_b += in_b;
    }
}

static c205_trap run_sparse(struct sparse *sparse, const struct operation *operation)
{
    const struct turn *turn = &sparse->turn;
    const struct vector *result = &sparse->result;
    struct c205 *machine = sparse->machine;
    c205_word a[CHUNK], b[CHUNK], words[CHUNK];
    bool apart = !operands_overlap(&sparse->a.vector, result)
                 && !operands_overlap(&sparse->b.vector, result);
    size_t chunk = apart ? CHUNK : 1;
    for (size_t first = turn->first, n; first < turn->end; first += n) {
        n = min_size(turn->end - first, chunk);
        size_t count = take_pairs(sparse, first, n, a, b);
        operate(machine, operation, words, a, b, count, NULL);
        vector_write(&machine->memory, result, sparse->next_result, words, count);
        sparse->next_result += count;
    }
    c205_trap trap = machine_end_turn(machine, turn);
    if (trap == C205_TRAP_NONE && sparse->presence != GIVEN)
        memory_write_bits(&machine->memory, sparse->z.vector.address, sparse->z.bits,
                          sparse->z.vector.length);
    return trap;
}

static size_t longest(size_t a, size_t b, size_t c)
{
    size_t longer = a > b ? a : b;
    return longer > c ? longer : c;
}

/* Returns the largest number of positions in which no packed vector has more than
 * `elements` elements. */
static size_t places_of(const struct sparse *sparse, size_t elements)
{
    size_t x = 0, y = 0, z = 0, length = sparse->z.vector.length;
    if (elements >= sparse->machine->effect.elements)
        return length;
    for (size_t i = 0; i < length; i++) {
        x += bit_at(sparse->x.bits, i);
        y += bit_at(sparse->y.bits, i);
        z += bit_at(sparse->z.bits, i);
        if (longest(x, y, z) > elements)
            return i;
    }
    return length;
}

/* Starts a turn at the first element that earlier turns have not processed. */
static c205_trap begin_turn(struct sparse *sparse)
{
    struct c205 *machine = sparse->machine;
    sparse->turn = machine_turn(machine, sparse->z.vector.length,
                                places_of(sparse, machine->allowed));
    size_t first = sparse->turn.first;
    sparse->next_a = ones_from(&sparse->x, 0, first);
    sparse->next_b = ones_from(&sparse->y, 0, first);
    sparse->next_result = ones_from(&sparse->z, 0, first);
    return sparse->turn.end < sparse->turn.n ? keep_orders(sparse) : C205_TRAP_NONE;
}

static void set_length(struct c205 *machine, uint16_t slot, size_t length)
{
    if (slot)
        machine->slot[slot] = with_length(machine->slot[slot], length);
}

static c205_trap sparse(struct c205 *machine, const struct decoded *decoded,
                        enum presence presence)
{
    struct sparse sparse;
    c205_trap trap = open_sparse(&sparse, machine, decoded, presence);
    if (trap != C205_TRAP_NONE)
        return trap;
    machine->effect.elements = longest(sparse.x.ones, sparse.y.ones, sparse.z.ones);
    machine->effect.idle = machine->effect.elements - sparse.z.ones;
    record_recurrence_of_sparse(&sparse);
    trap = begin_turn(&sparse);
    if (trap == C205_TRAP_NONE)
        trap = run_sparse(&sparse, operation_of(decoded));
    if (trap != C205_TRAP_NONE)
        return trap;
    set_length(machine, decoded->c, sparse.z.ones);
    if (sparse.presence != GIVEN)
        set_length(machine, decoded->z, sparse.z.vector.length);
    return C205_TRAP_NONE;
}

c205_trap execute_sparse_either(struct c205 *machine, const struct decoded *decoded)
{
    return sparse(machine, decoded, EITHER);
}

c205_trap execute_sparse_both(struct c205 *machine, const struct decoded *decoded)
{
    return sparse(machine, decoded, BOTH);
}
