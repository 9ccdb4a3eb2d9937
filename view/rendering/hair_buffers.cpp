// Sends one group's hair to the GPU.
#include "view/rendering/hair_buffers.h"

#include "sim/groom/strand_curve.h"

namespace hairpaint::rendering {
namespace {

constexpr glm::vec3 kNoTangent{1.0F, 0.0F, 0.0F};

} // namespace

std::size_t HairBuffers::upload(const std::shared_ptr<const sim::StrandFrame>& frame, const sim::GroupFrame& group,
                                float detail, int smoothSegments)
{
    std::size_t bytes = 0;
    if (m_list.update(group.groom, detail, smoothSegments)) {
        const std::vector<DrawnStrand>& strands = m_list.strands();
        bytes += m_strands.writeChanged(strands.data(), strands.size() * sizeof(DrawnStrand), m_sent.data(),
                                        m_sent.size() * sizeof(DrawnStrand));
        m_sent = strands;
    }
    if (group.groom != m_groom) {
        m_groom = group.groom;
        bytes += uploadStyles();
    }
    return bytes + uploadPositions(frame, group);
}

void HairBuffers::release()
{
    if (m_groom)
        *this = HairBuffers();
}

std::size_t HairBuffers::uploadStyles()
{
    constexpr std::size_t chunkBytes = sim::kChunkSlots * sizeof(PackedStyle);
    const auto packedChunks = static_cast<std::size_t>(m_groom->packedChunks);
    if (packedChunks * chunkBytes > m_styles.capacity() || m_roots != m_groom->roots)
        m_uploaded.clear();
    m_roots = m_groom->roots;
    m_styles.reserve(packedChunks * chunkBytes);
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
        m_uploaded[index] = chunk;
        for (std::size_t local = 0; local < styles.size(); ++local) {
            // Past the last root there is no hair.
            const std::size_t slot = c * sim::kChunkSlots + local;
            const bool isRoot = slot < m_roots->tangentHd.size();
            styles[local] =
                packed(chunk->styles[local],
                       isRoot ? sim::frameTangentHd(*m_groom, static_cast<std::uint32_t>(slot)) : kNoTangent);
        }
        m_styles.write(index * chunkBytes, styles.data(), chunkBytes);
        bytes += chunkBytes;
    }
    return bytes;
}

std::size_t HairBuffers::uploadPositions(const std::shared_ptr<const sim::StrandFrame>& frame,
                                         const sim::GroupFrame& group)
{
    if (m_shown.get() == &group.positions)
        return 0;
    const std::vector<float>* before = m_shown.get();
    const std::size_t bytes = m_positions.writeChanged(group.positions.data(), group.positions.size() * sizeof(float),
                                                       before != nullptr ? before->data() : nullptr,
                                                       before != nullptr ? before->size() * sizeof(float) : 0);
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
