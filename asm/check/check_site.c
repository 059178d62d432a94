/* check_site.c - checks the operands of an instruction before it runs and its results
 * after it. The kind of instruction determines the checks. */
#include <ctype.h>
#include <inttypes.h>
#include <string.h>

#include "asm/check/check_site.h"
#include "base/plural.h"
#include "vm/min_max.h"

enum { CHUNK = 256, FULL_LOOKS = 16 };

/* Returns true if an expensive check must run. It runs at the first 16 executions of an
 * instruction, then at the 32nd, the 64th and so on. Faults that depend on data appear
 * early, and the cost in a long run is small. */
static bool should_sample(struct site *site)
{
    uint64_t n = ++site->executions;
    return n <= FULL_LOOKS || (n & (n - 1)) == 0;
}

/* ---- Lengths ------------------------------------------------------------ */

/* Returns true if the length of the operand determines the number of elements. The
 * result in Z of ACPSV does not, because it has a bit for each comparison. */
static bool has_length(const struct operand_view *operand)
{
    return operand->is_vector && (operand->field != 'Z' || operand->letter == 'b')
           && strchr("vubldeq", tolower((unsigned char)operand->letter));
}

static void check_length(struct runtime_checker *watch, const struct site *site,
                         const struct operand_view *operand)
{
    unsigned r = operand->number;
    if (c205_descriptor_length(operand->word) > 0)
        return;
    if (r == 0 && site->view.insn->format != C205_FORMAT_SPARSE)
        runtime_report(watch, site, WARNING_UNSET_LENGTH,
                       "r0 is 0, so it describes no vector");
    else if (watch->is_entered[r] && watch->entered[r] == operand->word)
        runtime_report(watch, site, WARNING_UNSET_LENGTH,
                       "r%u has the address %" PRIX64
                       " but no length; set it with ELEN or the macro descriptor",
                       r, operand->word);
    else if (watch->is_emptied[r] && watch->emptied[r] == operand->word)
        runtime_report(watch, site, WARNING_ZERO_LENGTH,
                       "the length of [r%u] was set to 0", r);
}

/* ---- Storage ------------------------------------------------------------ */

static void check_storage(struct runtime_checker *watch, const struct site *site,
                          const struct operand_view *result)
{
    uint64_t base = c205_descriptor_address(result->word), end, past;
    const char *name = storage_at(watch->storage, base, &end);
    past = result->address + (uint64_t)result->length * result->width;
    if (name && result->length > 0 && past > end)
        runtime_report(watch, site, WARNING_PAST_STORAGE,
                       "the result extends to address %" PRIX64
                       ", but the storage of '%s' ends at %" PRIX64,
                       past, name, end);
}

/* Warns if the element at an index is beyond the storage of the label at the base
 * address. */
static void check_store(struct runtime_checker *watch, const struct site *site,
                        uint64_t base, int64_t index, unsigned width)
{
    uint64_t end;
    const char *name = storage_at(watch->storage, base, &end);
    if (name && index > 0 && (uint64_t)index * width >= end - base)
        runtime_report(watch, site, WARNING_PAST_STORAGE,
                       "index %" PRId64
                       " is beyond the storage of '%s', which ends at %" PRIX64,
                       index, name, end);
}

/* ---- Indices ------------------------------------------------------------ */

/* Returns true if a word has the exponent of a number other than an integer. It is not
 * 0, machine zero or indefinite. */
static bool has_exponent(c205_word word)
{
    unsigned field = (unsigned)(word >> 48);
    return field != 0 && (field & 0xF000) != 0x7000 && (field & 0xF000) != 0x8000;
}

/* Returns true if a word is a normalised number and therefore not an index. The high 16
 * bits of an index are ignored, so they may have any value. No practical index reaches
 * bit 46. */
static bool is_float(c205_word word)
{
    return has_exponent(word) && ((word >> 47 ^ word >> 46) & 1);
}

/* Returns true if an element of an index list is a number with an exponent, normalised
 * or not. An index list contains no descriptors, so its high 16 bits must be 0. */
static bool is_float_element(c205_word word)
{
    return has_exponent(word) && c205_to_integer(word) != 0;
}

static void print_float_index(struct runtime_checker *watch, const struct site *site,
                              const char *which, c205_word word)
{
    char text[C205_TEXT_SIZE];
    c205_to_text(word, text);
    runtime_report(
        watch, site, WARNING_FLOAT_INDEX,
        "%s is %s, not an integer; convert it with TRU, FLR or their vector forms",
        which, text);
}

