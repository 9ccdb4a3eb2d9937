// Outlines over the 3D area.
#include "view/head_area/head_overlay.h"

#include "view/editing/painted_area.h"
#include "view/head_area/head_camera.h"
#include "view/head_area/worn_outline.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace hairpaint::view {

namespace {

constexpr double kStepUv = 1.0 / 128.0;
constexpr int kMostSteps = 64;             ///< Between two corners.
constexpr double kDirectionsOpacity = 0.6; ///< Hair is seen below.
constexpr double kFadedOpacity = 0.1;
constexpr int kFadeMs = 150;

/// Where a point of the map shows; none off the skin or on the far side.
std::optional<QPointF> shownAt(QPointF uv, const sim::Skin& skin, const rendering::Camera& camera,
                               const sim::HeadPose& pose, QSizeF size)
{
    const std::optional<sim::SurfacePoint> point = skin.atUv({static_cast<float>(uv.x()), static_cast<float>(uv.y())});
    if (!point)
        return std::nullopt;
    const glm::vec3 positionWo = inWorld(point->positionHd, pose);
    if (glm::dot(pose.rotation * point->normalHd, camera.eyeWo() - positionWo) <= 0.0F)
        return std::nullopt;
    return project(camera, positionWo, size);
}

} // namespace

HeadOverlay::HeadOverlay(const Theme& theme, QWidget* parent) : QWidget(parent), m_theme(theme)
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    hide();
    m_fading.setDuration(kFadeMs);
    m_fading.setStartValue(kDirectionsOpacity);
    m_fading.setEndValue(kFadedOpacity);
    connect(&m_fading, &QVariantAnimation::valueChanged, this, qOverload<>(&QWidget::update));
}

void HeadOverlay::setTheme(const Theme& theme)
{
    m_theme = theme;
    update();
}

void HeadOverlay::setShapes(const std::vector<model::OverlayShape>& shapes, const sim::Skin* skin,
                            const rendering::Camera& camera, const sim::HeadPose& pose)
{
    m_lines.clear();
    m_handles.clear();
    for (const model::OverlayShape& shape : shapes) {
        const qsizetype corners = shape.uvOutline.size();
        QPolygonF line;
        const auto add = [&](QPointF uv) {
            if (const std::optional<QPointF> at = shownAt(uv, *skin, camera, pose, QSizeF(size()))) {
                line.push_back(*at);
            } else if (!line.isEmpty()) {
                m_lines.push_back(std::exchange(line, {}));
            }
        };
        for (qsizetype i = 0; skin != nullptr && i < (shape.closed ? corners : corners - 1); ++i) {
            const QPointF from = shape.uvOutline[i];
            const QPointF to = shape.uvOutline[(i + 1) % corners];
            const QPointF displacement = to - from;
            const int steps =
                std::clamp(static_cast<int>(std::hypot(displacement.x(), displacement.y()) / kStepUv), 1, kMostSteps);
            for (int k = i == 0 ? 0 : 1; k <= steps; ++k)
                add(from + displacement * k / steps);
        }
        if (!line.isEmpty())
            m_lines.push_back(line);
        for (qsizetype i = 0; skin != nullptr && i < shape.uvHandles.size(); ++i)
            if (const auto at = shownAt(shape.uvHandles[i], *skin, camera, pose, QSizeF(size())))
                m_handles.push_back(*at);
    }
    showIfNeeded();
}

void HeadOverlay::setPictureLine(model::PictureLine line)
{
    if (line.line == m_pictureLine.line && line.closed == m_pictureLine.closed)
        return;
    m_pictureLine = std::move(line);
    showIfNeeded();
}

void HeadOverlay::setGuides(const std::vector<model::GuideStrand>& guides, const rendering::Camera& camera,
                            const sim::HeadPose& pose)
{
    if (guides.empty() && m_guides.empty())
        return;
    m_guides.clear();
    m_heldGuide.clear();
    for (const model::GuideStrand& guide : guides) {
        QPolygonF line;
        for (const glm::vec3& node : guide.nodesHd)
            if (const std::optional<QPointF> at = project(camera, inWorld(node, pose), QSizeF(size())))
                line.push_back(*at);
        if (guide.held)
            m_heldGuide = line;
        m_guides.push_back(std::move(line));
    }
    showIfNeeded();
}

void HeadOverlay::setFalling(std::vector<FallingLine> falling)
{
    if (falling.empty() && m_falling.empty())
        return;
    m_falling = std::move(falling);
    showIfNeeded();
}

void HeadOverlay::setStrands(std::vector<QPolygonF> strands, const QRectF& ring)
{
    if (strands.empty() && m_strands.empty() && ring == m_strandRing)
        return;
    m_strands = std::move(strands);
    m_strandRing = ring;
    showIfNeeded();
}

void HeadOverlay::setWorn(const std::vector<model::Worn>& worn, model::Id chosen, bool inReach, const HeadSight& sight)
{
    if (worn.empty() && m_wornOutlines.empty())
        return;
    m_wornOutlines.clear();
    m_chosen.clear();
    m_chosenEnds.clear();
    for (const model::Worn& one : worn) {
        std::vector<QPolygonF> outlines = outlinesOf(one.shape, sight);
        if (one.id == chosen) {
            m_chosen = outlines;
            if (inReach)
                for (const WornHandle& handle : handlesOf(one, sight))
                    m_chosenEnds.push_back(handle.at);
        }
        std::ranges::move(outlines, std::back_inserter(m_wornOutlines));
    }
    showIfNeeded();
}

