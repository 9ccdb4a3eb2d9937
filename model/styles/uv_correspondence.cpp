// A table over the layout, filled on several threads.
#include "model/styles/uv_correspondence.h"

#include "sim/base/parallel.h"
#include "sim/skin/skin_frame.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>

namespace hairpaint::model {

namespace {

constexpr glm::vec2 kNoSkin{-1.0F, 0.0F};
constexpr float kFarthestTexels = 8.0F; ///< Between neighbours in one island.

bool isSkin(glm::vec2 uv)
{
    return uv.x >= 0.0F;
}

} // namespace

UvCorrespondence::UvCorrespondence(std::shared_ptr<const Head> from, std::shared_ptr<const Head> to, int size)
    : m_from(std::move(from)), m_to(std::move(to)), m_warp(*m_to->landmarks, *m_from->landmarks),
      m_bounds(sim::boundsOf(m_from->skin->mesh())), m_size(size),
      m_uvs(static_cast<std::size_t>(size) * static_cast<std::size_t>(size), kNoSkin)
{}

std::shared_ptr<const UvCorrespondence> UvCorrespondence::make(std::shared_ptr<const Head> from,
                                                               std::shared_ptr<const Head> to, int size,
                                                               const std::function<bool(double)>& goesOn)
{
    constexpr std::size_t kRowsAtOnce = 16;
    const std::shared_ptr<UvCorrespondence> table(new UvCorrespondence(std::move(from), std::move(to), size));
    const auto rows = static_cast<std::size_t>(size);
    for (std::size_t first = 0; first < rows; first += kRowsAtOnce) {
        if (goesOn && !goesOn(static_cast<double>(first) / static_cast<double>(rows)))
            return nullptr;
        const std::size_t texels = std::min(kRowsAtOnce, rows - first) * rows;
        sim::parallelFor(texels, rows / 4, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = first * rows + begin; i < first * rows + end; ++i) {
                const std::size_t row = i / rows;
                const glm::vec2 centre(static_cast<float>(i - row * rows) + 0.5F, static_cast<float>(row) + 0.5F);
                const glm::vec2 uv = centre / static_cast<float>(size);
                table->m_uvs[i] = table->measured({uv.x, 1.0F - uv.y}).value_or(kNoSkin);
            }
        });
    }
    return table;
}

std::shared_ptr<const UvCorrespondence> UvCorrespondence::between(const std::shared_ptr<const Head>& from,
                                                                  const std::shared_ptr<const Head>& to, int size,
                                                                  const std::function<bool(double)>& goesOn)
{
    static std::mutex mutex;
    static std::shared_ptr<const UvCorrespondence> kept;
    {
        const std::scoped_lock lock(mutex);
        if (kept && kept->m_from == from && kept->m_to == to && kept->m_size == size)
            return kept;
    }
    std::shared_ptr<const UvCorrespondence> made = make(from, to, size, goesOn);
    if (made) {
        const std::scoped_lock lock(mutex);
        kept = made;
    }
    return made;
}

std::optional<glm::vec2> UvCorrespondence::at(glm::vec2 uvOfTo) const
{
    const glm::vec2 inTexels = glm::vec2(uvOfTo.x, 1.0F - uvOfTo.y) * static_cast<float>(m_size) - 0.5F;
    const glm::vec2 corner = glm::floor(inTexels);
    const glm::vec2 fraction = inTexels - corner;
    std::array<glm::vec2, 4> uvs{};
    for (int k = 0; k < 4; ++k) {
        const glm::ivec2 texel = glm::clamp(glm::ivec2(corner) + glm::ivec2(k % 2, k / 2), 0, m_size - 1);
        uvs[static_cast<std::size_t>(k)] = m_uvs[static_cast<std::size_t>(texel.y) * static_cast<std::size_t>(m_size) +
                                                 static_cast<std::size_t>(texel.x)];
    }
    if (fraction == glm::vec2(0.0F))
        return isSkin(uvs[0]) ? std::optional(uvs[0]) : std::nullopt;
    // Between the table's samples only where the other layout goes on evenly; across its seams points are measured.
    const float apart = kFarthestTexels / static_cast<float>(m_size);
    const bool even =
        std::ranges::all_of(uvs, [&](glm::vec2 uv) { return isSkin(uv) && glm::distance(uv, uvs[0]) < apart; });
    if (!even)
        return measured(uvOfTo);
    return glm::mix(glm::mix(uvs[0], uvs[1], fraction.x), glm::mix(uvs[2], uvs[3], fraction.x), fraction.y);
}

glm::vec2 UvCorrespondence::direction(glm::vec2 ofFrom, glm::vec2 uvOfFrom, glm::vec2 uvOfTo) const
{
    constexpr float kStepM = 1e-3F;
    const float length = glm::length(ofFrom);
    const std::optional<sim::SurfacePoint> to = m_to->skin->atUv(uvOfTo);
    if (!to || length == 0.0F)
        return ofFrom;
    // The warp leads from the new head to the old: what its steps along the new axes are in the old frame is undone.
    const sim::SkinFrame toFrame = sim::SkinFrame::at(*to);
    const glm::vec3 positionHd = m_warp(to->positionHd);
    const std::optional<sim::SurfacePoint> known = m_from->skin->atUv(uvOfFrom);
    const sim::SkinFrame fromFrame = sim::SkinFrame::at(known ? *known : m_from->skin->nearest(positionHd));
    const auto carried = [&](glm::vec3 axis) {
        return fromFrame.fromHd((m_warp(to->positionHd + axis * kStepM) - positionHd) / kStepM);
    };
    const glm::mat2 toOld(carried(toFrame.x), carried(toFrame.y));
    constexpr float kFlat = 1e-3F; // Landmarks that nearly coincide may press the skin together.
    if (!(std::abs(glm::determinant(toOld)) > kFlat))
        return ofFrom;
    const glm::vec2 wanted = glm::inverse(toOld) * ofFrom;
    return wanted * (length / std::max(glm::length(wanted), 1e-9F));
}

std::optional<glm::vec2> UvCorrespondence::measured(glm::vec2 uvOfTo) const
{
    const std::optional<sim::SurfacePoint> point = m_to->skin->atUv(uvOfTo);
    if (!point)
        return std::nullopt;
    // Landmarks that nearly coincide may throw points far out, where looking for the nearest takes long.
    const glm::vec3 positionHd =
        glm::clamp(m_warp(point->positionHd), m_bounds.least - m_bounds.size(), m_bounds.greatest + m_bounds.size());
    return glm::max(m_from->skin->nearest(positionHd).uv, glm::vec2(0.0F));
}

} // namespace hairpaint::model
