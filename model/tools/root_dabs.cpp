// From what the picture shows under a brush to ellipses of texels.
#include "model/tools/root_dabs.h"

#include "model/tools/strokes/dab_shape.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::model {

namespace {

constexpr float kRadiusOfSpacing = 0.75F; ///< Discs of that radius cover the plane where roots are evenly spread.
constexpr float kWidestM = 0.004F;        ///< However thin the hair is.
constexpr float kLeastDensity = 0.02F;

/// As a dab's: 1 up to the hardness, 0 at the rim.
float strengthAt(float apart, float hardness)
{
    const float fade = std::max(1.0F - hardness * hardness, 0.02F);
    return std::clamp((1.0F - apart * apart) / fade, 0.0F, 1.0F);
}

} // namespace

RootDabs::RootDabs(const ToolContext& context, int mapSize)
    : m_mapSize(mapSize), m_density(context.document.resolvedNow(context.target.group, MapKind::Density))
{
    const sim::GroupFrame* hair = context.seen != nullptr ? context.seen->hair() : nullptr;
    if (hair == nullptr)
        return;
    const sim::RootSet& roots = *hair->groom->roots;
    m_spacingM = std::sqrt(
        static_cast<float>(roots.skin->areaM2() / static_cast<double>(std::max<std::size_t>(roots.count(), 1))));
    m_strengths.resize(roots.count());
}

float RootDabs::spacingM(glm::vec2 uv, float detail) const
{
    const float density = m_density != nullptr ? static_cast<float>(m_density->sampleNearest(uv)[0]) / 65535.0F : 1.0F;
    return m_spacingM / std::sqrt(std::max(std::min(density, detail), kLeastDensity));
}

std::vector<RootDab> RootDabs::moveTo(const OverHair& hair, const ToolContext& context, const Shape& shape,
                                      bool onlyStronger)
{
    const QPointF from = m_last.value_or(hair.position);
    m_last = hair.position;
    const Head* head = context.document.project().head.get();
    if (context.seen == nullptr || context.seen->hair() == nullptr || head == nullptr || head->skin == nullptr)
        return {};
    const float detail = context.seen->hair()->detail;
    const sim::RootSet& roots = *context.seen->hair()->groom->roots;
    if (shape.fractions)
        m_fractions.resize(m_strengths.size(), 1.0F);
    std::vector<RootDab> dabs;
    for (const SeenStrand& strand : context.seen->passed(from, hair.position, 0.5 * shape.sizeM * hair.pxPerM)) {
        const float strength = shape.strength * strengthAt(strand.apart, shape.hardness);
        if (strength <= 0.0F || strand.slot >= m_strengths.size())
            continue;
        const bool isNearer = shape.fractions && strand.firstFraction < m_fractions[strand.slot];
        if (onlyStronger && strength <= m_strengths[strand.slot] && !isNearer)
            continue;
        m_strengths[strand.slot] = std::max(m_strengths[strand.slot], strength);
        if (isNearer)
            m_fractions[strand.slot] = strand.firstFraction;
        const float radiusM = std::min(kRadiusOfSpacing * spacingM(strand.rootUv, detail), kWidestM);
        const sim::SurfacePoint root = roots.surfacePoint(strand.slot);
        RootDab& one =
            dabs.emplace_back(RootDab{.dab = dabAt(SkinMetric::at(root), root.uv, radiusM, m_mapSize),
                                      .root = root,
                                      .seenHd = strand.positionHd,
                                      .fraction = shape.fractions ? m_fractions[strand.slot] : strand.firstFraction});
        one.dab.strength = strength;
        if (!context.mirror)
            continue;
        if (shape.twinRoots || !head->builtIn)
            one.twinRoot = head->skin->mirrored(root);
        if (head->builtIn)
            one.twin = mirroredInU(one.dab, m_mapSize);
        else if (one.twinRoot)
            one.twin = dabAt(SkinMetric::at(*one.twinRoot), one.twinRoot->uv, radiusM, m_mapSize);
        if (one.twin)
            one.twin->strength = strength;
    }
    return dabs;
}

} // namespace hairpaint::model
