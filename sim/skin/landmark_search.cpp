// Trimmed iterated closest points.
#include "sim/skin/landmark_search.h"

#include "sim/base/parallel.h"
#include "sim/skin/mesh_bounds.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace hairpaint::sim {

namespace {

struct Sample
{
    glm::vec3 position;
    glm::vec3 normal;
};

/// Squares and products of the coordinates in units of 10 cm, so that they weigh about as much as the coordinates.
constexpr std::size_t kCurvedTerms = 6;
constexpr double kUnitM = 0.1;

std::array<double, kCurvedTerms> curvedTerms(const glm::dvec3& p)
{
    const glm::dvec3 u = p / kUnitM;
    return {u.x * u.x, u.y * u.y, u.z * u.z, u.x * u.y, u.y * u.z, u.z * u.x};
}

/// Where the known head lies: an upright one at first, then an affine map, then one of second order.
struct Pose
{
    glm::dmat3 linear{1.0};
    glm::dvec3 shift{0.0};
    std::array<glm::dvec3, kCurvedTerms> curved{};

    [[nodiscard]] glm::vec3 operator()(const glm::vec3& p) const
    {
        glm::dvec3 sum = linear * glm::dvec3(p) + shift;
        const std::array<double, kCurvedTerms> terms = curvedTerms(p);
        for (std::size_t i = 0; i < kCurvedTerms; ++i)
            sum += terms[i] * curved[i];
        return sum;
    }
    [[nodiscard]] glm::dmat3 slope(const glm::vec3& p) const
    {
        const glm::dvec3 u = glm::dvec3(p) / kUnitM;
        return linear + glm::dmat3(2.0 * u.x * curved[0] + u.y * curved[3] + u.z * curved[5],
                                   2.0 * u.y * curved[1] + u.x * curved[3] + u.z * curved[4],
                                   2.0 * u.z * curved[2] + u.y * curved[4] + u.x * curved[5]) /
                            kUnitM;
    }
    [[nodiscard]] double scale() const { return std::cbrt(std::abs(glm::determinant(linear))); }
};

struct PointPair
{
    glm::dvec3 from;
    glm::dvec3 to;
    glm::dvec3 normal; ///< There.
    double distance;
};

/// About `count` points on the known head without neck and chest, evenly over its area.
std::vector<Sample> headSamples(const Skin& known, const HeadLandmarks& landmarks, double count)
{
    const float lowest = landmarks[HeadLandmark::Chin].y;
    const HeadMesh& mesh = known.mesh();
    std::vector<std::uint32_t> faces;
    double areaM2 = 0.0;
    for (std::uint32_t face = 0; face < mesh.triangles.size(); ++face)
        if (mesh.positionsHd[mesh.triangles[face].x].y > lowest) {
            faces.push_back(face);
            areaM2 += static_cast<double>(known.faceAreaM2(face));
        }
    std::vector<Sample> samples;
    double due = 0.0;
    for (const std::uint32_t face : faces) {
        due += static_cast<double>(known.faceAreaM2(face)) / areaM2 * count;
        if (due < 1.0)
            continue;
        due -= std::floor(due);
        const SurfacePoint point = known.at(face, glm::vec3(1.0F / 3.0F));
        samples.push_back({point.positionHd, point.normalHd});
    }
    return samples;
}

/// The closest pairs of a sample and its point on the skin, the farthest of which are left out, and those whose
/// surfaces face apart.
std::vector<PointPair> closestPairs(const std::vector<Sample>& samples, const Pose& pose, const Skin& skin)
{
    constexpr double kKept = 0.8;
    constexpr double kLeastAgreement = 0.3;
    constexpr std::size_t kGrain = 64;
    std::vector<PointPair> pairs(samples.size());
    parallelFor(samples.size(), kGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const glm::vec3 posed = pose(samples[i].position);
            const SurfacePoint nearest = skin.nearest(posed);
            const glm::dmat3 normalMap = glm::inverse(glm::transpose(pose.slope(samples[i].position)));
            const glm::dvec3 normal = glm::normalize(normalMap * glm::dvec3(samples[i].normal));
            const bool facesApart = glm::dot(normal, glm::dvec3(nearest.normalHd)) < kLeastAgreement;
            const auto distance = static_cast<double>(glm::distance(posed, nearest.positionHd));
            pairs[i] = {samples[i].position, nearest.positionHd, nearest.normalHd,
                        facesApart ? std::numeric_limits<double>::infinity() : distance};
        }
    });
    const auto kept = static_cast<std::ptrdiff_t>(kKept * static_cast<double>(pairs.size()));
    std::ranges::nth_element(pairs, pairs.begin() + kept, {}, &PointPair::distance);
    pairs.resize(static_cast<std::size_t>(kept));
    std::erase_if(pairs, [](const PointPair& pair) { return !std::isfinite(pair.distance); });
    return pairs;
}

