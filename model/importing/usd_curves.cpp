// Strands of USD's curves: where each one runs, and what it has at its ends.
#include "model/importing/usd_curves.h"

#include "model/values/srgb.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <type_traits>
#include <utility>

namespace hairpaint::model {

namespace {

/// How many values a curve has of those that vary along its segments (UsdGeomBasisCurves).
std::size_t varyingCount(const UsdCurves& curves, std::size_t points)
{
    if (curves.type != "cubic" || curves.wrap == "pinned" || points < 4)
        return points;
    if (curves.wrap == "periodic")
        return curves.basis == "bezier" ? points / 3 : points;
    return curves.basis == "bezier" ? (points - 4) / 3 + 2 : points - 2;
}

/// The value of a curve's root or tip.
template<typename Value>
class AtEnds
{
public:
    /// `varying`: of such values, those of all curves.
    AtEnds(const UsdPrimvar& primvar, std::size_t curves, std::size_t points, std::size_t varying) : m_primvar(primvar)
    {
        const std::size_t values = primvar.values.size() / kEach;
        const std::size_t count = primvar.indices.empty() ? values : primvar.indices.size();
        if (values == 0 || primvar.values.size() % kEach != 0)
            return;
        m_kind = kindOf(primvar.interpolation, count, curves, points, varying);
    }
    [[nodiscard]] bool isTold() const { return m_kind != Kind::None; }
    /// `point`, `varying`: the end's number among all of them.
    [[nodiscard]] Value at(std::size_t curve, std::size_t point, std::size_t varying) const
    {
        std::size_t index = 0;
        if (m_kind == Kind::Uniform)
            index = curve;
        else if (m_kind == Kind::Vertex)
            index = point;
        else if (m_kind == Kind::Varying)
            index = varying;
        if (!m_primvar.indices.empty()) {
            const float told = m_primvar.indices[index];
            const std::size_t values = m_primvar.values.size() / kEach;
            index = told >= 0.0F && told < static_cast<float>(values) ? static_cast<std::size_t>(told) : 0;
        }
        Value value;
        if constexpr (kEach == 1)
            value = m_primvar.values[index];
        else
            value = {m_primvar.values[3 * index], m_primvar.values[3 * index + 1], m_primvar.values[3 * index + 2]};
        return value;
    }

private:
    enum class Kind : std::uint8_t
    {
        None,
        Constant,
        Uniform,
        Varying,
        Vertex
    };

    /// By what is told, where the count fits; else by the count alone.
    static Kind kindOf(std::string_view told, std::size_t count, std::size_t curves, std::size_t points,
                       std::size_t varying)
    {
        if (told == "constant" || (told.empty() && count == 1))
            return Kind::Constant;
        if (count == curves && (told == "uniform" || told.empty()))
            return Kind::Uniform;
        if (count == points && (told == "vertex" || told.empty()))
            return Kind::Vertex;
        if (count == varying && told != "uniform" && told != "vertex")
            return Kind::Varying;
        if (count == points)
            return Kind::Vertex;
        if (count == curves)
            return Kind::Uniform;
        return count == 1 ? Kind::Constant : Kind::None;
    }

