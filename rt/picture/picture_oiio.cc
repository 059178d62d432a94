// picture_oiio.cc - adapts picture.c to OpenImageIO.
//
// The result is a shared object that exports one table of functions. No exception
// leaves this file: exceptions of the library become error messages.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

extern "C" {
#include "rt/picture/picture_oiio.h"
extern const struct picture_adapter rt205_picture_adapter;
}

namespace
{

// The environment variable with the date of reproducible builds, in seconds since 1970
// (reproducible-builds.org/specs/source-date-epoch).
const char date_variable[] = "SOURCE_DATE_EPOCH";

// JPEG settings for an accurate copy of the frame.
const char jpeg_compression[] = "jpeg:98";
const char jpeg_subsampling[] = "4:4:4";

// The value of PhotometricInterpretation in TIFF 6.0 for pixels that are indices into a
// colour table.
const int TIFF_PALETTE = 3;

void require(bool good, const std::string &message)
{
    if (!good)
        throw std::runtime_error(message.empty() ? "the file is damaged" : message);
}

// Runs the body. Converts an exception to its message and returns false.
template <class Error, class Body> bool guarded(Error *error, Body body)
{
    try {
        OIIO::attribute("threads", 1);
        OIIO::attribute("debug", 0);
        body();
        return true;
    } catch (const std::exception &caught) {
        std::snprintf(error->message, sizeof error->message, "%s", caught.what());
    } catch (...) {
        std::snprintf(error->message, sizeof error->message, "unknown error");
    }
    return false;
}

OIIO::TypeDesc type_of(sample_format format)
{
    switch (format) {
    case SAMPLE_BYTE: return OIIO::TypeDesc::UINT8;
    case SAMPLE_HALF: return OIIO::TypeDesc::HALF;
    default: return OIIO::TypeDesc::FLOAT;
    }
}

// Sets the date of a picture only if one is specified, so that the same frame always
// gives the same file. Without a DateTime attribute the library would write the current
// time. It ignores a number, because a number is not a date, so 0 suppresses the date.
void annotate_date(OIIO::ImageSpec &spec)
{
    const char *text = std::getenv(date_variable);
    char *end = nullptr, date[32];
    const std::time_t seconds = text ? std::strtoll(text, &end, 10) : 0;
    const std::tm *utc = std::gmtime(&seconds);
    spec.attribute("DateTime", 0);
    if (text && end > text && *end == '\0' && utc
        && std::strftime(date, sizeof date, "%Y:%m:%d %H:%M:%S", utc) > 0)
        spec.attribute("DateTime", date);
}

void annotate(OIIO::ImageSpec &spec, const picture_note *notes)
{
    std::string description;
    for (; notes && notes->name; notes++) {
        spec.attribute(notes->name, notes->text);
        description += std::string(notes->name) + ": " + notes->text + "\n";
    }
    if (!description.empty())
        spec.attribute("ImageDescription", description);
    annotate_date(spec);
}

OIIO::ImageSpec spec_of(const picture_image &image)
{
    const int channels = static_cast<int>(image.channels);
    OIIO::ImageSpec spec(static_cast<int>(image.width), static_cast<int>(image.height),
                         channels, type_of(image.format[image.channels - 1]));
    spec.channelnames.assign(image.names, image.names + channels);
    for (int i = 0; i < channels; i++)
        spec.channelformats.push_back(type_of(image.format[i]));
    spec.alpha_channel = -1;
    spec.attribute("oiio:ColorSpace", image.srgb ? "sRGB" : "Linear");
    spec.attribute("Compression", image.srgb ? jpeg_compression : "zip");
    spec.attribute("jpeg:subsampling", jpeg_subsampling);
    return spec;
}

// A file whose writes never fail. The library cannot handle a full disk; its JPEG code
// would end the process. The owner of the file checks for errors at the end.
struct patient_file : OIIO::Filesystem::IOFile {
    explicit patient_file(std::FILE *to) : IOFile(to, OIIO::Filesystem::IOProxy::Write)
    {
    }
    // With the standard name, the JPEG code would not use this class.
    const char *proxytype() const override
    {
        return "patient";
    }
    std::size_t write(const void *bytes, std::size_t count) override
    {
        IOFile::write(bytes, count);
        return count;
    }
};

// The state of a picture that is being written.
struct writing {
    writing(const char *path, std::FILE *to)
        : file(to), output(OIIO::ImageOutput::create(path, &file))
    {
    }
    patient_file file;
    std::unique_ptr<OIIO::ImageOutput> output;
};

void *begin(const char *path, const picture_image *image, const picture_note *notes,
            FILE *file, c205_error *error)
{
    std::unique_ptr<writing> picture;
    const bool good = guarded(error, [&] {
        picture.reset(new writing(path, file));
        auto &output = picture->output;
        require(output != nullptr, OIIO::geterror());
        OIIO::ImageSpec spec = spec_of(*image);
        annotate(spec, notes);
        if (!output->supports("channelformats"))
            spec.channelformats.clear();
        require(output->open(path, spec), output->geterror());
    });
    return good ? picture.release() : nullptr;
}

bool rows(void *given, size_t first, size_t last, const float *samples,
          c205_error *error)
{
    auto &output = static_cast<writing *>(given)->output;
    return guarded(error, [&] {
        require(output->write_scanlines(static_cast<int>(first), static_cast<int>(last),
                                        0, OIIO::TypeDesc::FLOAT, samples),
                output->geterror());
    });
}

bool end(void *given, bool whole, c205_error *error)
{
    std::unique_ptr<writing> picture(static_cast<writing *>(given));
    c205_error none;
    const bool good = guarded(
        whole ? error : &none,
        [&] { require(picture->output->close(), picture->output->geterror()); });
    guarded(&none, [&] { picture.reset(); });
    return good;
}

std::unique_ptr<OIIO::ImageInput> opened(const char *path)
{
    auto input = OIIO::ImageInput::open(path);
    require(input != nullptr, OIIO::geterror());
    return input;
}

// Returns the channel of the file with this name. Channels of TIFF files have no names.
// If such a file has the requested number of channels, they are taken in order.
int place_of(const OIIO::ImageSpec &spec, const picture_image &image, size_t channel)
{
    const int place = spec.channelindex(image.names[channel]);
    const bool named = spec.channelindex(image.names[CHANNEL_NORMAL_X]) >= 0;
    if (place < 0 && !named && spec.nchannels == static_cast<int>(image.channels))
        return static_cast<int>(channel);
    return place;
}

void pick(const OIIO::ImageSpec &spec, const std::vector<float> &file,
          picture_image &image)
{
    const size_t stride = static_cast<size_t>(spec.nchannels);
    const size_t pixels = image.width * image.height;
    for (size_t channel = 0; channel < image.channels; channel++) {
        const int place = place_of(spec, image, channel);
        require(place >= 0 || channel > CHANNEL_BLUE, "has no RGB colours");
        for (size_t i = 0; place >= 0 && i < pixels; i++)
            image.samples[i * image.channels + channel] =
                file[i * stride + static_cast<size_t>(place)];
    }
}

bool read(const char *path, picture_image *image, c205_error *error)
{
    image->samples = nullptr;
    const bool good = guarded(error, [&] {
        auto input = opened(path);
        const OIIO::ImageSpec &spec = input->spec();
        image->width = static_cast<size_t>(spec.width);
        image->height = static_cast<size_t>(spec.height);
        image->srgb = spec.get_string_attribute("oiio:ColorSpace") == "sRGB";
        const size_t pixels = image->width * image->height;
        std::vector<float> file(pixels * static_cast<size_t>(spec.nchannels));
        require(input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT,
                                  file.data()),
                input->geterror());
        image->samples = static_cast<float *>(
            std::calloc(pixels * image->channels, sizeof(float)));
        require(image->samples != nullptr, "out of memory");
        pick(spec, file, *image);
    });
    if (!good) {
        std::free(image->samples);
        image->samples = nullptr;
    }
    return good;
}

