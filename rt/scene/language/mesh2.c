/* mesh2.c - parses mesh2: lists of vectors and textures, and faces that refer to
 * them. */
#include "rt/scene/language/scene_mesh.h"

#include "base/array.h"
#include "base/plural.h"
#include "rt/scene/language/scene_expression.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The sections of mesh2. The sections with vectors are the first. */
enum section {
    SECTION_VERTICES,
    SECTION_NORMALS,
    SECTION_UVS,
    SECTION_VECTORS, /* number of sections with vectors */
    SECTION_TEXTURES = SECTION_VECTORS,
    SECTION_FACES,
    SECTION_UV_INDICES,
    SECTION_NORMAL_INDICES,
    SECTIONS
};

struct section_vectors {
    size_t count;
    double (*list)[3];
};

struct mesh2_reading {
    struct mesh_reading mesh; /* first member: the subject of the modifiers */
    struct section_vectors vectors[SECTION_VECTORS];
    size_t texture_count;
    struct texture *textures;

    enum section section; /* the section that is being read */
    size_t row;           /* current row of the section */
    bool given[SECTIONS];
    int rank;         /* rank of the last section in the required order */
    const char *last; /* keyword of the last section */
    bool faulty;      /* a section had an error, so elements may be missing */
};

typedef bool row_reader(struct reader *reader, struct mesh2_reading *mesh);

/* ---- Vectors and textures ------------------------------------------------ */

static bool read_into(struct reader *reader, struct section_vectors *vectors)
{
    double vector[3];
    if (!read_vector(reader, vector))
        return false;
    if (!array_add(&vectors->list, &vectors->count, vector, sizeof vector))
        return reader_no_memory(reader);
    reader_comma(reader);
    return true;
}

static bool read_plain(struct reader *reader, struct mesh2_reading *mesh)
{
    return read_into(reader, &mesh->vectors[mesh->section]);
}

static bool read_normal(struct reader *reader, struct mesh2_reading *mesh)
{
    struct section_vectors *normals = &mesh->vectors[SECTION_NORMALS];
    struct scene_token at = reader->token;
    if (!read_into(reader, normals))
        return false;
    mesh_direct(reader, &at, normals->list[normals->count - 1]);
    return true;
}

static bool read_texture(struct reader *reader, struct mesh2_reading *mesh)
{
    struct texture texture = reader->default_texture;
    if (!reader_accept(reader, "texture"))
        return reader_expected(reader, "a texture");
    if (!texture_read(reader, &texture))
        return false;
    if (!array_add(&mesh->textures, &mesh->texture_count, &texture, sizeof texture))
        return reader_no_memory(reader);
    reader_comma(reader);
    return true;
}

/* ---- Faces --------------------------------------------------------------- */

/* Converts a number to an index. As in POV-Ray, it is truncated. */
static bool take_index(struct reader *reader, const struct mesh2_reading *mesh,
                       const struct scene_token *at, const char *what, double number,
                       size_t count, size_t *index)
{
    double whole = trunc(number);
    if (whole >= 0 && whole < (double)count) {
        *index = (size_t)whole;
        return true;
    }
    return !mesh->faulty
           && reader_fault(reader, at,
                           "a face has the %s %.15g, but there are only %zu", what,
                           whole, count);
}

static bool read_indices(struct reader *reader, const struct mesh2_reading *mesh,
                         const char *what, size_t count, size_t indices[3])
{
    struct scene_token at = reader->token;
    double numbers[3];
    if (!read_vector(reader, numbers))
        return false;
    for (int i = 0; i < 3; i++)
        if (!take_index(reader, mesh, &at, what, numbers[i], count, &indices[i]))
            return false;
    reader_comma(reader);
    return true;
}

/* Returns true if the current token starts a float. Like POV-Ray, the parser
 * distinguishes a texture index from the next face by the first token. */
static bool at_float(const struct reader *reader)
{
    const struct scene_value *value = reader_value_of(reader, VALUE_NUMBERS);
    if (value)
        return value->is.numbers.count == 1;
    return starts_expression(reader) && !reader_at_sign(reader, '<');
}

static bool read_look(struct reader *reader, struct mesh2_reading *mesh)
{
    struct scene_token at = reader->token;
    double number;
    size_t index = 0;
    if (!read_number(reader, &number)
        || !take_index(reader, mesh, &at, "texture", number, mesh->texture_count,
                       &index))
        return false;
    mesh_look(&mesh->mesh, &mesh->textures[index], &at);
    reader_comma(reader);
    return true;
}

/* Reads the textures of a face: none, one, or one for each corner. */
static bool read_looks(struct reader *reader, struct mesh2_reading *mesh)
{
    int count = 0;
    for (; count < 3 && at_float(reader); count++)
        if (!read_look(reader, mesh))
            return false;
    return count != 2
           || reader_fault(reader, &reader->token,
                           "a face has one texture or three, not two");
}

