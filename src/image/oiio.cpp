/* OpenImageIO behind a C interface (see oiio.h); built as the plug-in roughlight-oiio.so. */
#include "image/oiio.h"

#include <cstdio>
#include <cstring>
#include <memory>
#include <new>
#include <string>
#include <vector>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

namespace
{

int fail(rl_error *error, rl_status status, const char *message)
{
    if (error) {
        error->status = status;
        std::snprintf(error->message, sizeof error->message, "%s", message);
    }
    return status;
}

/* OpenImageIO sometimes fails without a word. */
int fail(rl_error *error, const std::string &message)
{
    return fail(error, RL_ERR_INPUT, message.empty() ? "no reason given" : message.c_str());
}

/* Calls f, which returns a status, and turns exceptions into errors. */
template <typename F> int guarded(rl_error *error, F f)
{
    try {
        return f();
    } catch (const std::bad_alloc &) {
        return fail(error, RL_ERR_SYSTEM, "out of memory");
    } catch (const std::exception &e) {
        return fail(error, std::string(e.what()));
    } catch (...) {
        return fail(error, std::string("unknown exception"));
    }
}

/* Thread pools would take longer to start than our images take to pack. Stored so that it happens once. */
bool quieten()
{
    return OIIO::attribute("threads", 1) && OIIO::attribute("exr_threads", -1);
}

void version(char text[64])
{
    std::snprintf(text, 64, "%d.%d.%d", OIIO_VERSION_MAJOR, OIIO_VERSION_MINOR, OIIO_VERSION_PATCH);
}

void describe(rl_oiio_header *header, const OIIO::ImageSpec &spec)
{
    *header = rl_oiio_header{};
    header->width = spec.full_width;
    header->height = spec.full_height;
    header->x = static_cast<long long>(spec.x) - spec.full_x;
    header->y = static_cast<long long>(spec.y) - spec.full_y;
    header->stored_width = spec.width;
    header->stored_height = spec.height;
    header->channels = spec.nchannels;
    for (int i = 0; i < spec.nchannels && i < RL_IMAGE_CHANNELS_MAX; i++)
        std::snprintf(header->channel_name[i], sizeof header->channel_name[i], "%s",
                      spec.channel_name(i).c_str());
    header->has_depth = spec.deep || spec.depth > 1;
    header->integers = !spec.format.is_floating_point();
    header->unassociated_alpha = spec.get_int_attribute("oiio:UnassociatedAlpha");
    header->gamma = spec.get_float_attribute("oiio:Gamma");
    std::snprintf(header->colour_space, sizeof header->colour_space, "%s",
                  spec.get_string_attribute("oiio:ColorSpace").c_str());
}

int open(void **reader, rl_oiio_header *header, const char *path, rl_error *error)
{
    return guarded(error, [&]() -> int {
        static const bool quiet = quieten();
        (void)quiet;
        OIIO::ImageSpec wishes;
        wishes.attribute("oiio:UnassociatedAlpha", 1);
        std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(path, &wishes);
        if (!input)
            return fail(error, OIIO::geterror());
        describe(header, input->spec());
        *reader = input.release();
        return RL_OK;
    });
}

void attributes(void *reader, rl_oiio_attribute_visitor *visit, void *user)
{
    guarded(nullptr, [&]() -> int {
        for (const OIIO::ParamValue &p : static_cast<OIIO::ImageInput *>(reader)->spec().extra_attribs) {
            const OIIO::TypeDesc type = p.type();
            if (type == OIIO::TypeDesc::STRING)
                visit(user, p.name().c_str(), p.get_string().c_str(), 0.0);
            else if (type == OIIO::TypeDesc::DOUBLE)
                visit(user, p.name().c_str(), nullptr, *static_cast<const double *>(p.data()));
            else if (type.numelements() == 1 && type.aggregate == OIIO::TypeDesc::SCALAR &&
                     (type.is_floating_point() || type.basetype == OIIO::TypeDesc::INT))
                visit(user, p.name().c_str(), nullptr, p.get_float());
        }
        return RL_OK;
    });
}

int read(void *reader, float *data, rl_error *error)
{
    return guarded(error, [&]() -> int {
        auto *input = static_cast<OIIO::ImageInput *>(reader);
        if (!input->read_image(0, 0, 0, input->spec().nchannels, OIIO::TypeDesc::FLOAT, data))
            return fail(error, input->geterror());
        return RL_OK;
    });
}

void close(void *reader)
{
    guarded(nullptr, [&]() -> int {
        delete static_cast<OIIO::ImageInput *>(reader);
        return RL_OK;
    });
}

OIIO::ImageSpec specify(const rl_image &image, bool png)
{
    OIIO::ImageSpec spec(image.width, image.height, image.channels,
                         png ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::FLOAT);
    spec.alpha_channel = -1;
    for (int i = 0; i < image.channels; i++) {
        spec.channelnames[static_cast<size_t>(i)] = image.channel_name[i];
        if (std::strcmp(image.channel_name[i], "A") == 0)
            spec.alpha_channel = i;
    }
    if (png) {
        spec.attribute("oiio:ColorSpace", "sRGB");
        spec.attribute("oiio:UnassociatedAlpha", 1);
    } else {
        spec.attribute("compression", "zip");
        /* The EXR writer puts in the time of day where there is no date; an empty one is read back as none.
         */
        spec.attribute("DateTime", "");
    }
    for (size_t i = 0; i < image.n_attributes; i++) {
        const rl_attribute &a = image.attribute[i];
        if (a.string) {
            spec.attribute(a.name, a.string);
        } else if (png) {
            char text[32];
            std::snprintf(text, sizeof text, "%.17g", a.number);
            spec.attribute(a.name, text);
        } else if (std::strcmp(a.name, "whiteLuminance") == 0) {
            /* Of OpenEXR's own attributes, which other programs expect in the type that it says. */
            spec.attribute(a.name, static_cast<float>(a.number));
        } else {
            spec.attribute(a.name, OIIO::TypeDesc::DOUBLE, &a.number);
        }
    }
    return spec;
}

int encode(const char *format, const rl_image *image, const void *pixels, rl_oiio_sink *sink, void *user,
           rl_error *error)
{
    return guarded(error, [&]() -> int {
        static const bool quiet = quieten();
        (void)quiet;
        const bool png = std::strcmp(format, "png") == 0;
        const OIIO::ImageSpec spec = specify(*image, png);
        std::vector<unsigned char> bytes;
        OIIO::Filesystem::IOVecOutput memory(bytes);
        std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(format);
        if (!output)
            return fail(error, OIIO::geterror());
        /* The name is for the messages; nothing is written there. */
        if (!output->set_ioproxy(&memory) || !output->open(std::string("image.") + format, spec) ||
            !output->write_image(spec.format, pixels) || !output->close())
            return fail(error, output->geterror());
        return sink(user, bytes.data(), bytes.size(), error);
    });
}

} // namespace

extern "C" __attribute__((visibility("default"))) const rl_oiio rl_oiio_interface = {
    RL_OIIO_INTERFACE, version, open, attributes, read, close, encode,
};
