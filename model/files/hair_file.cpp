// Writing Cem Yuksel's `.hair` format (http://www.cemyuksel.com/research/hairmodels): header, then one array after
// another: segments, points, thickness, transparency, colours.
#include "model/files/hair_file.h"

#include "model/files/atomic_file.h"
#include "model/srgb.h"
#include "sim/base/parallel.h"
#include "sim/groom/strand_curve.h"

#include <QLocale>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <span>

namespace hairpaint::model {

namespace {

constexpr quint32 kSegmentsFlag = 1;
constexpr quint32 kPointsFlag = 2;
constexpr quint32 kThicknessFlag = 4;
constexpr quint32 kTransparencyFlag = 8;
constexpr quint32 kColoursFlag = 16;
constexpr std::size_t kHeaderBytes = 128;
constexpr std::size_t kTextBytes = 88;
constexpr std::size_t kPointBytes = 32;                   ///< Place, thickness, transparency, colour.
constexpr std::size_t kMostHairFileBytes = 2'000'000'000; ///< More is no file that anyone can use.
constexpr const char* kText = "Hair Paint: metres, y up, face toward +z; root to tip; thickness is the diameter in m";
static_assert(std::endian::native == std::endian::little, "arrays are written as they lie in memory");

/// One strand to be written and where its points stand among all.
struct Strand
{
    std::size_t group = 0;
    std::uint32_t slot = 0;
    int segments = 0;
    std::size_t firstPoint = 0;
    [[nodiscard]] std::size_t endPoint() const { return firstPoint + static_cast<std::size_t>(segments) + 1; }
};

const sim::StrandStyle& styleOf(const sim::StrandFrame& frame, const Strand& strand)
{
    return frame.groups[strand.group].groom->style(strand.slot);
}

std::vector<Strand> collectStrands(const sim::StrandFrame& frame)
{
    std::vector<Strand> strands;
    std::size_t points = 0;
    for (std::size_t group = 0; group < frame.groups.size(); ++group) {
        const sim::Groom& groom = *frame.groups[group].groom;
        if (!groom.visible || groom.roots == nullptr)
            continue;
        for (const std::uint32_t slot : groom.roots->slotOfRank) {
            if (!groom.isDrawn(slot))
                continue;
            Strand strand{.group = group, .slot = slot, .firstPoint = points};
            strand.segments = std::max(1, sim::segmentsOf(styleOf(frame, strand), groom.nodes));
            points += static_cast<std::size_t>(strand.segments) + 1;
            strands.push_back(strand);
        }
    }
    return strands;
}

void skeletonOf(const sim::GroupFrame& group, std::uint32_t slot, std::vector<glm::vec3>& nodesWo)
{
    nodesWo.resize(static_cast<std::size_t>(group.groom->nodes));
    group.groom->blocks().read(group.positions, group.groom->frameStrand(slot), nodesWo);
}

/// The curves of some strands, points one after another.
std::vector<glm::vec3> evaluate(const sim::StrandFrame& frame, std::span<const Strand> strands)
{
    const std::size_t firstPoint = strands.front().firstPoint;
    std::vector<glm::vec3> points(strands.back().endPoint() - firstPoint);
    constexpr std::size_t kGrain = 256;
    sim::parallelFor(strands.size(), kGrain, [&](std::size_t begin, std::size_t end) {
        std::vector<glm::vec3> skeleton;
        std::vector<glm::vec3> curve;
        for (std::size_t i = begin; i < end; ++i) {
            const Strand& strand = strands[i];
            const sim::GroupFrame& group = frame.groups[strand.group];
            skeletonOf(group, strand.slot, skeleton);
            const glm::vec3 tangentWo = frame.pose.rotation * sim::frameTangentHd(*group.groom, strand.slot);
            sim::evaluateStrand(skeleton, tangentWo, styleOf(frame, strand), strand.segments, curve);
            const std::size_t count = std::min(curve.size(), static_cast<std::size_t>(strand.segments) + 1);
            std::copy_n(curve.begin(), count,
                        points.begin() + static_cast<std::ptrdiff_t>(strand.firstPoint - firstPoint));
        }
    });
    return points;
}

const sim::StrandMaterial& materialOf(const sim::StrandFrame& frame, const Strand& strand)
{
    return frame.groups[strand.group].groom->settings.material;
}

/// As strand_shade.comp has it: a hair keeps its root's opacity for long, and thins out by it.
float opacityAt(const sim::StrandMaterial& material, float fraction)
{
    return glm::mix(material.rootAlpha, material.tipAlpha, fraction * fraction);
}

/// As strand_shade.comp has it, mixed in linear light; sRGB as encoded, 0..1. Channels that are equal at root and tip
/// are not mixed, so that they keep their exact value.
glm::vec3 colourAt(const sim::StrandStyle& style, float fraction)
{
    const auto channel = [&](unsigned shift) {
        const float root = static_cast<float>((style.rootColour >> shift) & 0xFFU) / 255.0F;
        const float tip = static_cast<float>((style.tipColour >> shift) & 0xFFU) / 255.0F;
        return root == tip ? root : srgbFromLinear(glm::mix(linearFromSrgb(root), linearFromSrgb(tip), fraction));
    };
    return {channel(0), channel(8), channel(16)};
}

std::array<char, kHeaderBytes> makeHeader(std::size_t strands, std::size_t points)
{
    std::array<char, kHeaderBytes> header{};
    std::memcpy(header.data(), "HAIR", 4);
    const std::array<quint32, 4> counts = {
        static_cast<quint32>(strands), static_cast<quint32>(points),
        kSegmentsFlag | kPointsFlag | kThicknessFlag | kTransparencyFlag | kColoursFlag, 0};
    std::memcpy(header.data() + 4, counts.data(), sizeof(counts));
    const std::array<float, 5> defaults = {80e-6F, 0.0F, 0.25F, 0.15F, 0.1F};
    std::memcpy(header.data() + 20, defaults.data(), sizeof(defaults));
    std::memcpy(header.data() + 40, kText, std::min(std::strlen(kText), kTextBytes));
    return header;
}

template<typename T>
void writeArray(AtomicFile& file, const std::vector<T>& values)
{
    file.write({reinterpret_cast<const char*>(values.data()), static_cast<qsizetype>(values.size() * sizeof(T))});
}

/// One value per point, computed from the strand and the fraction of the way to the tip.
template<typename T, typename Function>
std::vector<T> perPoint(std::span<const Strand> strands, const Function& function)
{
    std::vector<T> values;
    values.reserve(strands.back().endPoint() - strands.front().firstPoint);
    for (const Strand& strand : strands)
        for (int i = 0; i <= strand.segments; ++i)
            values.push_back(function(strand, static_cast<float>(i) / static_cast<float>(strand.segments)));
    return values;
}

/// Part of the work, 0..1.
struct Part
{
    double from;
    double to;
};

/// Writes an array a piece at a time, for all points of much curled hair would be gigabytes; asks `progress` before
/// each. False where it cancels. Ends early where the file has failed.
template<typename Values>
bool writePieces(AtomicFile& file, std::span<const Strand> strands, const Progress& progress, const Part& part,
                 const Values& valuesOf)
{
    constexpr std::size_t kAtOnce = 1U << 15U;
    for (std::size_t first = 0; first < strands.size() && !file.failed(); first += kAtOnce) {
        const double fraction = static_cast<double>(first) / static_cast<double>(strands.size());
        if (progress && !progress(part.from + (part.to - part.from) * fraction))
            return false;
        writeArray(file, valuesOf(strands.subspan(first, std::min(kAtOnce, strands.size() - first))));
    }
    return true;
}

Result<void> write(const sim::StrandFrame& frame, const QString& path, const Progress& progress)
{
    const std::vector<Strand> strands = collectStrands(frame);
    const std::size_t pointCount = strands.empty() ? 0 : strands.back().endPoint();
    if (pointCount > kMostHairFileBytes / kPointBytes)
        return cannotWrite(
            path, {.text = say(QT_TRANSLATE_NOOP("Files", "it would take %1, and %2 is the most; make the hair less "
                                                          "dense or less curled, or export fewer hairs"))
                               .arg(QLocale().formattedDataSize(static_cast<qint64>(pointCount * kPointBytes)),
                                    QLocale().formattedDataSize(static_cast<qint64>(kMostHairFileBytes)))});
    AtomicFile file(path);
    if (const Checked<void> opened = file.open(); !opened)
        return cannotWrite(path, opened.error());
    const std::array<char, kHeaderBytes> header = makeHeader(strands.size(), pointCount);
    file.write({header.data(), static_cast<qsizetype>(header.size())});
    std::vector<quint16> segments;
    segments.reserve(strands.size());
    for (const Strand& strand : strands)
        segments.push_back(static_cast<quint16>(strand.segments));
    writeArray(file, segments);
    const auto points = [&](std::span<const Strand> some) { return evaluate(frame, some); };
    const auto thickness = [&](std::span<const Strand> some) {
        return perPoint<float>(some, [&](const Strand& s, float fraction) {
            return styleOf(frame, s).width * materialOf(frame, s).widthM * opacityAt(materialOf(frame, s), fraction);
        });
    };
    const auto transparency = [&](std::span<const Strand> some) {
        return perPoint<float>(
            some, [&](const Strand& s, float fraction) { return 1.0F - opacityAt(materialOf(frame, s), fraction); });
    };
    const auto colours = [&](std::span<const Strand> some) {
        return perPoint<glm::vec3>(
            some, [&](const Strand& s, float fraction) { return colourAt(styleOf(frame, s), fraction); });
    };
    if (!writePieces(file, strands, progress, {0.0, 0.5}, points) ||
        !writePieces(file, strands, progress, {0.5, 0.6}, thickness) ||
        !writePieces(file, strands, progress, {0.6, 0.7}, transparency) ||
        !writePieces(file, strands, progress, {0.7, 1.0}, colours) || (progress && !progress(1.0)))
        return cancelled(path);
    if (const Checked<void> written = file.commit(); !written)
        return cannotWrite(path, written.error());
    return {};
}

} // namespace

Result<void> writeHairFile(const sim::StrandFrame& frame, const QString& path, const Progress& progress)
{
    return withinMemory(path, cannotWrite, [&] { return write(frame, path, progress); });
}

} // namespace hairpaint::model