static void check_index(struct runtime_checker *watch, const struct site *site,
                        const struct operand_view *index, const char *what)
{
    struct text_line which = { "", 0 };
    struct sink sink = text_line_sink(&which);
    if (!is_float(index->word))
        return;
    sink_print(&sink, "the %s in r%u", what, index->number);
    print_float_index(watch, site, which.text, index->word);
}

/* Warns of numbers with an exponent in the index list of a gather or scatter. For a scatter,
 * also checks the addresses in the table to which it stores. */
static void check_indices(struct runtime_checker *watch, const c205 *machine,
                          const struct site *site, const struct operand_view *list)
{
    const struct operand_view *table = view_find(&site->view, "xX");
    bool scatters = site->view.insn->operands[0] == 'l'
                    && tolower((unsigned char)site->view.insn->operands[2]) == 'x';
    c205_word words[CHUNK];
    size_t first, n;
    for (first = 0; first < list->length; first += n) {
        n = min_size(CHUNK, list->length - first);
        if (!view_read(machine, list->address, list->width, first, n, words))
            return;
        for (size_t i = 0; i < n; i++) {
            struct text_line which = { "", 0 };
            struct sink sink = text_line_sink(&which);
            if (is_float_element(words[i])) {
                sink_print(&sink, "element %zu of the index list [r%u]", first + i,
                           list->number);
                print_float_index(watch, site, which.text, words[i]);
                return;
            }
            if (scatters && table)
                check_store(watch, site, c205_descriptor_address(table->word),
                            c205_to_integer(words[i]), table->width);
        }
    }
}

/* Warns if the period of a periodic gather or scatter is a normalised number. Otherwise
 * checks the last store of a scatter, which has one store for each element of its
 * source. */
static void check_period(struct runtime_checker *watch, const struct site *site,
                         const struct operand_view *period)
{
    const struct operand_view *source = view_find(&site->view, "uU");
    const struct operand_view *table = view_find(&site->view, "xX");
    int64_t distance = c205_to_integer(period->word);
    if (is_float(period->word))
        check_index(watch, site, period, "period");
    else if (source && source->length > 0)
        check_store(watch, site, c205_descriptor_address(table->word),
                    distance * (int64_t)(source->length - 1), table->width);
}

/* ---- Integers ----------------------------------------------------------- */

/* Warns of an integer operand that loses bits. element is the index of the operand in a
 * vector, or -1 for a scalar. */
static void print_integer(struct runtime_checker *watch, const struct site *site,
                          const struct operand_view *operand, int64_t element,
                          c205_word word, const struct precision *precision)
{
    struct text_line where = { "", 0 };
    struct sink sink = text_line_sink(&where);
    char number[C205_TEXT_SIZE];
    bool half = operand->width == 32;
    if (operand->is_vector)
        sink_print(&sink, "element %" PRId64 " of [r%u]", element, operand->number);
    else
        sink_print(&sink, "%c%u", half ? 'h' : 'r', operand->number);
    (half ? c205_half_to_text : c205_to_text)(word, number);
    runtime_report(
        watch, site, WARNING_INTEGER_OPERAND,
        "%s is the integer %s, not %s.0, so bits are lost: %.15g becomes %.15g; "
        "normalise it with ADDN and r0",
        where.text, number, number, precision->exact, precision->kept);
}

/* Checks the two operands of an operation, and warns of an integer that loses bits. b
 * is NULL if the operation has one operand. Returns true after a warning. */
static bool check_pair(struct runtime_checker *watch, const struct site *site,
                       const struct operand_view *a, const struct operand_view *b,
                       int64_t element, c205_word word_a, c205_word word_b)
{
    struct precision precision;
    bool half = a->width == 32;
    bool first = precision_is_integer(word_a, half);
    if ((!first && !(b && precision_is_integer(word_b, half)))
        || !precision_is_lost(site->rule, half, word_a, word_b, &precision))
        return false;
    print_integer(watch, site, first ? a : b, element, first ? word_a : word_b,
                  &precision);
    return true;
}

/* Reads n words of a source vector from element `first` on. A scalar source is
 * repeated. */
static bool fetch(const c205 *machine, const struct operand_view *source, size_t first,
                  size_t n, c205_word *words)
{
    if (source && source->is_vector)
        return view_read(machine, source->address, source->width, first, n, words);
    for (size_t i = 0; i < n; i++)
        words[i] = source ? source->word : 0;
    return true;
}

/* Returns the smallest length of the source vectors and of the result. If no source is
 * a vector, this is at most 1. */
