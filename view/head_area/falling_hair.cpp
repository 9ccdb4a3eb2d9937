// Each piece falls on its own, as through air.
#include "view/head_area/falling_hair.h"

#include "sim/base/deterministic.h"
#include "view/head_area/head_camera.h"

#include <utility>

namespace hairpaint::view {

namespace {

constexpr int kFallMs = 500;
constexpr float kFallM = 0.25F;   ///< Length by which a mean piece falls.
constexpr float kDiffers = 0.4F;  ///< Greatest fraction by which pieces fall further or less.
constexpr float kDriftM = 0.02F;  ///< Greatest drift of a piece aside.
constexpr float kOpacity = 0.85F; ///< Opacity at the begin of the fall.

} // namespace

FallingHair::FallingHair(QObject* parent) : QObject(parent)
{
    m_time.setDuration(kFallMs);
    m_time.setStartValue(0.0);
    m_time.setEndValue(1.0);
    connect(&m_time, &QVariantAnimation::valueChanged, this, &FallingHair::moved);
    connect(&m_time, &QVariantAnimation::finished, this, [this] {
        m_pieces.clear();
        Q_EMIT moved();
    });
}

void FallingHair::start(std::vector<model::CutPiece> pieces)
{
    m_time.stop();
    m_pieces = std::move(pieces);
    if (!m_pieces.empty())
        m_time.start();
    Q_EMIT moved();
}

std::vector<FallingLine> FallingHair::seen(const rendering::Camera& camera, QSizeF size, const SkinDepths& skin) const
{
    const Lens lens(camera, size);
    const float done = m_time.currentValue().toFloat();
    std::vector<FallingLine> lines;
    lines.reserve(m_pieces.size());
    for (std::size_t i = 0; i < m_pieces.size(); ++i) {
        const auto chance = [i](std::uint64_t which) { return 2.0F * sim::unitFloat(sim::hash64(which, i)) - 1.0F; };
        const glm::vec3 fallenWo(chance(1) * kDriftM * done, -kFallM * (1.0F + kDiffers * chance(2)) * done * done,
                                 chance(3) * kDriftM * done);
        const std::uint32_t rgb = m_pieces[i].colour;
        FallingLine line{.line = {},
                         .colour = QColor(static_cast<int>(rgb & 0xFFU), static_cast<int>(rgb >> 8U & 0xFFU),
                                          static_cast<int>(rgb >> 16U & 0xFFU))};
        line.colour.setAlphaF(kOpacity * (1.0F - done));
        const auto end = [&lines, &line] {
            if (line.line.size() > 1)
                lines.push_back(line);
            line.line.clear();
        };
        for (const glm::vec3& point : m_pieces[i].pointsWo) {
            const std::optional<QPointF> at = project(camera, point + fallenWo, size);
            if (at && !skin.hides(lens.seen(point + fallenWo)))
                line.line.push_back(*at);
            else
                end();
        }
        end();
    }
    return lines;
}

} // namespace hairpaint::view