    static constexpr std::size_t kEach = std::is_same_v<Value, float> ? 1 : 3;
    const UsdPrimvar& m_primvar;
    Kind m_kind = Kind::None;
};

glm::vec3 asEncoded(const glm::vec3& linear)
{
    const auto channel = [](float value) {
        return std::isfinite(value) ? srgbFromLinear(std::clamp(value, 0.0F, 1.0F)) : 0.0F;
    };
    return {channel(linear.r), channel(linear.g), channel(linear.b)};
}

/// Points that a curve runs through, of those that tell it.
void addCurve(const UsdCurves& curves, std::span<const glm::vec3> told, std::vector<glm::vec3>& points)
{
    if (curves.wrap == "periodic" && told.size() >= 3) { // It ends where it began.
        std::vector<glm::vec3> closed(told.begin(), told.end());
        const bool overlaps = curves.type == "cubic" && curves.basis != "bezier";
        closed.insert(closed.end(), told.begin(), told.begin() + (overlaps ? 3 : 1));
        UsdCurves open;
        open.type = curves.type;
        open.basis = curves.basis;
        return addCurve(open, closed, points);
    }
    const bool isCubic = curves.type == "cubic";
    const bool isPinned = curves.wrap == "pinned";
    if (isCubic && curves.basis == "bezier" && told.size() >= 4) {
        for (std::size_t i = 0; i < told.size(); i += 3)
            points.push_back(told[i]);
    } else if (isCubic && curves.basis == "bspline" && (told.size() >= 4 || (isPinned && told.size() >= 2))) {
        if (isPinned) // Phantom points mirror the second one about each end, so that it begins and ends there.
            points.push_back(told.front());
        for (std::size_t i = 0; i + 2 < told.size(); ++i)
            points.push_back((told[i] + 4.0F * told[i + 1] + told[i + 2]) / 6.0F);
        if (isPinned)
            points.push_back(told.back());
    } else if (isCubic && curves.basis == "catmullRom" && !isPinned && told.size() >= 4) {
        points.insert(points.end(), told.begin() + 1, told.end() - 1); // The outermost only tell how it bends.
    } else {
        points.insert(points.end(), told.begin(), told.end());
    }
}

const UsdPrimvar& firstTold(const UsdCurves& curves, std::initializer_list<std::string_view> names)
{
    static const UsdPrimvar none;
    for (const std::string_view name : names)
        if (const auto found = curves.primvars.find(name); found != curves.primvars.end() && found->second.isTold())
            return found->second;
    return none;
}

} // namespace

std::optional<std::vector<ForeignStrands>> strandsOf(const UsdCurves& curves)
{
    std::vector<glm::vec3> told(curves.points.size() / 3);
    for (std::size_t i = 0; i < told.size(); ++i)
        told[i] = {curves.points[3 * i], curves.points[3 * i + 1], curves.points[3 * i + 2]};
    if (curves.points.size() % 3 != 0)
        return std::nullopt;
    std::size_t allVarying = 0;
    std::size_t left = told.size();
    for (const float count : curves.counts) {
        if (!(count >= 0.0F) || count > static_cast<float>(left) || count != std::floor(count))
            return std::nullopt;
        left -= static_cast<std::size_t>(count);
        allVarying += varyingCount(curves, static_cast<std::size_t>(count));
    }
    if (left != 0)
        return std::nullopt;
    const std::size_t all = curves.counts.size();
    const AtEnds<float> widths(firstTold(curves, {"widths", "groom_width", "width"}), all, told.size(), allVarying);
    const AtEnds<glm::vec3> colours(firstTold(curves, {"displayColor", "groom_color"}), all, told.size(), allVarying);
    const AtEnds<float> guides(firstTold(curves, {"groom_guide"}), all, told.size(), allVarying);
    const AtEnds<float> groups(firstTold(curves, {"groom_group_id"}), all, told.size(), allVarying);
    const auto isGuide = [&guides](std::size_t curve) { return guides.isTold() && guides.at(curve, 0, 0) != 0.0F; };
    bool areGuides = all > 0;
    for (std::size_t i = 0; i < all; ++i)
        areGuides = areGuides && isGuide(i);
    std::map<float, ForeignStrands> byId;
    std::size_t first = 0;
    std::size_t varying = 0;
    for (std::size_t i = 0; i < all; ++i) {
        const auto count = static_cast<std::size_t>(curves.counts[i]);
        const std::size_t begin = std::exchange(first, first + count);
        const std::size_t varyingBegin = std::exchange(varying, varying + varyingCount(curves, count));
        if (count == 0 || (!areGuides && isGuide(i)))
            continue;
        const float id = groups.isTold() ? groups.at(i, begin, varyingBegin) : 0.0F;
        ForeignStrands& strands = byId[std::isfinite(id) ? id : 0.0F];
        addCurve(curves, std::span(told).subspan(begin, count), strands.points);
        strands.ends.push_back(static_cast<std::uint32_t>(strands.points.size()));
        StrandLook look;
        if (widths.isTold()) {
            const auto wide = [](float width) { return std::isfinite(width) && width > 0.0F ? width : 0.0F; };
            look.rootWidth = wide(widths.at(i, begin, varyingBegin));
            look.tipWidth = wide(widths.at(i, first - 1, varying - 1));
        }
        if (colours.isTold()) {
            look.rootColour = asEncoded(colours.at(i, begin, varyingBegin));
            look.tipColour = asEncoded(colours.at(i, first - 1, varying - 1));
        }
        strands.looks.push_back(look);
    }
    std::vector<ForeignStrands> made;
    for (auto& [id, strands] : byId) {
        strands.name = byId.size() == 1 ? curves.groupName
                                        : QStringLiteral("%1 %2").arg(curves.groupName).arg(static_cast<double>(id));
        strands.hasColours = colours.isTold();
        strands.isGuides = areGuides;
        made.push_back(std::move(strands));
    }
    return made;
}

} // namespace hairpaint::model