static size_t count_elements(const struct site *site, const struct operand_view *a,
                             const struct operand_view *b)
{
    const struct operand_view *result = view_find(&site->view, "dDcC");
    size_t n = result && strchr("dD", result->letter) ? result->length
                                                      : C205_MAX_LENGTH;
    if (a->is_vector)
        n = min_size(n, a->length);
    if (b && b->is_vector)
        n = min_size(n, b->length);
    return a->is_vector || (b && b->is_vector) ? n : min_size(n, 1);
}

static bool is_permitted(const struct site *site, const struct operand_view *control,
                         c205_word bit)
{
    return !control || bit != ((site->view.fields.g & C205_G_ZEROS) != 0);
}

static void check_integers(struct runtime_checker *watch, const c205 *machine,
                           const struct site *site, const struct operand_view *a,
                           const struct operand_view *b)
{
    const struct operand_view *control = view_find(&site->view, "z");
    c205_word words_a[CHUNK], words_b[CHUNK], bits[CHUNK];
    size_t first, n, i, count = count_elements(site, a, b);
    if (control && control->number == 0)
        control = NULL;
    for (first = 0; first < count; first += n) {
        n = min_size(CHUNK, count - first);
        if (!fetch(machine, a, first, n, words_a)
            || !fetch(machine, b, first, n, words_b)
            || !fetch(machine, control, first, n, bits))
            return;
        for (i = 0; i < n; i++)
            if (is_permitted(site, control, bits[i])
                && check_pair(watch, site, a, b, (int64_t)(first + i), words_a[i],
                              words_b[i]))
                return;
    }
}

/* ---- By kind ------------------------------------------------------------ */

/* Finds the first two source operands of which the instruction reads numbers, in the
 * order of the syntax. Returns their number. */
static size_t find_numbers(const struct instruction_view *view,
                           const struct operand_view *sources[2])
{
    size_t count = 0;
    for (size_t i = 0; i < view->count && count < 2; i++)
        if (strchr("fFvV", view->operands[i].letter))
            sources[count++] = &view->operands[i];
    return count;
}

static void check_numbers(struct runtime_checker *watch, const c205 *machine,
                          struct site *site)
{
    const struct operand_view *sources[2] = { NULL, NULL };
    size_t i, count = find_numbers(&site->view, sources);
    for (i = 0; i < count; i++)
        if (sources[i]->is_bad
            || (site->is_handed && sources[i]->is_vector
                && sources[i]->number == site->is_handed))
            return;
    if (count > 0)
        check_integers(watch, machine, site, sources[0], sources[1]);
}

/* Returns true if the register may contain an integer, because its exponent is 0. Few
 * normalised numbers have this exponent, so most operands need no further check. */
static inline bool may_be_integer(const c205 *machine,
                                  const struct operand_view *operand)
{
    unsigned n = operand->number;
    if (!operand->is_half)
        return c205_register(machine, n) >> 48 == 0;
    return (c205_register(machine, n / 2) << n % 2 * 32) >> 56 == 0;
}

static void before_scalar(struct runtime_checker *watch, const c205 *machine,
                          struct site *site)
{
    const struct operand_view *operands = site->view.operands;
    if (!may_be_integer(machine, &operands[0])
        && !may_be_integer(machine, &operands[1]))
        return;
    view_fill(&site->view, machine);
    check_numbers(watch, machine, site);
}

static void before_vector(struct runtime_checker *watch, const c205 *machine,
                          struct site *site)
{
    bool due = should_sample(site);
    view_fill(&site->view, machine);
    for (size_t i = 0; i < site->view.count; i++) {
        const struct operand_view *operand = &site->view.operands[i];
        bool result = operand->field != 'Z' && strchr("dDeq", operand->letter);
        if (!operand->is_vector || operand->is_bad
            || (site->is_handed && operand->number == site->is_handed && !result))
            continue;
        if (has_length(operand))
            check_length(watch, site, operand);
        if (result && !site->hands_over)
            check_storage(watch, site, operand);
        if (operand->letter == 'l' && due)
            check_indices(watch, machine, site, operand);
    }
    if (site->view.insn->format == C205_FORMAT_PERIODIC
        || site->view.insn->format == C205_FORMAT_SPACED)
        check_period(watch, site, &site->view.operands[0]);
    if (site->rule != PRECISION_FULL && due)
        check_numbers(watch, machine, site);
}

/* Checks that a result fits in its storage if the instruction has set its length. */
static void after_vector(struct runtime_checker *watch, const c205 *machine,
                         struct site *site)
{
    view_fill(&site->view, machine);
    for (size_t i = 0; i < site->view.count; i++)
        if (strchr("cCo", site->view.operands[i].letter)
            && !site->view.operands[i].is_bad)
            check_storage(watch, site, &site->view.operands[i]);
}

