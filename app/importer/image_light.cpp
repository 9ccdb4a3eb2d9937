// By Little CMS, relative to the media's white with black point compensation, as programs of pictures do.
#include "app/importer/image_light.h"

#include <lcms2.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>

namespace hairpaint::importer {

namespace {

using Profile = std::unique_ptr<void, decltype(&cmsCloseProfile)>;
using Transform = std::unique_ptr<void, decltype(&cmsDeleteTransform)>;

struct Kind
{
    cmsUInt32Number from;
    cmsUInt32Number to;
    cmsColorSpaceSignature space;
};

Kind kindOf(std::uint32_t channels, bool isCmyk)
{
    if (isCmyk)
        return {TYPE_CMYK_16, TYPE_RGB_16, cmsSigCmykData};
    switch (channels) {
    case 1:
        return {TYPE_GRAY_16, TYPE_RGB_16, cmsSigGrayData};
    case 2:
        return {TYPE_GRAYA_16, TYPE_RGBA_16, cmsSigGrayData};
    case 3:
        return {TYPE_RGB_16, TYPE_RGB_16, cmsSigRgbData};
    default:
        return {TYPE_RGBA_16, TYPE_RGBA_16, cmsSigRgbData};
    }
}

Transform transformOf(const std::vector<std::uint8_t>& bytes, const Kind& kind)
{
    Transform none(nullptr, cmsDeleteTransform);
    if (bytes.empty() || bytes.size() > (std::size_t{1} << 26U))
        return none;
    const Profile profile(cmsOpenProfileFromMem(bytes.data(), static_cast<cmsUInt32Number>(bytes.size())),
                          cmsCloseProfile);
    const Profile srgb(cmsCreate_sRGBProfile(), cmsCloseProfile);
    if (!profile || !srgb || cmsGetColorSpace(profile.get()) != kind.space)
        return none;
    return {cmsCreateTransform(profile.get(), kind.from, srgb.get(), kind.to, INTENT_RELATIVE_COLORIMETRIC,
                               cmsFLAGS_BLACKPOINTCOMPENSATION | cmsFLAGS_COPY_ALPHA | cmsFLAGS_NOCACHE),
            cmsDeleteTransform};
}

/// Whether it moves nothing by more than half a step of eight bits: sRGB by any name.
bool changesNothing(const Transform& transform, std::uint32_t channels)
{
    constexpr int kHalfStep = 128;
    constexpr std::array<std::uint16_t, 6> kLevels{0, 3000, 16384, 32768, 50000, 65535};
    const bool isGrey = channels <= 2;
    for (const std::uint16_t red : kLevels)
        for (const std::uint16_t green : kLevels)
            for (const std::uint16_t blue : kLevels) {
                if (isGrey && (green != red || blue != red))
                    continue;
                std::array<std::uint16_t, 4> from{red, green, blue, 65535};
                if (isGrey)
                    from[1] = 65535;
                std::array<std::uint16_t, 4> to{};
                cmsDoTransform(transform.get(), from.data(), to.data(), 1);
                const std::array<std::uint16_t, 3> wanted{red, green, blue};
                for (std::size_t i = 0; i < wanted.size(); ++i)
                    if (std::abs(int{to[i]} - int{wanted[i]}) > kHalfStep)
                        return false;
            }
    return true;
}

/// Without a profile: each ink takes away its own part of the light.
void mixInks(wire::Image& image)
{
    constexpr std::uint32_t kMost = 65535;
    std::size_t out = 0;
    for (std::size_t at = 0; at + 4 <= image.samples.size(); at += 4) {
        const std::uint32_t light = kMost - image.samples[at + 3];
        for (std::size_t i = 0; i < 3; ++i)
            image.samples[out++] = static_cast<std::uint16_t>((kMost - image.samples[at + i]) * light / kMost);
    }
    image.samples.resize(out);
    image.channels = 3;
}

} // namespace

void toSrgb(wire::Image& image, const std::vector<std::uint8_t>& profile, bool isCmyk)
{
    cmsSetLogErrorHandler([](cmsContext, cmsUInt32Number, const char*) {});
    const Kind kind = kindOf(image.channels, isCmyk);
    const Transform transform = transformOf(profile, kind);
    if (!transform) {
        if (isCmyk)
            mixInks(image);
        return;
    }
    if (!isCmyk && changesNothing(transform, image.channels))
        return;
    const std::uint32_t channels = isCmyk ? 3 : image.channels <= 2 ? image.channels + 2 : image.channels;
    std::vector<std::uint16_t> samples(std::size_t{image.width} * image.height * channels);
    for (std::uint32_t y = 0; y < image.height; ++y)
        cmsDoTransform(transform.get(), image.samples.data() + std::size_t{y} * image.width * image.channels,
                       samples.data() + std::size_t{y} * image.width * channels, image.width);
    image.samples = std::move(samples);
    image.channels = channels;
}

} // namespace hairpaint::importer