void HeadOverlay::setGhost(const QPolygonF& ring)
{
    if (ring == m_ghost)
        return;
    m_ghost = ring;
    showIfNeeded();
}

void HeadOverlay::setDirections(std::vector<HairSpine> hairs)
{
    if (hairs.empty() && m_directions.empty())
        return;
    m_directions = std::move(hairs);
    m_directionsPicture = QImage();
    if (!m_directions.empty()) {
        const double ratio = devicePixelRatioF();
        m_directionsPicture = QImage((QSizeF(size()) * ratio).toSize(), QImage::Format_ARGB32_Premultiplied);
        m_directionsPicture.setDevicePixelRatio(ratio);
        m_directionsPicture.fill(Qt::transparent);
        QPainter painter(&m_directionsPicture);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(Qt::NoPen);
        for (const HairSpine& hair : m_directions)
            drawTaperedHair(painter, hair);
    }
    showIfNeeded();
}

void HeadOverlay::setDirectionsFaded(bool faded)
{
    if (std::exchange(m_directionsFaded, faded) == faded)
        return;
    m_fading.setDirection(faded ? QAbstractAnimation::Forward : QAbstractAnimation::Backward);
    m_fading.start();
}

void HeadOverlay::showIfNeeded()
{
    setVisible(!m_directions.empty() || !m_lines.empty() || !m_handles.isEmpty() || !m_ghost.isEmpty() ||
               !m_wornOutlines.empty() || m_pictureLine.line.size() > 1 || !m_falling.empty() ||
               !m_strandRing.isEmpty() || !m_guides.empty());
    update();
}

void HeadOverlay::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (!m_directions.empty()) {
        painter.setOpacity(m_fading.currentValue().toDouble());
        painter.drawImage(QPointF(), m_directionsPicture);
        painter.setOpacity(1.0);
    }
    for (const FallingLine& hair : m_falling) {
        painter.setPen(QPen(hair.colour, 1.0));
        painter.drawPolyline(hair.line);
    }
    for (const auto& [colour, width] : {std::pair(QColor(0, 0, 0, 110), 2.5), std::pair(m_theme.accent, 1.0)}) {
        painter.setPen(QPen(colour, width));
        for (const QPolygonF& ellipse : m_wornOutlines)
            painter.drawPolyline(ellipse);
    }
    painter.setPen(QPen(m_theme.accent, 2.5));
    for (const QPolygonF& ellipse : m_chosen)
        painter.drawPolyline(ellipse);
    painter.setPen(QPen(QColor(0, 0, 0, 190), 1.0));
    painter.setBrush(QColor(255, 255, 255, 235));
    for (const QPointF& end : m_chosenEnds)
        painter.drawRect(handleAt(end));
    painter.setBrush(Qt::NoBrush);
    QColor tint = m_theme.accent;
    tint.setAlpha(110);
    painter.setPen(QPen(tint, 1.0));
    for (const QPolygonF& strand : m_strands)
        painter.drawPolyline(strand);
    // White on dark, as the rings are: seen on hair and skin of every colour.
    for (const auto& [colour, width] :
         {std::pair(QColor(0, 0, 0, 170), 3.0), std::pair(QColor(255, 255, 255, 235), 1.5)}) {
        painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        for (const QPolygonF& line : m_lines)
            painter.drawPolyline(line);
        if (m_pictureLine.closed)
            painter.drawPolygon(m_pictureLine.line);
        else
            painter.drawPolyline(m_pictureLine.line);
        if (!m_strandRing.isEmpty())
            painter.drawEllipse(m_strandRing);
    }
    for (const auto& [colour, width] :
         {std::pair(QColor(0, 0, 0, 120), 2.5), std::pair(QColor(255, 255, 255, 200), 1.0)}) {
        painter.setPen(QPen(colour, width));
        for (const QPolygonF& guide : m_guides)
            painter.drawPolyline(guide);
    }
    painter.setPen(QPen(m_theme.accent, 2.5));
    painter.drawPolyline(m_heldGuide);
    painter.setPen(QPen(QColor(0, 0, 0, 190), 1.0));
    painter.setBrush(QColor(255, 255, 255, 235));
    for (const QPointF& handle : m_handles)
        painter.drawRect(handleAt(handle));
    constexpr double kNodePx = 2.5;
    for (const QPolygonF& guide : m_guides)
        for (qsizetype i = 1; i < guide.size(); ++i)
            painter.drawEllipse(guide[i], kNodePx, kNodePx);
    if (!m_ghost.isEmpty()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(QColor(0, 0, 0, 120), 3.0));
        painter.drawPolygon(m_ghost);
        QPen dashes(QColor(255, 255, 255, 200), 1.5);
        dashes.setDashPattern({3.0, 3.0});
        painter.setPen(dashes);
        painter.drawPolygon(m_ghost);
        const QString words = tr("on the far side");
        painter.setFont(themeFont(TextRole::Status));
        const QRectF bounds = m_ghost.boundingRect();
        const double width = painter.fontMetrics().horizontalAdvance(words) + 12.0;
        const QRectF label(bounds.center().x() - width / 2.0, bounds.bottom() + 6.0, width, 18.0);
        painter.setPen(Qt::NoPen);
        painter.setBrush(QColor(0, 0, 0, 140));
        painter.drawRoundedRect(label, 4.0, 4.0);
        painter.setPen(QColor(255, 255, 255, 225));
        painter.drawText(label, Qt::AlignCenter, words);
    }
}

} // namespace hairpaint::view