static void take_normals(const struct mesh2_reading *mesh, const size_t indices[3],
                         struct triangle *triangle)
{
    const struct section_vectors *normals = &mesh->vectors[SECTION_NORMALS];
    for (int i = 0; i < 3; i++)
        memcpy(triangle->normals[i], normals->list[indices[i]],
               sizeof triangle->normals[i]);
    triangle->smooth = mesh_is_smooth(triangle);
}

/* Reads a face of mesh2. If there are as many normals as vertices, a normal has the
 * index of its vertex, unless normal_indices overrides it. */
static bool read_face(struct reader *reader, struct mesh2_reading *mesh)
{
    const struct section_vectors *vertices = mesh->vectors + SECTION_VERTICES;
    struct scene_token at = reader->token;
    struct triangle triangle = { .smooth = false };
    size_t indices[3];
    if (at_float(reader))
        return reader_expected(reader, "the three vertices of a face");
    if (!read_indices(reader, mesh, "vertex", vertices->count, indices))
        return false;
    for (int i = 0; i < 3; i++)
        memcpy(triangle.corners[i], vertices->list[indices[i]],
               sizeof triangle.corners[i]);
    if (mesh->vectors[SECTION_NORMALS].count == vertices->count)
        take_normals(mesh, indices, &triangle);
    return read_looks(reader, mesh) && mesh_add(reader, &mesh->mesh, &triangle, &at);
}

/* Reads the uv indices of a face, which are not used. If uv_vectors is missing, POV-Ray
 * assumes a single vector. */
static bool read_uv_index(struct reader *reader, struct mesh2_reading *mesh)
{
    size_t count = mesh->vectors[SECTION_UVS].count, ignored[3];
    return read_indices(reader, mesh, "uv vector", count ? count : 1, ignored);
}

/* Reads the indices of a face's normals. As in POV-Ray, the last faces may have none;
 * these faces are flat. */
static bool read_normal_index(struct reader *reader, struct mesh2_reading *mesh)
{
    struct triangles *triangles = &mesh->mesh.triangles;
    size_t indices[3];
    if (!read_indices(reader, mesh, "normal", mesh->vectors[SECTION_NORMALS].count,
                      indices))
        return false;
    if (mesh->row < triangles->count)
        take_normals(mesh, indices, &triangles->list[mesh->row]);
    return true;
}

/* ---- Sections ------------------------------------------------------------ */

/* The rules of the sections, in the order of enum section. `rank` is the position in
 * the required order. */
static const struct section_rule {
    const char *word;
    row_reader *row;
    int rank;
    int least;          /* minimum number of rows */
    enum section after; /* section that must precede this one; itself: none */
} rules[SECTIONS] = {
    { "vertex_vectors", read_plain, 0, 1, SECTION_VERTICES },
    { "normal_vectors", read_normal, 0, 0, SECTION_NORMALS },
    { "uv_vectors", read_plain, 0, 0, SECTION_UVS },
    { "texture_list", read_texture, 1, 0, SECTION_VERTICES },
    { "face_indices", read_face, 2, 1, SECTION_VERTICES },
    { "uv_indices", read_uv_index, 3, 0, SECTION_FACES },
    { "normal_indices", read_normal_index, 3, 0, SECTION_FACES },
};
enum { RANK_INSIDE = 4 };

/* Checks that the sections of mesh2 have the order that POV-Ray requires. If a section
 * of vectors is repeated, POV-Ray uses the second; here it is an error. */
static bool check_order(struct reader *reader, const struct mesh2_reading *mesh,
                        enum section section, const struct scene_token *at)
{
    const struct section_rule *rule = &rules[section];
    if (mesh->given[section])
        return reader_fault(reader, at, "'%s' is already defined in this mesh2",
                            rule->word);
    if (rule->rank < mesh->rank)
        return reader_fault(reader, at, "'%s' must be before '%s'", rule->word,
                            mesh->last);
    if (rule->after == section || mesh->given[rule->after])
        return true;
    return !mesh->faulty
           && reader_fault(reader, at, "'%s' must be before '%s'",
                           rules[rule->after].word, rule->word);
}

/* Checks the number of rows of a section. uv_indices has one row for each face,
 * normal_indices at most one. */
static bool check_count(struct reader *reader, const struct mesh2_reading *mesh,
                        enum section section, const struct scene_token *at,
                        size_t count)
{
    size_t faces = mesh->mesh.triangles.count;
    bool fits = section == SECTION_UV_INDICES       ? count == faces
                : section == SECTION_NORMAL_INDICES ? count <= faces
                                                    : true;
    return fits || mesh->faulty
           || reader_fault(reader, at, "%zu '%s' cannot match %zu face%s", count,
                           rules[section].word, faces, plural(faces));
}

