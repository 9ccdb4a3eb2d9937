// The warp that brings two heads together.
#include "sim/skin/head_warp.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <cmath>
#include <vector>

using namespace hairpaint::sim;

namespace {

HeadLandmarks someLandmarks()
{
    return {.positionsHd = {{{0.0F, 0.11F, -0.037F},
                             {0.0F, 0.0745F, 0.078F},
                             {0.0F, -0.0625F, -0.077F},
                             {0.074F, -0.018F, -0.006F},
                             {-0.074F, -0.018F, -0.006F},
                             {0.0F, -0.036F, 0.111F},
                             {0.0F, -0.112F, 0.088F}}}};
}

const std::vector<glm::vec3> kPoints = {
    {0.0F, 0.0F, 0.0F}, {0.05F, 0.08F, 0.02F}, {-0.07F, -0.2F, 0.1F}, {0.3F, 1.0F, -0.4F}};

} // namespace

class TestHeadWarp : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void landmarksGoToLandmarks()
    {
        const HeadLandmarks from = someLandmarks();
        HeadLandmarks to = from;
        for (std::size_t i = 0; i < to.positionsHd.size(); ++i)
            to.positionsHd[i] +=
                0.01F * glm::vec3(std::sin(3.0F * static_cast<float>(i)), std::cos(2.0F * static_cast<float>(i)),
                                  std::sin(static_cast<float>(i)));
        const HeadWarp warp(from, to);
        for (std::size_t i = 0; i < to.positionsHd.size(); ++i)
            QVERIFY(glm::distance(warp(from.positionsHd[i]), to.positionsHd[i]) < 1e-5F);
    }

    void anAffineMapComesOutEverywhere()
    {
        const auto moved = [](const glm::vec3& p) {
            return glm::vec3(1.2F * p.x + 0.1F * p.y, 0.8F * p.y - 0.2F * p.z + 1.5F, 0.9F * p.z + 0.05F * p.x);
        };
        const HeadLandmarks from = someLandmarks();
        HeadLandmarks to;
        for (std::size_t i = 0; i < to.positionsHd.size(); ++i)
            to.positionsHd[i] = moved(from.positionsHd[i]);
        const HeadWarp warp(from, to);
        for (const glm::vec3& p : kPoints)
            QVERIFY(glm::distance(warp(p), moved(p)) < 1e-4F);
    }

    void landmarksAtOnePointGiveNumbersAllTheSame()
    {
        const HeadLandmarks from{};
        const HeadWarp warp(from, someLandmarks());
        for (const glm::vec3& p : kPoints)
            QVERIFY(std::isfinite(glm::length(warp(p))));
    }
};

HAIRPAINT_TEST(TestHeadWarp, None)
#include "test_head_warp.moc"
