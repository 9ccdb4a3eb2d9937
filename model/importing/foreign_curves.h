// Hair as files of other programs hold it: curves, in whatever unit and axes.
#pragma once

#include "model/project/project.h"

#include <glm/glm.hpp>

#include <QString>
#include <QStringList>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace hairpaint::model {

/// At both ends of a strand.
struct StrandLook
{
    float rootWidth = 0.0F; ///< Diameter in the file's unit; 0: not told.
    float tipWidth = 0.0F;
    glm::vec3 rootColour{0.0F}; ///< sRGB as encoded, 0..1.
    glm::vec3 tipColour{0.0F};
};

/// Strands that make one hair group, any number of them: of readCurves() each of at least two points, all numbers
/// finite; of a format's own reader as its file holds them.
struct ForeignStrands
{
    QString name;                    ///< Empty where the file tells none.
    std::vector<std::uint32_t> ends; ///< By strand: one behind its last point.
    std::vector<glm::vec3> points;   ///< Root first.
    std::vector<StrandLook> looks;   ///< By strand.
    bool hasColours = false;
    bool isGuides = false; ///< Told to be hairs that others follow.

    [[nodiscard]] std::size_t count() const { return ends.size(); }
    [[nodiscard]] std::span<const glm::vec3> strand(std::size_t index) const
    {
        const std::size_t begin = index == 0 ? 0 : ends[index - 1];
        return std::span(points).subspan(begin, ends[index] - begin);
    }
};

struct ForeignCurves
{
    std::vector<ForeignStrands> groups;
    std::optional<float> metresPerUnit; ///< None where the file does not tell.
    std::optional<UpAxis> upAxis;
    std::size_t leftOut = 0; ///< Strands of one point, or with a point that is none.
    QStringList unread;      ///< Other files that it names, and that were not read.
};

/// A file may hold so many; more than any groom, and some 800 MB.
inline constexpr std::uint64_t kMostForeignPoints = std::uint64_t{1} << 26U;
inline constexpr std::uint64_t kMostForeignStrands = std::uint64_t{1} << 23U;

} // namespace hairpaint::model