static bool read_count(struct reader *reader, const struct mesh2_reading *mesh,
                       enum section section, size_t *count)
{
    const struct section_rule *rule = &rules[section];
    struct scene_token at = reader->token;
    double number;
    if (!read_number(reader, &number))
        return false;
    reader_comma(reader);
    if (number < rule->least || number != floor(number))
        return reader_fault(reader, &at, "the number of '%s' must be an integer %s 0",
                            rule->word, rule->least ? "above" : "of at least");
    if (number > MAX_TRIANGLES)
        return reader_fault(reader, &at, "more than %d '%s'", MAX_TRIANGLES,
                            rule->word);
    *count = (size_t)number;
    return check_count(reader, mesh, section, &at, *count);
}

static bool read_rows(struct reader *reader, struct mesh2_reading *mesh,
                      enum section section)
{
    size_t count = 0;
    if (!read_count(reader, mesh, section, &count))
        return false;
    for (mesh->row = 0; mesh->row < count; mesh->row++) {
        if (reader_at_sign(reader, '}'))
            return reader_fault(reader, &reader->token, "found only %zu of %zu '%s'",
                                mesh->row, count, rules[section].word);
        if (!rules[section].row(reader, mesh))
            return false;
    }
    return true;
}

static void make_flat(struct triangles *triangles)
{
    for (size_t i = 0; i < triangles->count; i++)
        triangles->list[i].smooth = false;
}

static bool read_block(struct reader *reader, struct mesh2_reading *mesh,
                       enum section section)
{
    struct block block;
    mesh->section = section;
    mesh->given[section] = true;
    mesh->rank = rules[section].rank;
    mesh->last = rules[section].word;
    if (section == SECTION_NORMAL_INDICES)
        make_flat(&mesh->mesh.triangles);
    return block_open(reader, &block, '{')
           && mesh_close(reader, &block, read_rows(reader, mesh, section));
}

static bool read_section(struct reader *reader, const struct item *item)
{
    const struct section_rule *rule = TOKEN_ROW(&item->at, rules);
    enum section section = (enum section)(rule - rules);
    struct mesh2_reading *mesh = item->subject;
    bool done = check_order(reader, mesh, section, &item->at)
                && read_block(reader, mesh, section);
    mesh->faulty |= !done;
    return done;
}

static bool read_inside(struct reader *reader, const struct item *item)
{
    struct mesh2_reading *mesh = item->subject;
    mesh->rank = RANK_INSIDE;
    mesh->last = item->keyword->words;
    return read_inside_vector(reader, item);
}

static const struct keyword words[] = {
    { "vertex_vectors normal_vectors uv_vectors texture_list face_indices uv_indices "
      "normal_indices",
      read_section, 0 },
    { "inside_vector", read_inside, 0 },
    { NULL, NULL, 0 },
};

static const struct grammar grammar = { "a keyword of mesh2 or an object modifier",
                                        { words },
                                        .then = &modifier_grammar };

/* ---- The statement ------------------------------------------------------- */

/* Reports missing indices: vectors need indices if there are more than `most` of them,
 * unless there is one vector for each vertex. */
static bool check_indices(struct reader *reader, const struct mesh2_reading *mesh,
                          enum section of, enum section indices, size_t most)
{
    size_t count = mesh->vectors[of].count;
    size_t vertices = mesh->vectors[SECTION_VERTICES].count;
    return mesh->given[indices] || count <= most || count == vertices
           || reader_fault(reader, &mesh->mesh.at,
                           "'%s' is missing: there are %zu '%s', but %zu vertices",
                           rules[indices].word, count, rules[of].word, vertices);
}

static bool check_sections(struct reader *reader, const struct mesh2_reading *mesh)
{
    static const enum section needed[] = { SECTION_VERTICES, SECTION_FACES };
    for (size_t i = 0; i < sizeof needed / sizeof *needed; i++)
        if (!mesh->given[needed[i]])
            return reader_fault(reader, &mesh->mesh.at, "'%s' is missing",
                                rules[needed[i]].word);
    return check_indices(reader, mesh, SECTION_NORMALS, SECTION_NORMAL_INDICES, 0)
           && check_indices(reader, mesh, SECTION_UVS, SECTION_UV_INDICES, 1);
}

bool mesh2_read(struct reader *reader, struct scene_object *object,
                const struct item *item)
{
    struct mesh2_reading mesh;
    struct block block;
    bool good;
    memset(&mesh, 0, sizeof mesh);
    good = mesh_begin(reader, &mesh.mesh, item) && block_open(reader, &block, '{')
           && block_items(reader, &block, &grammar, &mesh, true)
           && check_sections(reader, &mesh);
    for (size_t i = 0; i < SECTION_VECTORS; i++)
        free(mesh.vectors[i].list);
    free(mesh.textures);
    return mesh_end(reader, &mesh.mesh, good, object);
}
