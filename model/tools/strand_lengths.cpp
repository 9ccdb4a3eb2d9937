// Lengths as grooms have them.
#include "model/tools/strand_lengths.h"

#include "sim/groom/strand_style.h"
#include "sim/groom/variation.h"

namespace hairpaint::model {

StrandLengths::StrandLengths(Document& document, Id group)
    : m_settings(document.project().group(group)->settings), m_length(document.resolvedNow(group, MapKind::Length)),
      m_curl(document.resolvedNow(group, MapKind::Curl)), m_curlSize(document.resolvedNow(group, MapKind::CurlSize)),
      m_lengths(m_length), m_curls(m_curl), m_curlSizes(m_curlSize)
{}

float StrandLengths::at(const sim::RootSet& roots, std::uint32_t slot) const
{
    const glm::vec2 uv = roots.uv[slot];
    const float curl = m_curls.scalar(uv);
    return sim::lengthOf(m_settings, m_lengths.scalar(uv)) *
           sim::seenOverCut(m_settings, curl, curl > 0.0F ? m_curlSizes.scalar(uv) : 0.0F) *
           sim::variationOf(m_settings.variation, roots.seed, roots.rankOfSlot[slot]).length;
}

} // namespace hairpaint::model