bool read_note(const char *path, const char *name, char *text, size_t size,
               c205_error *error)
{
    return guarded(
        error,
        [&] {
            auto input = opened(path);
            const std::string found = input->spec().get_string_attribute(name);
            std::snprintf(text, size, "%s", found.c_str());
        });
}

// Describes an image of grey or RGB pixels with an optional opacity.
void describe(const OIIO::ImageSpec &spec, raster &image)
{
    const size_t width = static_cast<size_t>(spec.width);
    const size_t height = static_cast<size_t>(spec.height);
    require(spec.width > 0 && spec.height > 0, "it has no pixels");
    require(width <= RASTER_PIXELS / height,
            "it has more than " + std::to_string(RASTER_PIXELS) + " pixels");
    require(spec.nchannels >= 1 && spec.nchannels <= 4,
            "it has more than four channels");
    require(spec.format == OIIO::TypeDesc::UINT8
                || spec.format == OIIO::TypeDesc::UINT16,
            "its samples must be integers of at most 16 bits");
    require(spec.get_int_attribute("tiff:PhotometricInterpretation") != TIFF_PALETTE,
            "its pixels are indices of a colour table, which is not supported in a "
            "TIFF file");
    image.width = width;
    image.height = height;
    image.channels = static_cast<size_t>(spec.nchannels);
    image.most = spec.format == OIIO::TypeDesc::UINT8 ? 255 : 65535;
}

void take_samples(OIIO::ImageInput &input, raster &image)
{
    const size_t count = image.width * image.height * image.channels;
    std::vector<uint16_t> samples(count);
    require(input.read_image(0, 0, 0, static_cast<int>(image.channels),
                             OIIO::TypeDesc::UINT16, samples.data()),
            input.geterror());
    image.samples = static_cast<uint16_t *>(std::calloc(count, sizeof *image.samples));
    require(image.samples != nullptr, "out of memory");
    for (size_t i = 0; i < count; i++)
        image.samples[i] = static_cast<uint16_t>(samples[i] * image.most / 65535);
}

bool read_raster(const char *format, const char *bytes, size_t length, raster *image,
                 c205_error *error)
{
    return guarded(
        error,
        [&] {
            OIIO::Filesystem::IOMemReader file(bytes, length);
            OIIO::ImageSpec how, spec;
            auto input = OIIO::ImageInput::create(format);
            require(input != nullptr, OIIO::geterror());
            how.attribute("oiio:UnassociatedAlpha", 1);
            require(input->set_ioproxy(&file), std::string("OpenImageIO cannot read '")
                                                   + format + "' from memory");
            require(input->open(format, spec, how), input->geterror());
            describe(spec, *image);
            take_samples(*input, *image);
            input->close();
        });
}

} // namespace

const struct picture_adapter rt205_picture_adapter = { begin, rows,      end,
                                                       read,  read_note, read_raster };