struct Means
{
    glm::dvec3 from{0.0};
    glm::dvec3 to{0.0};
};

Means meansOf(const std::vector<PointPair>& pairs)
{
    Means means;
    for (const PointPair& pair : pairs) {
        means.from += pair.from;
        means.to += pair.to;
    }
    const auto count = static_cast<double>(pairs.size());
    return {.from = means.from / count, .to = means.to / count};
}

/// The turn around y, the scale and the shift with the least squared error: heads stand upright.
Pose uprightFit(const std::vector<PointPair>& pairs)
{
    const Means means = meansOf(pairs);
    double cosine = 0.0;
    double sine = 0.0;
    double upright = 0.0;
    double square = 0.0;
    for (const PointPair& pair : pairs) {
        const glm::dvec3 a = pair.from - means.from;
        const glm::dvec3 b = pair.to - means.to;
        cosine += a.x * b.x + a.z * b.z;
        sine += a.z * b.x - a.x * b.z;
        upright += a.y * b.y;
        square += glm::dot(a, a);
    }
    const double level = std::hypot(cosine, sine);
    const double scale = (level + upright) / square;
    const double c = scale * cosine / level;
    const double s = scale * sine / level;
    // By columns: x goes to (c, 0, -s), z to (s, 0, c).
    const glm::dmat3 linear({c, 0.0, -s}, {0.0, scale, 0.0}, {s, 0.0, c});
    return {.linear = linear, .shift = means.to - linear * means.from};
}

/// The least squared error, above all across the skin: along it a point may slide to where it belongs. `Terms` of the
/// curved ones are free, and held back a little, for they reach far. Source: Chen and Medioni, Object Modelling by
/// Registration of Multiple Range Images (1992).
template<int Terms>
Pose bentFit(const std::vector<PointPair>& pairs)
{
    constexpr int kColumns = 4 + Terms;
    constexpr int kUnknowns = 3 * kColumns; // By column, then by coordinate.
    constexpr double kRestraint = 1e-3;
    constexpr double kAlongWeight = 0.02;
    Eigen::Matrix<double, kUnknowns, kUnknowns> within = Eigen::Matrix<double, kUnknowns, kUnknowns>::Zero();
    Eigen::Matrix<double, kUnknowns, 1> across = Eigen::Matrix<double, kUnknowns, 1>::Zero();
    for (const PointPair& pair : pairs) {
        Eigen::Matrix<double, kColumns, 1> row;
        row.template head<4>() << 1.0, pair.from.x / kUnitM, pair.from.y / kUnitM, pair.from.z / kUnitM;
        const std::array<double, kCurvedTerms> terms = curvedTerms(pair.from);
        for (int i = 0; i < Terms; ++i)
            row[4 + i] = terms[static_cast<std::size_t>(i)];
        const Eigen::Vector3d normal(pair.normal.x, pair.normal.y, pair.normal.z);
        const Eigen::Matrix3d weight = normal * normal.transpose() + kAlongWeight * Eigen::Matrix3d::Identity();
        const Eigen::Vector3d weighted = weight * Eigen::Vector3d(pair.to.x, pair.to.y, pair.to.z);
        for (int a = 0; a < kColumns; ++a) {
            across.template segment<3>(3 * a) += row[a] * weighted;
            for (int b = 0; b < kColumns; ++b)
                within.template block<3, 3>(3 * a, 3 * b) += row[a] * row[b] * weight;
        }
    }
    for (int i = 3 * 4; i < kUnknowns; ++i)
        within(i, i) += kRestraint * static_cast<double>(pairs.size());
    const Eigen::Matrix<double, kUnknowns, 1> map = within.ldlt().solve(across);
    const auto column = [&map](int i) { return glm::dvec3(map[3 * i], map[3 * i + 1], map[3 * i + 2]); };
    Pose pose{.linear = glm::dmat3(column(1), column(2), column(3)) / kUnitM, .shift = column(0)};
    for (int i = 0; i < Terms; ++i)
        pose.curved[static_cast<std::size_t>(i)] = column(4 + i);
    return pose;
}

/// Mean distance of the pairs, in lengths of the known head: a head shrunken into a corner is no better for it.
double errorOf(const std::vector<PointPair>& pairs, const Pose& pose, std::size_t samples)
{
    if (pairs.size() * 2 < samples)
        return std::numeric_limits<double>::infinity();
    double sum = 0.0;
    for (const PointPair& pair : pairs)
        sum += pair.distance;
    return sum / static_cast<double>(pairs.size()) / pose.scale();
}

