// Takes the farthest of the head's samples in each cell.
#include "view/rendering/software/head_occlusion.h"

#include <algorithm>
#include <limits>

namespace hairpaint::rendering {
namespace {

constexpr float kNothingHiddenM = std::numeric_limits<float>::max();
constexpr std::uint16_t kWholeSample = 0xFFFF;

/// Distance beyond which the sample hides all hair, as coverBeforeHead() has it.
float beyondAt(const HeadOcclusion::Picture& picture, std::size_t sample)
{
    if (picture.samples[sample].cover != kWholeSample)
        return kNothingHiddenM;
    return picture.distancesM[sample] + hairShownBehindM(picture.worn != nullptr && picture.worn[sample] != 0);
}

float beyondIn(const HeadOcclusion::Picture& picture, int x0, int y0)
{
    float farthestM = 0.0F;
    const int endX = std::min(x0 + kOcclusionCellSp, picture.width);
    const int endY = std::min(y0 + kOcclusionCellSp, picture.height);
    for (int y = y0; y < endY && farthestM < kNothingHiddenM; ++y) {
        const std::size_t row = static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width);
        for (int x = x0; x < endX; ++x)
            farthestM = std::max(farthestM, beyondAt(picture, row + static_cast<std::size_t>(x)));
    }
    return farthestM;
}

int halved(int cells)
{
    return (cells + 1) / 2;
}

} // namespace

void HeadOcclusion::resize(int width, int height)
{
    m_across = (width + kOcclusionCellSp - 1) / kOcclusionCellSp;
    m_up = (height + kOcclusionCellSp - 1) / kOcclusionCellSp;
    int rows = 0;
    int up = m_up;
    for (int& first : m_firstRow) {
        first = rows;
        rows += up;
        up = halved(up);
    }
    m_beyondM.resize(static_cast<std::size_t>(rows) * static_cast<std::size_t>(m_across));
}

void HeadOcclusion::fillRows(const Picture& picture, int firstRow, int endRow, bool anyHead)
{
    for (int y = firstRow; y < endRow; y += kOcclusionCellSp) {
        float* row =
            m_beyondM.data() + static_cast<std::size_t>(y / kOcclusionCellSp) * static_cast<std::size_t>(m_across);
        for (int x = 0; x < m_across; ++x)
            row[x] = anyHead ? beyondIn(picture, x * kOcclusionCellSp, y) : kNothingHiddenM;
    }
}

void HeadOcclusion::combine()
{
    int across = m_across;
    int up = m_up;
    const auto stride = static_cast<std::size_t>(m_across);
    for (std::size_t level = 0; level < m_firstRow.size(); ++level) {
        float* cells = m_beyondM.data() + static_cast<std::size_t>(m_firstRow[level]) * stride;
        // Each takes in neighbours that have not yet taken in theirs.
        for (int y = 0; y < up; ++y) {
            float* row = cells + static_cast<std::size_t>(y) * stride;
            const float* above = row + (y + 1 < up ? stride : 0);
            for (int x = 0; x < across; ++x) {
                const int right = std::min(x + 1, across - 1);
                row[x] = std::max({row[x], row[right], above[x], above[right]});
            }
        }
        if (level + 1 == m_firstRow.size())
            return;
        float* coarser = m_beyondM.data() + static_cast<std::size_t>(m_firstRow[level + 1]) * stride;
        across = halved(across);
        up = halved(up);
        for (int y = 0; y < up; ++y)
            for (int x = 0; x < across; ++x)
                coarser[static_cast<std::size_t>(y) * stride + static_cast<std::size_t>(x)] =
                    cells[2 * (static_cast<std::size_t>(y) * stride + static_cast<std::size_t>(x))];
    }
}

} // namespace hairpaint::rendering
