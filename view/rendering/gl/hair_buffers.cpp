// Sends one group's hair to the GPU.
#include "view/rendering/gl/hair_buffers.h"

#include "sim/groom/strand_curve.h"

#include <algorithm>
#include <utility>

namespace hairpaint::rendering {
namespace {

constexpr glm::vec3 kNoTangent{1.0F, 0.0F, 0.0F};

} // namespace

std::size_t HairBuffers::upload(const std::shared_ptr<const sim::StrandFrame>& frame, const sim::GroupFrame& group,
                                float detail, SegmentsWanted segments)
{
    m_ready = false;
    m_groom = group.groom;
    std::size_t bytes = 0;
    if (m_list.update(m_groom, detail, segments) || m_sent.empty())
        bytes += uploadStrands();
    if (m_stylesOf != m_groom)
        bytes += uploadStyles();
    bytes += uploadPositions(frame, group);
    m_ready = !m_sent.empty() && m_stylesOf == m_groom && m_shown;
    return bytes;
}

void HairBuffers::release()
{
    *this = HairBuffers();
}

std::size_t HairBuffers::uploadStrands()
{
    const std::vector<DrawnStrand>& strands = m_list.strands();
    std::vector<DrawnStrand> before = std::exchange(m_sent, {});
    const std::size_t size = strands.size() * sizeof(DrawnStrand);
    const std::size_t bytes =
        m_strands.writeChanged(strands.data(), size, before.data(), before.size() * sizeof(DrawnStrand));
    if (m_strands.capacity() >= size) {
        before = strands;
        m_sent = std::move(before);
    }
    return bytes;
}

std::size_t HairBuffers::uploadStyles()
{
    m_stylesOf.reset();
    constexpr std::size_t chunkBytes = sim::kChunkSlots * sizeof(PackedStyle);
    const auto packedChunks = static_cast<std::size_t>(m_groom->packedChunks);
    if (m_styles.reserve(packedChunks * chunkBytes) || m_roots != m_groom->roots)
        m_uploaded.clear();
    m_roots = m_groom->roots;
    if (m_styles.capacity() < packedChunks * chunkBytes)
        return 0;
    m_uploaded.resize(std::max(packedChunks, m_uploaded.size()));
    std::size_t bytes = 0;
    std::vector<PackedStyle> styles(sim::kChunkSlots);
    for (std::size_t c = 0; c < m_groom->chunks.size(); ++c) {
        const auto& chunk = m_groom->chunks[c];
        if (!chunk || m_groom->packedChunk[c] < 0)
            continue;
        const auto index = static_cast<std::size_t>(m_groom->packedChunk[c]);
        if (m_uploaded[index] == chunk)
            continue;
        for (std::size_t local = 0; local < styles.size(); ++local) {
            // Past the last root there is no hair.
            const std::size_t slot = c * sim::kChunkSlots + local;
            const bool isRoot = slot < m_roots->tangentHd.size();
            styles[local] =
                packedStyle(chunk->styles[local],
                            isRoot ? sim::frameTangentHd(*m_groom, static_cast<std::uint32_t>(slot)) : kNoTangent);
        }
        m_styles.write(index * chunkBytes, styles.data(), chunkBytes);
        m_uploaded[index] = chunk;
        bytes += chunkBytes;
    }
    m_stylesOf = m_groom;
    return bytes;
}

std::size_t HairBuffers::uploadPositions(const std::shared_ptr<const sim::StrandFrame>& frame,
                                         const sim::GroupFrame& group)
{
    if (m_shown.get() == &group.positions)
        return 0;
    const std::shared_ptr<const std::vector<float>> before = std::exchange(m_shown, nullptr);
    const std::size_t size = group.positions.size() * sizeof(float);
    const std::size_t bytes = m_positions.writeChanged(group.positions.data(), size, before ? before->data() : nullptr,
                                                       before ? before->size() * sizeof(float) : 0);
    if (m_positions.capacity() >= size)
        m_shown = std::shared_ptr<const std::vector<float>>(frame, &group.positions);
    return bytes;
}

void HairBuffers::bind() const
{
    m_strands.bindStorage(0);
    m_styles.bindStorage(1);
    m_positions.bindStorage(2);
}

} // namespace hairpaint::rendering