/// The known head at a scale and turned, its crown at the unknown one's top.
Pose startPose(const Skin& unknown, const HeadLandmarks& landmarks, double scale, double turn)
{
    const MeshBounds bounds = boundsOf(unknown.mesh());
    const glm::vec3 crown = landmarks[HeadLandmark::Crown];
    const double height = scale * static_cast<double>(crown.y - landmarks[HeadLandmark::Chin].y);
    // The middle of what lies about as high as a forehead.
    glm::dvec3 sum(0.0);
    double count = 0.0;
    for (const glm::vec3& p : unknown.mesh().positionsHd)
        if (static_cast<double>(bounds.greatest.y - p.y) < 0.4 * height) {
            sum += glm::dvec3(p);
            count += 1.0;
        }
    const double c = scale * std::cos(turn);
    const double s = scale * std::sin(turn);
    Pose pose{.linear = glm::dmat3({c, 0.0, -s}, {0.0, scale, 0.0}, {s, 0.0, c}), .shift = sum / count};
    pose.shift.y = static_cast<double>(bounds.greatest.y) - scale * static_cast<double>(crown.y);
    return pose;
}

/// Moves the pose until it fits; false where too little of the head has a counterpart, or next to none of it is left.
bool fit(Pose& pose, const std::vector<Sample>& samples, const Skin& unknown, int rounds,
         Pose (*best)(const std::vector<PointPair>&))
{
    constexpr double kLeastScale = 1e-3; // A head may be 1 mm large.
    for (int round = 0; round < rounds; ++round) {
        const std::vector<PointPair> pairs = closestPairs(samples, pose, unknown);
        if (pairs.size() < samples.size() / 4)
            return false;
        pose = best(pairs);
        if (!(pose.scale() > kLeastScale && pose.scale() < 1.0 / kLeastScale))
            return false;
    }
    return true;
}

struct Try
{
    Pose pose;
    double error = std::numeric_limits<double>::infinity();
};

/// Every size and quarter turn, roughly fitted, the best first. Empty where it is stopped.
std::vector<Try> roughTries(const Skin& unknown, const Skin& known, const HeadLandmarks& landmarks,
                            const std::function<bool(double)>& goesOn)
{
    constexpr int kTurns = 4;
    constexpr std::array kHeadsHigh = {1.0, 1.35, 1.9, 7.5}; // A head; with its neck; a bust; a body.
    constexpr double kSamples = 160.0;
    constexpr int kRounds = 10;
    constexpr double kTurnedPenalty = 1.15; ///< Where two turns fit about equally well it faces +z.
    const std::vector<Sample> samples = headSamples(known, landmarks, kSamples);
    const auto headM = static_cast<double>(landmarks[HeadLandmark::Crown].y - landmarks[HeadLandmark::Chin].y);
    const double heightInHeads = static_cast<double>(boundsOf(unknown.mesh()).size().y) / headM;
    std::vector<Try> tries;
    for (int turn = 0; turn < kTurns; ++turn)
        for (const double headsHigh : kHeadsHigh) {
            if (goesOn && !goesOn(static_cast<double>(tries.size()) / (kTurns * kHeadsHigh.size() + 1)))
                return {};
            const double angle = turn * std::numbers::pi / 2.0;
            Try one{.pose = startPose(unknown, landmarks, heightInHeads / headsHigh, angle)};
            if (fit(one.pose, samples, unknown, kRounds, uprightFit))
                one.error = errorOf(closestPairs(samples, one.pose, unknown), one.pose, samples.size()) *
                            (turn == 0 ? 1.0 : kTurnedPenalty);
            tries.push_back(one);
        }
    std::ranges::sort(tries, {}, &Try::error);
    return tries;
}

} // namespace

std::optional<HeadLandmarks> findLandmarks(const Skin& unknown, const Skin& known, const HeadLandmarks& knownLandmarks,
                                           const std::function<bool(double)>& goesOn)
{
    constexpr double kSamples = 600.0;
    constexpr int kUprightRounds = 24;
    constexpr int kBentRounds = 16;
    if (!(unknown.areaM2() > 0.0))
        return std::nullopt;
    const std::vector<Try> tries = roughTries(unknown, known, knownLandmarks, goesOn);
    if (tries.empty() || !std::isfinite(tries.front().error))
        return std::nullopt;
    const std::vector<Sample> samples = headSamples(known, knownLandmarks, kSamples);
    Pose pose = tries.front().pose;
    if (!fit(pose, samples, unknown, kUprightRounds, uprightFit))
        return std::nullopt;
    Pose bent = pose;
    if (fit(bent, samples, unknown, kBentRounds, bentFit<0>) &&
        fit(bent, samples, unknown, kBentRounds, bentFit<kCurvedTerms>))
        pose = bent;
    HeadLandmarks found;
    for (std::size_t i = 0; i < kHeadLandmarkCount; ++i)
        found.positionsHd[i] = unknown.nearest(pose(knownLandmarks.positionsHd[i])).positionHd;
    return found;
}

} // namespace hairpaint::sim
