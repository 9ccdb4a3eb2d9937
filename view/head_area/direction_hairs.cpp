// Roots that are thinned by a grid over the picture.
#include "view/head_area/direction_hairs.h"

#include "sim/groom/direction_texel.h"
#include "sim/groom/roots.h"
#include "view/head_area/head_camera.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace hairpaint::view {

namespace {

constexpr std::size_t kRoots = 40'000; ///< 3 mm apart on a bust.
constexpr std::uint64_t kSeed = 7;
constexpr double kLeastApartPx = 12.0;
constexpr double kMostHairs = 4000.0; ///< Over the whole picture, of which a head fills half.
constexpr float kBald = 0.01F;

/// Points of a picture, none nearer to another than a distance.
class SpacedPoints
{
public:
    SpacedPoints(QSizeF size, double apartPx)
        : m_apartPx(apartPx), m_columns(static_cast<int>(size.width() / apartPx) + 3),
          m_rows(static_cast<int>(size.height() / apartPx) + 3), m_cells(static_cast<std::size_t>(m_columns * m_rows))
    {}

    [[nodiscard]] bool hasRoom(QPointF at) const
    {
        const auto [column, row] = cellOf(at);
        if (column < 1 || row < 1 || column >= m_columns - 1 || row >= m_rows - 1)
            return false;
        if (m_cells[indexOf(column, row)])
            return false;
        for (int y = row - 1; y <= row + 1; ++y)
            for (int x = column - 1; x <= column + 1; ++x)
                if (const std::optional<QPointF>& there = m_cells[indexOf(x, y)];
                    there && std::hypot(there->x() - at.x(), there->y() - at.y()) < m_apartPx)
                    return false;
        return true;
    }
    void take(QPointF at)
    {
        const auto [column, row] = cellOf(at);
        m_cells[indexOf(column, row)] = at;
    }

private:
    [[nodiscard]] std::size_t indexOf(int column, int row) const
    {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(m_columns) + static_cast<std::size_t>(column);
    }
    /// One cell is a margin.
    [[nodiscard]] std::pair<int, int> cellOf(QPointF at) const
    {
        return {static_cast<int>(std::floor(at.x() / m_apartPx)) + 1,
                static_cast<int>(std::floor(at.y() / m_apartPx)) + 1};
    }

    double m_apartPx;
    int m_columns, m_rows;
    std::vector<std::optional<QPointF>> m_cells; ///< One point each.
};

/// What a camera sees of head space.
class Picture
{
public:
    Picture(const rendering::Camera& camera, const sim::HeadPose& pose, QSizeF size)
        : m_clip(camera.projection(static_cast<float>(size.width() / std::max(1.0, size.height()))) * camera.view()),
          m_pose(pose), m_size(size),
          m_pxPerClipW(static_cast<float>(size.height()) / (2.0F * std::tan(camera.fieldOfViewRad / 2.0F)))
    {}

    struct Point
    {
        QPointF at;
        float pxPerM;
    };
    [[nodiscard]] std::optional<Point> pointOf(glm::vec3 positionHd) const
    {
        const glm::vec4 clip = m_clip * glm::vec4(inWorld(positionHd, m_pose), 1.0F);
        if (clip.w <= 0.0F)
            return std::nullopt;
        return Point{{(static_cast<double>(clip.x / clip.w) * 0.5 + 0.5) * m_size.width(),
                      (0.5 - static_cast<double>(clip.y / clip.w) * 0.5) * m_size.height()},
                     m_pxPerClipW / clip.w};
    }

private:
    glm::mat4 m_clip;
    sim::HeadPose m_pose;
    QSizeF m_size;
    float m_pxPerClipW;
};

} // namespace

void DirectionHairs::takeSkin(const std::shared_ptr<const sim::Skin>& skin)
{
    if (skin == m_skin)
        return;
    m_skin = skin;
    m_roots.clear();
    const std::shared_ptr<const sim::RootSet> roots = sim::buildRoots(skin, kRoots, 1, kSeed);
    m_roots.reserve(roots->count());
    for (const std::uint32_t slot : roots->slotOfRank) {
        const std::optional<sim::SurfacePoint> point = skin->atUv(roots->uv[slot]);
        if (!point)
            continue;
        Root& root = m_roots.emplace_back();
        root.point = *point;
        root.frame = sim::SkinFrame::at(*point);
        const glm::mat2 mPerUv(root.frame.fromHd(point->dPduHd), root.frame.fromHd(point->dPdvHd));
        if (const glm::mat2 uvPerM = glm::inverse(mPerUv); std::isfinite(uvPerM[0][0] + uvPerM[1][1]))
            root.uvPerM = uvPerM;
    }
}

std::vector<HairSpine> DirectionHairs::seen(const std::shared_ptr<const sim::Skin>& skin, const DirectionField& field,
                                            const rendering::Camera& camera, const sim::HeadPose& pose, QSizeF size)
{
    std::vector<HairSpine> hairs;
    if (skin == nullptr || field.direction == nullptr || size.isEmpty())
        return hairs;
    takeSkin(skin);
    const sim::TiledRaster* density = field.density.get();
    if (density != nullptr && density->uniformValue() == sim::Texel{})
        density = nullptr;
    const Picture picture(camera, pose, size);
    const glm::vec3 eyeHd = inHead({.originWo = camera.eyeWo()}, pose).originHd;
    SpacedPoints points(size, std::max(kLeastApartPx, std::sqrt(size.width() * size.height() / kMostHairs)));
    for (const Root& root : m_roots) {
        if (glm::dot(root.point.normalHd, eyeHd - root.point.positionHd) <= 0.0F)
            continue;
        const std::optional<Picture::Point> point = picture.pointOf(root.point.positionHd);
        if (!point || !points.hasRoom(point->at) ||
            (density != nullptr && density->sampleScalar(root.point.uv) < kBald) ||
            hidden(root.point, skin.get(), camera, pose))
            continue;
        points.take(point->at);
        // Two halves of one length; each lies as the map says under its beginning and stands for the rest.
        const float halfM = static_cast<float>(kTaperedHairPx) * 0.5F / point->pxPerM;
        const auto halfFrom = [&](glm::vec2 direction) {
            const float up = std::sqrt(std::max(0.0F, 1.0F - glm::dot(direction, direction)));
            return (root.frame.toHd(direction) + root.frame.normal * up) * halfM;
        };
        const glm::vec2 first = sim::directionAt(*field.direction, root.point.uv);
        const glm::vec2 then = sim::directionAt(*field.direction, root.point.uv + root.uvPerM * (first * halfM));
        const glm::vec3 middleHd = root.point.positionHd + halfFrom(first);
        const std::optional<Picture::Point> middle = picture.pointOf(middleHd);
        const std::optional<Picture::Point> tip = picture.pointOf(middleHd + halfFrom(then));
        if (middle && tip)
            hairs.push_back({point->at, middle->at, tip->at});
    }
    return hairs;
}

} // namespace hairpaint::view