static bool recurs(const struct operand_view *read, const struct operand_view *written)
{
    return strchr("vVuU", read->letter) && read->is_vector && !read->is_bad
           && read->address < written->address
           && written->address < read->address + (uint64_t)read->length * read->width;
}

/* Reports a result that is also a source of the same instruction. For a linked pair,
 * the report is for the prefix LINKV and does not name the source. */
void runtime_recurrence(struct runtime_checker *watch, const c205 *machine,
                        struct site *site, size_t elements)
{
    const struct instruction_view *view = &site->view;
    const struct operand_view *read = NULL, *written;
    struct text_line source = { "", 0 };
    struct sink sink = text_line_sink(&source);
    view_fill(&site->view, machine);
    written = view_find(view, "dDe");
    for (size_t i = 0; written && i < view->count; i++)
        if (recurs(&view->operands[i], written))
            read = &view->operands[i];
    sink_print(&sink, read ? "[r%u]" : "a source", read ? read->number : 0);
    runtime_report(watch, site, WARNING_RECURRENCE,
                   "%zu element%s of %s %s of this %s, and %s; the result on the real "
                   "machine is undefined",
                   elements, plural(elements), source.text,
                   elements == 1 ? "is a result" : "are results",
                   !read && view->insn->timing == C205_TIMING_vlink ? "pair"
                                                                    : "instruction",
                   elements == 1 ? "waits for it" : "wait for them one by one");
}

/* Checks the two instructions after the prefix, which run as one stream. */
static void before_link(struct runtime_checker *watch, const c205 *machine,
                        struct site *site)
{
    uint64_t pc = site->view.pc + 32 * (uint64_t)site->view.halves;
    struct site *first = runtime_site(watch, machine, pc), *second;
    pc += 32 * (uint64_t)first->view.halves;
    second = runtime_site(watch, machine, pc);
    if (!first->view.insn || !second->view.insn
        || !c205_unit_links(first->view.insn->unit)
        || !c205_unit_links(second->view.insn->unit))
        return;
    first->hands_over = second->is_handed = first->view.fields.c;
    first->before(watch, machine, first);
    second->before(watch, machine, second);
    first->hands_over = second->is_handed = 0;
}

static void before_memory(struct runtime_checker *watch, const c205 *machine,
                          struct site *site)
{
    const struct operand_view *operands = site->view.operands;
    unsigned width = isupper((unsigned char)operands[2].letter) ? 32 : 64;
    if (operands[1].number == 0)
        return;
    view_fill(&site->view, machine);
    check_index(watch, site, &operands[1], "index");
    if (tolower((unsigned char)operands[2].letter) == 'i')
        check_store(watch, site, c205_descriptor_address(operands[0].word),
                    c205_to_integer(operands[1].word), width);
}

static void before_enter(struct runtime_checker *watch, const c205 *machine,
                         struct site *site)
{
    unsigned r = site->view.operands[0].number;
    (void)machine;
    watch->is_entered[r] = true;
    watch->entered[r] = c205_descriptor_address((c205_word)site->view.fields.immediate);
}

static void before_length(struct runtime_checker *watch, const c205 *machine,
                          struct site *site)
{
    unsigned r = site->view.operands[0].number;
    watch->is_emptied[r] = (site->view.fields.immediate & 0xFFFF) == 0;
    watch->emptied[r] = c205_descriptor_address(c205_register(machine, r));
    watch->is_entered[r] = false;
}

/* Chooses the checks of an instruction. The precision of a SPARSE instruction is not
 * checked, because the checks do not determine the elements that its order vectors
 * select. */
void site_choose(struct site *site)
{
    const c205_insn *insn = site->view.insn;
    site->rule = insn->format == C205_FORMAT_SPARSE ? PRECISION_FULL
                                                    : precision_rule(insn);
    if (insn->timing == C205_TIMING_vlink)
        site->before = before_link;
    else if (c205_unit_is_vector(insn->unit))
        site->before = before_vector;
    else if (site->rule != PRECISION_FULL)
        site->before = before_scalar;
    else if (insn->format == C205_FORMAT_MEMORY)
        site->before = before_memory;
    else if (strcmp(insn->mnemonic, "ES") == 0 || strcmp(insn->mnemonic, "EX") == 0)
        site->before = before_enter;
    else if (strcmp(insn->mnemonic, "ELEN") == 0)
        site->before = before_length;
    if (c205_unit_is_vector(insn->unit) && view_find(&site->view, "cCo"))
        site->after = after_vector;
}
