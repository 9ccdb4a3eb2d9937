// Lengths as grooms have them.
#include "model/tools/strand_lengths.h"

#include "sim/groom/slot_set.h"
#include "sim/groom/strand_style.h"
#include "sim/groom/variation.h"

namespace hairpaint::model {

StrandLengths::StrandLengths(Document& document, Id group, std::shared_ptr<const sim::RootSet> roots)
    : m_roots(std::move(roots)), m_settings(document.project().group(group)->settings),
      m_length(document.resolvedNow(group, MapKind::Length)), m_curl(document.resolvedNow(group, MapKind::Curl)),
      m_curlSize(document.resolvedNow(group, MapKind::CurlSize)), m_lengths(m_length), m_curls(m_curl),
      m_curlSizes(m_curlSize)
{
    m_hairline.startOver(m_roots, m_settings.hairline);
    if (m_hairline.isOff())
        return;
    const sim::MapRaster density = document.resolvedNow(group, MapKind::Density);
    sim::SlotSet all(m_roots->count());
    all.insertAll();
    m_hairline.update(sim::MapSampler(density), all);
}

float StrandLengths::at(std::uint32_t slot) const
{
    const glm::vec2 uv = m_roots->uv[slot];
    const float curl = m_curls.scalar(uv);
    const float lengthM = sim::lengthOf(m_settings, m_lengths.scalar(uv)) *
                          sim::seenOverCut(m_settings, curl, curl > 0.0F ? m_curlSizes.scalar(uv) : 0.0F);
    return lengthM * sim::variationAt(m_settings, *m_roots, m_hairline, slot, lengthM).length;
}

} // namespace hairpaint::model
