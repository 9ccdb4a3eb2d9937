// The hair of one frame as curves: the one description that every export format is written from.
#pragma once

#include "model/values/progress.h"
#include "sim/motion/strand_frame.h"

#include <glm/glm.hpp>

#include <QString>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace hairpaint::model {

/// A hair group that is wanted, and its name.
struct CurveGroupName
{
    int id = 0;
    QString name;
};

struct CurveOptions
{
    std::vector<CurveGroupName> groups; ///< Groups to export; hidden groups are left out all the same.
    std::optional<std::size_t> hairs;   ///< Number of hairs to export, evenly spread; none for all.
    float toleranceM = 0.0F; ///< Points that lie within it of the curve without them are left out; 0 keeps all.
};

/// One curve, root first.
struct Curve
{
    std::uint32_t group = 0; ///< Index into CurveSet::groups().
    std::uint32_t slot = 0;
    std::uint32_t segments = 1; ///< Number of segments that it is evaluated with.
    std::uint32_t points = 2;   ///< Number of points that are written.
    std::uint64_t firstPoint = 0;
    [[nodiscard]] std::uint64_t endPoint() const { return firstPoint + points; }
};

/// The curves of one group, which follow each other in CurveSet::curves().
struct CurveGroup
{
    int id = 0;
    QString name;
    std::size_t frameGroup = 0; ///< Index into the frame's groups.
    std::uint32_t firstId = 0;  ///< Added to the candidates' ranks, so that ids are unique.
    std::span<const Curve> curves = {};
    std::span<const Curve> guides = {}; ///< The basis hairs among them, as skeletons.
    glm::vec3 leastWo{0.0F};            ///< Lower corner of the box around the points of curves and guides, m.
    glm::vec3 greatestWo{0.0F};
    glm::vec3 middleWo{0.0F}; ///< Mean of the roots, m.
};

/// What evaluating a curve needs, kept from one to the next. One per thread.
struct CurveScratch
{
    std::vector<glm::vec3> skeletonWo;
    std::vector<glm::vec3> evenWo; ///< segments + 1 points.
    std::vector<glm::vec3> keptWo;
};

/// Immutable once made; every drawn hair of the wanted groups, ordered by group and by the candidates' rank. Holds no
/// points: those of much curled hair would be gigabytes, so writers evaluate a piece at a time. Any thread.
class CurveSet
{
public:
    /// None where `progress` cancels.
    [[nodiscard]] static std::optional<CurveSet> of(std::shared_ptr<const sim::StrandFrame> frame,
                                                    const CurveOptions& options, const Progress& progress = {});

    CurveSet(CurveSet&&) noexcept = default;
    CurveSet& operator=(CurveSet&&) noexcept = default;
    ~CurveSet() = default;
    CurveSet(const CurveSet&) = delete;
    CurveSet& operator=(const CurveSet&) = delete;

    [[nodiscard]] std::span<const CurveGroup> groups() const { return m_groups; }
    [[nodiscard]] std::span<const Curve> curves() const { return m_curves; }
    [[nodiscard]] std::uint64_t pointCount() const { return m_curves.empty() ? 0 : m_curves.back().endPoint(); }
    /// How many hairs of the groom one exported hair stands for, at least 1. Exported hairs are wider by that factor,
    /// to cover as much.
    [[nodiscard]] float thinning() const { return m_thinning; }

    /// Wo, m; valid until the next call with that scratch.
    [[nodiscard]] std::span<const glm::vec3> points(const Curve& curve, CurveScratch& scratch) const;
    /// The points of a guide: its skeleton.
    [[nodiscard]] std::span<const glm::vec3> guidePoints(const Curve& guide, CurveScratch& scratch) const;
    /// Position of point i along a curve: 0 at the root, 1 at the tip.
    [[nodiscard]] float fraction(const Curve& curve, std::uint32_t i) const;

    /// Opacity at a fraction of the curve, 0..1, as on the screen: a hair keeps its root's opacity for most of its
    /// length.
    [[nodiscard]] float opacity(const Curve& curve, float fraction) const;
    /// Diameter as it is seen, m: thinned out by the opacity.
    [[nodiscard]] float width(const Curve& curve, float fraction) const;
    /// Colour in linear light, 0..1, mixed from root to tip in linear light.
    [[nodiscard]] glm::vec3 linearColour(const Curve& curve, float fraction) const;
    /// The same in sRGB as encoded. A channel that is equal at root and tip keeps its exact value.
    [[nodiscard]] glm::vec3 encodedColour(const Curve& curve, float fraction) const;
    /// Roughness of the highlights, from the group's settings and the gloss map.
    [[nodiscard]] float roughness(const Curve& curve) const;
    /// This hair's own lightness, about 1, for linear light: the colours above are without it.
    [[nodiscard]] float lightness(const Curve& curve) const;
    [[nodiscard]] std::uint32_t id(const Curve& curve) const;
    [[nodiscard]] glm::vec2 rootUv(const Curve& curve) const;
    /// The roots of the curve's group, by slot.
    [[nodiscard]] const sim::RootSet& roots(const Curve& curve) const;
    [[nodiscard]] const sim::StrandMaterial& material(const Curve& curve) const;
    [[nodiscard]] const sim::PhysicsSettings& physics(std::size_t group) const;
    /// The head that the hair stands on; null where no group has roots. Valid as long as the set.
    [[nodiscard]] const sim::Skin* skin() const;
    [[nodiscard]] const sim::HeadPose& pose() const { return m_frame->pose; }
    [[nodiscard]] const sim::Neck& neck() const { return m_frame->neck; }

private:
    CurveSet() = default;
    void addCurves(const CurveOptions& options);
    [[nodiscard]] bool measure(float toleranceM, const Progress& progress);
    /// Adds the point where the hair begins to thin out: widths are known at points alone.
    void keepTaper(const Curve& curve, std::vector<std::uint16_t>& kept) const;
    void linkGroups();

    [[nodiscard]] const sim::Groom& groom(const Curve& curve) const { return *m_grooms[curve.group]; }
    [[nodiscard]] const std::vector<float>& positions(const Curve& curve) const
    {
        return m_frame->groups[m_groups[curve.group].frameGroup].positions;
    }
    void evaluate(const Curve& curve, CurveScratch& scratch) const;

    std::shared_ptr<const sim::StrandFrame> m_frame;
    std::vector<std::shared_ptr<const sim::Groom>> m_grooms; ///< By group, with the hairs that are exported.
    std::vector<CurveGroup> m_groups;
    std::vector<Curve> m_curves;
    std::vector<Curve> m_guides;
    std::vector<std::uint16_t> m_kept; ///< By point: its index among the evaluated points; empty where all are kept.
    float m_thinning = 1.0F;
};

} // namespace hairpaint::model
