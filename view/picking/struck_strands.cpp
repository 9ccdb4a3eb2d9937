// Blocks, then skeletons, then drawn curves.
#include "view/picking/struck_strands.h"

#include "sim/base/parallel.h"
#include "view/picking/curve_batch.h"

#include <algorithm>
#include <array>
#include <bit>
#include <compare>
#include <memory>
#include <optional>
#include <span>

namespace hairpaint::view {

using model::SeenStrand;

namespace {

constexpr std::size_t kBlocksAtATime = 512;
constexpr std::size_t kStrandsATask = 512;

/// The strands of a block whose curve may meet the line or, with `inside`, lie in it.
std::uint32_t lanesNear(const PictureHair& picture, std::size_t index, const LineRows& line, bool inside,
                        BlockAnswer& answer)
{
    const auto meets = [&line, inside](const PictureBox& box) {
        return line.mayMeet(box) || (inside && line.contains({box.left, box.top}));
    };
    const HairBoxes& boxes = picture.boxes;
    BlockQuestion question = picture.questionOf(index);
    question.box = line.box();
    for (std::size_t span = 0; span < boxes.spans; ++span)
        question.spans |= (meets(boxes.boxes[index * boxes.spans + span]) ? 1U : 0U) << span;
    if (question.spans == 0)
        return 0;
    findNear(picture.lens, question, answer);
    std::uint32_t found = 0;
    for (std::size_t n = 1; n < question.nodes; ++n)
        for (std::uint32_t lanes = answer.near[n] & ~found; lanes != 0; lanes &= lanes - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
            PictureBox box;
            for (const std::size_t node : {n - 1, n})
                box.add(glm::vec2(answer.seen[node][lane], answer.seen[node][kPickLanes + lane]));
            if (meets(box.widened(answer.strayPx[n][lane])))
                found |= 1U << lane;
        }
    return found;
}

/// Strands whose curves are looked at together, and which of them meet the line.
class Strike
{
public:
    Strike(const PictureHair& picture, const LineRows& line, bool inside, bool throughSkin)
        : m_picture(picture), m_line(line), m_inside(inside), m_throughSkin(throughSkin), m_batch(picture)
    {}

    /// Appends those that meet it, in their order.
    void strike(std::span<const std::uint32_t> slots, std::vector<SeenStrand>& met)
    {
        const sim::Groom& groom = *m_picture.hair->groom;
        m_asked.clear();
        m_asked.reserve(slots.size());
        for (std::size_t i = 0; i < slots.size(); ++i)
            m_asked.push_back({.segments = CurveBatch::segmentsASpan(groom, slots[i]), .index = i});
        std::ranges::sort(m_asked);
        m_met.assign(slots.size(), std::nullopt);
        for (std::size_t begin = 0; begin < m_asked.size();) {
            std::array<std::uint32_t, kPickLanes> batch{};
            std::size_t count = 0;
            for (; count < kPickLanes && begin + count < m_asked.size() &&
                   m_asked[begin + count].segments == m_asked[begin].segments;
                 ++count)
                batch[count] = slots[m_asked[begin + count].index];
            strikeBatch(std::span(batch).first(count), std::span(m_asked).subspan(begin, count));
            begin += count;
        }
        for (std::size_t i = 0; i < slots.size(); ++i)
            if (m_met[i])
                met.push_back({.rootUv = groom.roots->uv[slots[i]],
                               .rootHd = groom.roots->positionHd[slots[i]],
                               .positionHd = m_picture.inHead(m_met[i]->positionWo),
                               .alongM = m_met[i]->alongM,
                               .lengthM = m_met[i]->lengthM,
                               .fraction = m_met[i]->fraction,
                               .slot = slots[i]});
    }

private:
    struct Asked
    {
        int segments;
        std::size_t index;
        friend auto operator<=>(const Asked&, const Asked&) = default; // NOLINT(modernize-use-nullptr)
    };
    struct Met
    {
        glm::vec3 positionWo;
        float alongM, lengthM, fraction;
    };

    void strikeBatch(std::span<const std::uint32_t> slots, std::span<const Asked> asked)
    {
        m_batch.evaluate(slots, static_cast<std::size_t>(m_picture.hair->groom->nodes - 1));
        const std::span<const std::uint32_t> near = m_batch.near(m_line.box());
        const std::span<const float> alongM = m_batch.alongM();
        std::uint32_t open = (1U << slots.size()) - 1U;
        for (std::size_t i = 1; i < near.size() && open != 0; ++i)
            for (std::uint32_t lanes = near[i] & open; lanes != 0; lanes &= lanes - 1) {
                const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
                const std::optional<float> at = meeting(m_batch.seen(i - 1, lane), m_batch.seen(i, lane));
                if (!at)
                    continue;
                open &= ~(1U << lane);
                const glm::vec3 fromWo = m_batch.pointWo(i - 1, lane);
                const float beforeM = alongM[(i - 1) * kPickLanes + lane];
                m_met[asked[lane].index] =
                    Met{.positionWo = fromWo + (m_batch.pointWo(i, lane) - fromWo) * *at,
                        .alongM = beforeM + (alongM[i * kPickLanes + lane] - beforeM) * *at,
                        .lengthM = alongM[(near.size() - 1) * kPickLanes + lane],
                        .fraction = (static_cast<float>(i - 1) + *at) / static_cast<float>(near.size() - 1)};
            }
    }
    /// Where a segment, px and depth, is met: of it in the world.
    [[nodiscard]] std::optional<float> meeting(glm::vec3 last, glm::vec3 next) const
    {
        std::optional<float> at = m_inside && m_line.contains(glm::vec2(last))
                                      ? std::optional(0.0F)
                                      : m_line.firstMeeting(glm::vec2(last), glm::vec2(next));
        if (!at || (!m_throughSkin && m_picture.skin.hides(last + (next - last) * *at)))
            return std::nullopt;
        return *at * last.z / (*at * last.z + (1.0F - *at) * next.z);
    }

    const PictureHair& m_picture;
    const LineRows& m_line;
    bool m_inside, m_throughSkin;
    CurveBatch m_batch;
    std::vector<Asked> m_asked;
    std::vector<std::optional<Met>> m_met;
};

} // namespace

std::vector<SeenStrand> struckStrands(const PictureHair& picture, const LineRows& line, bool inside, bool throughSkin)
{
    std::vector<std::uint32_t> near(picture.boxes.blocks.size());
    sim::parallelFor(near.size(), kBlocksAtATime, [&](std::size_t begin, std::size_t end) {
        const auto answer = std::make_unique_for_overwrite<BlockAnswer>();
        for (std::size_t i = begin; i < end; ++i)
            near[i] = lanesNear(picture, i, line, inside, *answer);
    });
    std::vector<std::uint32_t> slots;
    for (std::size_t i = 0; i < near.size(); ++i)
        for (std::uint32_t lanes = near[i]; lanes != 0; lanes &= lanes - 1)
            slots.push_back(picture.boxes.blocks[i].firstSlot + static_cast<std::uint32_t>(std::countr_zero(lanes)));
    std::vector<std::vector<SeenStrand>> met((slots.size() + kStrandsATask - 1) / kStrandsATask);
    sim::parallelFor(met.size(), 1, [&](std::size_t begin, std::size_t end) {
        Strike strike(picture, line, inside, throughSkin);
        for (std::size_t task = begin; task < end; ++task)
            strike.strike(std::span(slots).subspan(task * kStrandsATask,
                                                   std::min(kStrandsATask, slots.size() - task * kStrandsATask)),
                          met[task]);
    });
    return joined(met);
}

} // namespace hairpaint::view
