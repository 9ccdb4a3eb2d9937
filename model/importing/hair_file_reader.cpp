// Reading Cem Yuksel's `.hair` format (http://www.cemyuksel.com/research/hairmodels): header, then one array after
// another, as its flags say: segments, points, thickness, transparency, colours.
#include "model/importing/hair_file_reader.h"

#include <QIODevice>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <string_view>

namespace hairpaint::model {

namespace {

enum HairFlag : quint32
{
    HasSegments = 1,
    HasPoints = 2,
    HasThickness = 4,
    HasTransparency = 8,
    HasColours = 16
};

constexpr qint64 kHairHeader = 128;
constexpr std::size_t kValuesAtOnce = std::size_t{1} << 16U;
static_assert(std::endian::native == std::endian::little, "arrays are read as they lie in memory");

struct HairHeader
{
    quint32 strands = 0;
    quint32 points = 0;
    quint32 flags = 0;
    quint32 segments = 0; ///< Number of segments of each strand, where the file has no array of them.
    float thickness = 0.0F;
    float transparency = 0.0F;
    glm::vec3 colour{0.0F};
    std::array<char, 88> text{};
};

tl::unexpected<Clause> cutShort()
{
    return refuse(say(QT_TRANSLATE_NOOP("Files", "its hair is cut short or broken; export it again")),
                  Clause::Cure::OtherFile);
}

Checked<HairHeader> headerOf(QIODevice& file)
{
    std::array<char, kHairHeader> bytes{};
    const qint64 read = file.read(bytes.data(), kHairHeader);
    if (std::string_view(bytes.data(), 4) != "HAIR")
        return refuse(say(QT_TRANSLATE_NOOP("Files", "it is no hair file; choose one that a hair program exported")),
                      Clause::Cure::OtherFile);
    if (read != kHairHeader)
        return cutShort();
    HairHeader header;
    const auto take = [&bytes](std::size_t at, auto& value) { std::memcpy(&value, bytes.data() + at, sizeof(value)); };
    take(4, header.strands);
    take(8, header.points);
    take(12, header.flags);
    take(16, header.segments);
    take(20, header.thickness);
    take(24, header.transparency);
    take(28, header.colour);
    take(40, header.text);
    return header;
}

/// Whether the arrays that the flags name fill the file. What stands behind them is nobody's.
bool holdsArrays(const HairHeader& header, qint64 fileSize)
{
    const auto bytesOf = [&header](HairFlag flag, quint32 count, qint64 each) {
        return (header.flags & flag) != 0 ? qint64{count} * each : 0;
    };
    return kHairHeader + bytesOf(HasSegments, header.strands, 2) + bytesOf(HasPoints, header.points, 12) +
               bytesOf(HasThickness, header.points, 4) + bytesOf(HasTransparency, header.points, 4) +
               bytesOf(HasColours, header.points, 12) <=
           fileSize;
}

template<typename T>
bool readValues(QIODevice& file, T* values, std::size_t count)
{
    const qint64 bytes = static_cast<qint64>(count) * qint64{sizeof(T)};
    return file.read(reinterpret_cast<char*>(values), bytes) == bytes;
}

bool isFinitePoint(const glm::vec3& v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// What Hair Paint's own header says.
void readSpace(const HairHeader& header, ForeignCurves& curves)
{
    const auto end = std::ranges::find(header.text, '\0');
    const std::string_view text(header.text.data(), static_cast<std::size_t>(end - header.text.begin()));
    if (!text.starts_with("Hair Paint: "))
        return;
    curves.metresPerUnit = text.find("centimetres") != std::string_view::npos ? 0.01F : 1.0F;
    curves.upAxis = text.find("z up") != std::string_view::npos ? UpAxis::Z : UpAxis::Y;
}

/// Reads the arrays of one file.
class HairArrays
{
public:
    HairArrays(QIODevice& file, const HairHeader& header, const Progress& progress)
        : m_file(file), m_header(header), m_progress(progress)
    {}

    Checked<bool> read(ForeignStrands& strands)
    {
        if (!readEnds(strands))
            return cutShort();
        strands.points.resize(m_header.points);
        for (std::size_t done = 0; done < strands.points.size(); done += kValuesAtOnce) {
            const std::size_t some = std::min(kValuesAtOnce, strands.points.size() - done);
            if (!readValues(m_file, strands.points.data() + done, some))
                return cutShort();
            if (!goesOn(0.5 * static_cast<double>(done) / static_cast<double>(strands.points.size())))
                return false;
        }
        return readLooks(strands);
    }

private:
    [[nodiscard]] bool goesOn(double done) const { return !m_progress || m_progress(done); }

    /// Where the strands end, which must be where the points do.
    bool readEnds(ForeignStrands& strands)
    {
        std::vector<quint16> segments;
        if ((m_header.flags & HasSegments) != 0) {
            segments.resize(m_header.strands);
            if (!readValues(m_file, segments.data(), segments.size()))
                return false;
        } else if (quint64{m_header.strands} * (quint64{m_header.segments} + 1) != m_header.points) {
            return false;
        }
        strands.ends.reserve(m_header.strands);
        std::uint64_t end = 0;
        for (std::size_t strand = 0; strand < m_header.strands; ++strand) {
            const std::uint64_t own = segments.empty() ? m_header.segments : segments[strand];
            end += own + 1;
            if (end > m_header.points)
                return false;
            strands.ends.push_back(static_cast<std::uint32_t>(end));
        }
        return end == m_header.points;
    }

    /// Keeps of an array of one value a point those at both ends of each strand: calls `keep(look, root, tip)`.
    template<typename T, typename Keep>
    Checked<bool> readEndValues(ForeignStrands& strands, double done, const Keep& keep)
    {
        std::vector<T> values(std::min(kValuesAtOnce, strands.points.size()));
        std::size_t first = 0;
        std::size_t strand = 0;
        T root{};
        while (first < strands.points.size()) {
            const std::size_t some = std::min(values.size(), strands.points.size() - first);
            if (!readValues(m_file, values.data(), some))
                return cutShort();
            for (; strand < strands.count(); ++strand) {
                const std::size_t begin = strand == 0 ? 0 : strands.ends[strand - 1];
                const std::size_t last = strands.ends[strand] - std::size_t{1};
                if (begin >= first && begin < first + some)
                    root = values[begin - first];
                if (last >= first + some)
                    break;
                keep(strands.looks[strand], root, values[last - first]);
            }
            first += some;
            if (!goesOn(done))
                return false;
        }
        return true;
    }

    Checked<bool> readLooks(ForeignStrands& strands)
    {
        const auto wide = [](float width) { return std::isfinite(width) && width > 0.0F ? width : 0.0F; };
        const auto light = [](const glm::vec3& colour) {
            return isFinitePoint(colour) ? glm::clamp(colour, 0.0F, 1.0F) : glm::vec3(0.0F);
        };
        strands.looks.assign(strands.count(), {.rootWidth = wide(m_header.thickness),
                                               .tipWidth = wide(m_header.thickness),
                                               .rootColour = light(m_header.colour),
                                               .tipColour = light(m_header.colour)});
        strands.hasColours = true;
        Checked<bool> goes = true;
        if ((m_header.flags & HasThickness) != 0)
            goes = readEndValues<float>(strands, 0.7, [&](StrandLook& look, float root, float tip) {
                look.rootWidth = wide(root);
                look.tipWidth = wide(tip);
            });
        if (goes && *goes && (m_header.flags & HasTransparency) != 0)
            goes = m_file.skip(qint64{m_header.points} * 4) == qint64{m_header.points} * 4 ? Checked<bool>(true)
                                                                                           : Checked<bool>(cutShort());
        if (goes && *goes && (m_header.flags & HasColours) != 0)
            goes = readEndValues<glm::vec3>(strands, 0.9,
                                            [&](StrandLook& look, const glm::vec3& root, const glm::vec3& tip) {
                                                look.rootColour = light(root);
                                                look.tipColour = light(tip);
                                            });
        return goes;
    }

    QIODevice& m_file;
    const HairHeader& m_header;
    const Progress& m_progress;
};

} // namespace

Checked<std::optional<ForeignCurves>> readHairFile(QIODevice& file, const Progress& progress)
{
    const Checked<HairHeader> header = headerOf(file);
    if (!header)
        return tl::unexpected(header.error());
    if ((header->flags & HasPoints) == 0 || !holdsArrays(*header, file.size()) || header->points > kMostForeignPoints ||
        header->strands > kMostForeignStrands)
        return cutShort();
    ForeignCurves curves;
    readSpace(*header, curves);
    ForeignStrands strands;
    const Checked<bool> whole = HairArrays(file, *header, progress).read(strands);
    if (!whole)
        return tl::unexpected(whole.error());
    if (!*whole)
        return std::optional<ForeignCurves>();
    curves.groups.push_back(std::move(strands));
    return std::optional<ForeignCurves>(std::move(curves));
}

} // namespace hairpaint::model
