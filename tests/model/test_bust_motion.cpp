// Whole styles on the bust through storms: skin contact, neck and gusts included.
#include "model/document/document.h"
#include "sim/motion/simulation.h"
#include "tests/model/worn_style.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

using namespace hairpaint;
using namespace hairpaint::model;
using namespace hairpaint::test;

namespace {

// Instrumented code takes many times as long, and what it looks for shows within seconds.
#if defined(HAIRPAINT_ASAN) || defined(HAIRPAINT_TSAN)
constexpr int kStormMinutes = 1;
#else
constexpr int kStormMinutes = 10;
#endif

/// By what fraction the drawn hair that differs most is longer or shorter than it grew; not a number where a position
/// is none.
float worstStretch(const sim::GroupFrame& frame)
{
    const sim::Groom& groom = *frame.groom;
    const auto nodes = static_cast<std::size_t>(groom.nodes);
    float worst = 0.0F;
    for (std::size_t slot = 0; slot < groom.roots->count(); ++slot) {
        if (!groom.isDrawn(slot))
            continue;
        const std::size_t strand = groom.frameStrand(slot);
        float lengthM = 0.0F;
        for (std::size_t node = 1; node < nodes; ++node)
            lengthM += glm::distance(groom.blocks().node(frame.positions, strand, node - 1),
                                     groom.blocks().node(frame.positions, strand, node));
        const float grownM =
            groom.chunks[sim::chunkOf(slot)]->segmentLengths[sim::inChunk(slot)] * static_cast<float>(nodes - 1);
        const float stretch = std::abs(lengthM / grownM - 1.0F);
        if (!(stretch <= worst))
            worst = stretch;
    }
    return worst;
}

/// A head that is shaken as no neck could.
sim::HeadPose shaken(float seconds)
{
    sim::HeadPose pose;
    pose.rotation = glm::angleAxis(1.1F * std::sin(9.0F * seconds), glm::vec3(0.0F, 1.0F, 0.0F)) *
                    glm::angleAxis(0.6F * std::sin(7.0F * seconds), glm::vec3(1.0F, 0.0F, 0.0F));
    pose.positionWo = 0.15F * glm::vec3(std::sin(5.0F * seconds), std::sin(8.0F * seconds), 0.0F);
    return pose;
}

} // namespace

class TestBustMotion : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void tenMinutesOfStormAndShakingStretchNothing()
    {
        constexpr int kHairs = 60;
        constexpr int kFramesPerSecond = 60;
        sim::Simulation simulation;
        simulation.setInput(Document(wearing(QStringLiteral("Long straight"), kHairs)).groomInput());
        sim::StrandFrame frame;
        for (int i = 0; i < kStormMinutes * 60 * kFramesPerSecond; ++i) {
            const float seconds = static_cast<float>(i) / kFramesPerSecond;
            if (i % (5 * kFramesPerSecond) == 0) // From another side every five seconds.
                simulation.setWind({.enabled = true,
                                    .velocity = 25.0F * glm::vec3(std::sin(seconds), 0.3F, std::cos(seconds)),
                                    .gustiness = 1.0F,
                                    .turbulence = 1.0F});
            simulation.setPose(shaken(seconds));
            simulation.advance(1.0 / kFramesPerSecond);
            if (i % kFramesPerSecond != 0)
                continue;
            simulation.writeFrame(frame);
            const float worst = worstStretch(frame.groups.front());
            QVERIFY2(worst < 0.01F, qPrintable(QStringLiteral("%1 after %2 s").arg(worst).arg(seconds)));
        }
    }

    void theSameTimeInOtherSlicesGivesTheSameHair_data()
    {
        QTest::addColumn<int>("framesPerSecond");
        QTest::newRow("24 frames a second") << 24;
        QTest::newRow("144 frames a second") << 144;
    }
    void theSameTimeInOtherSlicesGivesTheSameHair()
    {
        QFETCH(int, framesPerSecond);
        const sim::GroomInput input = Document(wearing(QStringLiteral("Bob"), 500)).groomInput();
        const auto after10s = [&](int perSecond) {
            sim::Simulation simulation;
            simulation.setInput(input);
            simulation.setWind(
                {.enabled = true, .velocity = {4.0F, 0.0F, 2.0F}, .gustiness = 0.6F, .turbulence = 0.4F});
            for (int i = 0; i < 10 * perSecond; ++i)
                simulation.advance(1.0 / perSecond);
            sim::StrandFrame frame;
            simulation.writeFrame(frame);
            return frame.groups.front().positions;
        };
        const std::vector<float> shown = after10s(framesPerSecond);
        const std::vector<float> wanted = after10s(60);
        QCOMPARE(shown.size(), wanted.size());
        float furthestM = 0.0F;
        for (std::size_t i = 0; i < shown.size(); ++i)
            furthestM = std::max(furthestM, std::abs(shown[i] - wanted[i]));
        QVERIFY2(furthestM < 1e-5F, qPrintable(QString::number(furthestM)));
    }
};

HAIRPAINT_TEST(TestBustMotion, Gui)
#include "test_bust_motion.moc"
