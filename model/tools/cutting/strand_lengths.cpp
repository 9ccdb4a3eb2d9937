// Lengths as grooms have them.
#include "model/tools/cutting/strand_lengths.h"

#include "sim/groom/slot_set.h"
#include "sim/groom/strand_style.h"

#include <algorithm>

namespace hairpaint::model {

namespace {

constexpr float kLeastM = 1e-5F;

} // namespace

StrandLengths::StrandLengths(Document& document, Id group, std::shared_ptr<const sim::RootSet> roots)
    : m_roots(std::move(roots)), m_settings(document.project().group(group)->settings),
      m_length(document.resolvedNow(group, MapKind::Length)), m_curl(document.resolvedNow(group, MapKind::Curl)),
      m_curlSize(document.resolvedNow(group, MapKind::CurlSize)), m_lengths(m_length), m_curls(m_curl),
      m_curlSizes(m_curlSize)
{
    m_hairline.startOver(m_roots, m_settings.hairline);
    if (m_hairline.isOff())
        return;
    sim::SlotSet all(m_roots->count());
    all.insertAll();
    m_hairline.update(document.resolvedNow(group, MapKind::Density), all);
}

float StrandLengths::uncutAt(std::uint32_t slot) const
{
    const glm::vec2 uv = m_roots->uv[slot];
    const float curl = m_curls.scalar(uv);
    return sim::lengthOf(m_settings, m_lengths.scalar(uv)) *
           sim::seenOverCut(m_settings, curl, curl > 0.0F ? m_curlSizes.scalar(uv) : 0.0F);
}

float StrandLengths::at(std::uint32_t slot) const
{
    const float uncutM = uncutAt(slot);
    return uncutM * sim::variationAt(m_settings, *m_roots, m_hairline, slot, uncutM).length;
}

sim::HairVariation StrandLengths::thinnedAt(std::uint32_t slot) const
{
    sim::HairVariation thinned;
    if (!m_hairline.isOff())
        sim::thinAtDepth(m_settings.hairline.baby, m_hairline.depth(slot), m_roots->seed, m_roots->rankOfSlot[slot],
                         thinned);
    return thinned;
}

bool StrandLengths::isBaby(std::uint32_t slot) const
{
    return thinnedAt(slot).babyM > 0.0F;
}

float StrandLengths::keptFor(std::uint32_t slot, float lengthM) const
{
    const float own = sim::variationOf(m_settings.variation, m_roots->seed, m_roots->rankOfSlot[slot]).length;
    return sim::lengthBefore(m_settings.variation, own, lengthM / thinnedAt(slot).length, m_roots->positionHd[slot]) /
           std::max(uncutAt(slot), kLeastM);
}

} // namespace hairpaint::model
