// Lengths kept while a point is pulled, and dabs from the tip back to the root.
#include "model/tools/shaping/bent_hair.h"

#include "model/tools/strokes/dab_shape.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::model {

namespace {

constexpr int kMostRounds = 64;
constexpr float kWithinM = 1e-5F;
constexpr float kNearSkinM = 0.025F; ///< Hair further off hangs free.
constexpr float kStepOfRadius = 0.5F;

glm::vec3 towards(glm::vec3 from, glm::vec3 to, float lengthM)
{
    const glm::vec3 offset = to - from;
    const float distance = glm::length(offset);
    return distance > 1e-9F ? from + offset * (lengthM / distance) : from + glm::vec3(0.0F, -lengthM, 0.0F);
}

/// A point of a course and the unit direction in which it goes on.
struct CoursePoint
{
    sim::SurfacePoint skin;
    glm::vec3 alongHd{0.0F};
};

std::vector<CoursePoint> pointsNearSkin(const HairCourse& course, const sim::Skin& skin, float stepM)
{
    std::vector<CoursePoint> points;
    float untilNextM = 0.0F;
    for (std::size_t i = 0; i + 1 < course.size(); ++i) {
        const glm::vec3 segment = course[i + 1] - course[i];
        const float lengthM = glm::length(segment);
        while (untilNextM < lengthM) {
            const glm::vec3 at = course[i] + segment * (untilNextM / lengthM);
            const sim::SurfacePoint below = skin.nearest(at);
            if (!points.empty() && glm::distance(below.positionHd, at) > kNearSkinM)
                return points;
            points.push_back({.skin = below, .alongHd = segment / lengthM});
            untilNextM += stepM;
        }
        untilNextM -= lengthM;
    }
    return points;
}

} // namespace

std::size_t nodeAlong(HairCourse& course, float alongM)
{
    constexpr float kSameM = 1e-3F;
    float leftM = alongM;
    for (std::size_t i = 1; i < course.size(); ++i) {
        const float lengthM = glm::distance(course[i - 1], course[i]);
        if (std::abs(leftM - lengthM) < kSameM)
            return i;
        if (leftM < lengthM) {
            if (leftM < kSameM && i > 1)
                return i - 1;
            course.insert(course.begin() + static_cast<std::ptrdiff_t>(i),
                          glm::mix(course[i - 1], course[i], std::max(leftM, kSameM) / lengthM));
            return i;
        }
        leftM -= lengthM;
    }
    return course.size() - 1;
}

void bendHair(HairCourse& course, std::size_t node, glm::vec3 targetHd)
{
    if (node == 0 || node >= course.size())
        return;
    std::vector<float> lengthsM(node);
    float reachM = 0.0F;
    for (std::size_t i = 0; i < node; ++i)
        reachM += lengthsM[i] = glm::distance(course[i], course[i + 1]);
    const glm::vec3 root = course.front();
    const glm::vec3 was = course[node];
    const glm::vec3 target =
        glm::distance(root, targetHd) > reachM ? towards(root, targetHd, reachM * (1.0F - 1e-6F)) : targetHd;
    for (int round = 0; round < kMostRounds && glm::distance(course[node], target) > kWithinM; ++round) {
        course[node] = target;
        for (std::size_t i = node; i-- > 0;)
            course[i] = towards(course[i + 1], course[i], lengthsM[i]);
        course.front() = root;
        for (std::size_t i = 0; i < node; ++i)
            course[i + 1] = towards(course[i], course[i + 1], lengthsM[i]);
    }
    for (std::size_t i = node + 1; i < course.size(); ++i)
        course[i] += course[node] - was;
}

LaidHair layAlong(std::span<const HairCourse> courses, const LayShape& shape, SkinFrames& frames, int mapSize,
                  std::span<const sim::TexelRect> clips)
{
    LaidHair laid{.masks = StrokeBuffer(mapSize), .field = CombField(mapSize)};
    for (const HairCourse& course : courses) {
        std::vector<CoursePoint> points = pointsNearSkin(course, frames.skin(), kStepOfRadius * shape.radiusM);
        std::ranges::reverse(points); // The root's own direction counts most, so it comes last.
        for (const CoursePoint& point : points) {
            Dab dab = dabAt(SkinMetric::at(point.skin), point.skin.uv, shape.radiusM, mapSize);
            dab.hardness = shape.hardness;
            for (const sim::TexelRect& clip : clips)
                laid.masks.add(dab, clip);
            const sim::SkinFrame centre = sim::SkinFrame::at(point.skin);
            laid.field.add(dab, [&](int x, int y) -> std::optional<glm::vec2> {
                const glm::vec2 uvDown = (glm::vec2(x, y) + 0.5F) / static_cast<float>(mapSize);
                const sim::SkinFrame frame = frames.at({uvDown.x, 1.0F - uvDown.y}).value_or(centre);
                const glm::vec2 inPlane = frame.fromHd(point.alongHd);
                const float length = glm::length(inPlane);
                // What would go into the head lies flat on it.
                const float wanted = glm::dot(point.alongHd, frame.normal) < 0.0F ? 1.0F : length;
                return length > 1e-4F ? inPlane * (wanted / length) : glm::vec2(0.0F);
            });
        }
    }
    return laid;
}

} // namespace hairpaint::model
