/* image_file.c - finds, reads and decodes the image files that a scene names. */
#include "rt/scene/language/image_file.h"

#include "rt/scene/language/string_value.h"

#include <stdlib.h>

/* The keywords of the image kinds. RASTER_KINDS marks an unsupported kind. */
static const struct image_word {
    const char *word;
    enum raster_kind kind;
} image_words[] = {
    { "bmp", RASTER_BMP },   { "exr", RASTER_KINDS }, { "gif", RASTER_GIF },
    { "hdr", RASTER_KINDS }, { "iff", RASTER_KINDS }, { "jpeg", RASTER_JPEG },
    { "pgm", RASTER_PGM },   { "png", RASTER_PNG },   { "pot", RASTER_KINDS },
    { "ppm", RASTER_PPM },   { "sys", RASTER_KINDS }, { "tga", RASTER_TGA },
    { "tiff", RASTER_TIFF },
};

const char *image_kind_unsupported(const struct reader *reader)
{
    const struct image_word *word = TOKEN_ROW(&reader->token, image_words);
    return word && word->kind == RASTER_KINDS ? word->word : NULL;
}

/* Finds the file. As in POV-Ray, a keyword that does not match the file is an error. */
static bool find_file(struct reader *reader, const struct image_word *word,
                      const char *name, struct image_file *file)
{
    const struct scene_source *source = reader_find(reader, &file->at, name, false);
    if (!source)
        return false;
    if (source->length == 0)
        return reader_fault(reader, &file->at, "the file is empty");
    file->source = source;
    file->kind = raster_kind_of(source->text, source->length);
    if (word && word->kind != file->kind)
        return reader_fault(reader, &file->at,
                            "the file is not an image of the kind '%s'", word->word);
    return true;
}

bool image_file_read(struct reader *reader, const char *expected,
                     struct image_file *file)
{
    const struct image_word *word = TOKEN_ROW(&reader->token, image_words);
    char *name;
    bool done;
    if (word && word->kind == RASTER_KINDS)
        return reader_fault(reader, &reader->token,
                            "images of the kind '%s' are not supported", word->word);
    if (word)
        reader_next(reader);
    if (!starts_string(reader))
        return reader_expected(reader, word ? "the name of an image" : expected);
    file->at = reader->token;
    if (!file_name_read(reader, &name))
        return false;
    done = find_file(reader, word, name, file);
    free(name);
    return done;
}

bool image_file_pixels(struct reader *reader, const struct image_file *file,
                       const char *bytes, struct raster *raster)
{
    raster_reader *reads = reader->options ? reader->options->read_raster : NULL;
    c205_error error;
    return raster_read(file->kind, bytes, file->source->length, reads, raster, &error)
           || reader_fault(reader, &file->at, "cannot read the image: %s",
                           error.message);
}
