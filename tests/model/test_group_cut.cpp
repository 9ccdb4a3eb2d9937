// Cuts of all hair of a group: trimmed, to a level, in layers.
#include "model/tools/cutting/group_cut.h"
#include "tests/model/hair_colour.h"
#include "tests/model/side_view.h"
#include "tests/model/tool_studio.h"
#include "tests/model/worn_style.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <array>
#include <cmath>
#include <cstring>

using namespace hairpaint;
using namespace hairpaint::test;

namespace {

constexpr int kSomeHairs = 4000;
constexpr float kErrorM = 0.0005F;

/// A style whose hair has settled.
struct Salon : Studio
{
    explicit Salon(const QString& style) : Salon(wearing(style, kSomeHairs)) {}
    explicit Salon(Project project) : Studio(std::move(project)), before(live.settled(document.groomInput())) {}

    [[nodiscard]] const sim::GroupFrame& was() const { return before->groups.front(); }
    /// The hair once it is cut; roots keep their slots.
    [[nodiscard]] std::shared_ptr<const sim::StrandFrame> now() { return live.settled(document.groomInput(), 0.1); }
    template<class Visit>
    void forEachHair(const Visit& visit)
    {
        const auto after = now();
        for (std::uint32_t slot = 0; slot < was().groom->roots->count(); ++slot)
            if (was().isPositioned(slot))
                visit(slot, was().groom->style(slot).lengthM, after->groups.front().groom->style(slot).lengthM);
    }

    LiveHair live;
    std::shared_ptr<const sim::StrandFrame> before;
};

} // namespace

class TestGroupCut : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void trimmingTakesAsMuchFromEveryHair()
    {
        Salon salon(QStringLiteral("Long straight"));
        const Project untouched = salon.document.project();
        ToolContext context = salon.context();
        GroupCut cut(context, salon.before, QStringLiteral("Trim"));
        QVERIFY(cut.active());
        cut.trim(0.1F, 0.01F);
        cut.trim(0.02F, 0.2F); // Instead of what was shown before.
        const auto preview = salon.shown();
        cut.commit();
        QVERIFY(*salon.shown() == *preview);
        QCOMPARE(salon.document.undoStack().count(), 1);
        QCOMPARE(salon.document.undoStack().undoText(), QStringLiteral("Trim"));
        std::size_t shorter = 0;
        std::size_t off = 0;
        salon.forEachHair([&](std::uint32_t, float lengthM, float isM) {
            const float wantedM = std::max(lengthM - 0.02F, std::min(lengthM, 0.2F));
            shorter += isM < lengthM - 0.01F ? 1 : 0;
            off += std::abs(isM - wantedM) > kErrorM ? 1 : 0;
        });
        QVERIFY(shorter > 100);
        QVERIFY2(off * 100 < salon.was().groom->drawnCount, qPrintable(QString::number(off)));
        salon.document.undo();
        QVERIFY(sameProjects(salon.document.project(), untouched));
    }

    void dyedTipsAreCutOff()
    {
        constexpr float kTrimM = 0.12F;
        Project dyed = wearing(QStringLiteral("Long straight"), kSomeHairs);
        sim::TiledRaster& tips = dyed.groups.front().map(MapKind::TipColour).layers.front().raster;
        for (int index = 0; index < tips.tileCount(); ++index)
            tips.setUniform(index, {65535, 65535, 0, 65535});
        dyed.groups.front().settings.material.tipFrom = 0.5F;
        Salon salon(std::move(dyed));
        const Project untouched = salon.document.project();
        ToolContext context = salon.context();
        GroupCut cut(context, salon.before, QStringLiteral("Trim"));
        cut.trim(kTrimM, 0.0F);
        cut.commit();
        const auto after = salon.now();
        const sim::Groom& was = *salon.was().groom;
        const sim::Groom& is = *after->groups.front().groom;
        std::size_t looked = 0;
        std::size_t off = 0;
        for (std::uint32_t slot = 0; slot < was.roots->count(); ++slot) {
            const float keptM = is.style(slot).lengthM;
            if (!salon.was().isPositioned(slot) || was.style(slot).lengthM - keptM < 0.9F * kTrimM)
                continue;
            for (const float alongM : {0.3F * keptM, 0.8F * keptM, keptM}) {
                ++looked;
                off += std::abs(greenAt(is, slot, alongM) - greenAt(was, slot, alongM)) > 0.04F ? 1 : 0;
            }
        }
        QVERIFY(looked > 300);
        QVERIFY2(off * 50 < looked, qPrintable(QStringLiteral("%1 of %2").arg(off).arg(looked)));
        QCOMPARE(salon.document.undoStack().count(), 1);
        salon.document.undo();
        QVERIFY(sameProjects(salon.document.project(), untouched));
    }

    void cancelledItLeavesNoTrace()
    {
        Salon salon(QStringLiteral("Bob"));
        const Project untouched = salon.document.project();
        ToolContext context = salon.context();
        {
            GroupCut cut(context, salon.before, QStringLiteral("Trim"));
            cut.trim(0.05F, 0.0F);
            QVERIFY(salon.document.previewing());
            cut.cancel();
            QVERIFY(sameProjects(salon.document.project(), untouched));
            QVERIFY(!cut.active());
        }
        {
            GroupCut cut(context, salon.before, QStringLiteral("Trim"));
            cut.trim(0.05F, 0.0F);
        }
        QVERIFY(sameProjects(salon.document.project(), untouched));
        QCOMPARE(salon.document.undoStack().count(), 0);
    }

    void aLevelEndsHairWhereItFirstGoesBelow_data()
    {
        QTest::addColumn<QString>("style");
        QTest::addColumn<float>("levelM");
        QTest::newRow("straight") << QStringLiteral("Long straight") << -0.09F;
        QTest::newRow("ringlets") << QStringLiteral("Ringlets") << -0.05F;
        QTest::newRow("coils") << QStringLiteral("Round afro") << 0.02F;
    }
    void aLevelEndsHairWhereItFirstGoesBelow()
    {
        QFETCH(QString, style);
        QFETCH(float, levelM);
        Salon salon(style);
        ToolContext context = salon.context();
        GroupCut cut(context, salon.before, QStringLiteral("Cut"));
        QVERIFY(cut.lowestHd() < levelM);
        cut.toLevel(levelM);
        cut.commit();
        std::size_t below = 0;
        std::size_t off = 0;
        std::size_t changed = 0;
        salon.forEachHair([&](std::uint32_t slot, float lengthM, float isM) {
            const std::vector<glm::vec3> points = drawnPoints(salon.was(), slot);
            const auto first = std::ranges::find_if(points, [=](glm::vec3 p) { return p.y < levelM; });
            if (first == points.end()) {
                changed += isM == lengthM ? 0 : 1;
                return;
            }
            ++below;
            const float end = isM / lengthM * static_cast<float>(points.size() - 1);
            const std::size_t i = std::min(static_cast<std::size_t>(end), points.size() - 2);
            const float endY = glm::mix(points[i].y, points[i + 1].y, end - static_cast<float>(i));
            off += std::abs(endY - levelM) > 0.002F && isM > 0.0F ? 1 : 0;
        });
        QVERIFY(below > 100);
        QCOMPARE(changed, std::size_t{0});
        QVERIFY2(off * 50 < below, qPrintable(QStringLiteral("%1 of %2").arg(off).arg(below)));
    }

    /// Baby hairs hang nowhere near the line, but among roots of hair that does.
    void noLongHairIsLeftAmongBabyHairs()
    {
        constexpr int kDense = 100000;
        constexpr float kLevelM = -0.1F;
        constexpr float kTooLongM = 0.02F;
        Salon salon(wearing(QStringLiteral("Long straight"), kDense));
        QVERIFY(salon.was().groom->settings.hairline.baby > 0.0F);
        ToolContext context = salon.context();
        GroupCut cut(context, salon.before, QStringLiteral("Cut"));
        cut.toLevel(kLevelM);
        cut.commit();
        std::size_t tooLong = 0;
        salon.forEachHair([&](std::uint32_t slot, float lengthM, float isM) {
            const std::vector<glm::vec3> points = drawnPoints(salon.was(), slot);
            const auto left = static_cast<std::size_t>(isM / lengthM * static_cast<float>(points.size() - 1));
            const std::span<const glm::vec3> cutTo = std::span(points).first(std::min(left + 1, points.size()));
            tooLong += std::ranges::any_of(cutTo, [](glm::vec3 p) { return p.y < kLevelM - kTooLongM; }) ? 1 : 0;
        });
        QCOMPARE(tooLong, std::size_t{0});
    }

    void layersAreShortestAtTheCrown()
    {
        Salon salon(QStringLiteral("Long straight"));
        const sim::HeadLandmarks& marks = *salon.document.project().head->landmarks;
        GradedLengths grade{.topHd = marks[sim::HeadLandmark::Crown],
                            .bottomHd = marks[sim::HeadLandmark::Nape],
                            .topM = 0.1F,
                            .bottomM = 0.25F};
        QCOMPARE(grade.lengthM(grade.topHd), 0.1F);
        QCOMPARE(grade.lengthM(grade.bottomHd), 0.25F);
        ToolContext context = salon.context();
        GroupCut cut(context, salon.before, QStringLiteral("Layers"));
        cut.grade(grade);
        cut.commit();
        std::size_t off = 0;
        salon.forEachHair([&](std::uint32_t slot, float lengthM, float isM) {
            const float wantedM = std::min(lengthM, grade.lengthM(salon.was().groom->roots->positionHd[slot]));
            off += std::abs(isM - wantedM) > kErrorM ? 1 : 0;
        });
        QVERIFY2(off * 100 < salon.was().groom->drawnCount, qPrintable(QString::number(off)));
    }

    void aFadeShortensByMuchTheSameFactorOnItsWayDown()
    {
        const GradedLengths fade{.topHd = {0.0F, 0.1F, 0.0F},
                                 .bottomHd = {0.0F, -0.1F, -0.1F},
                                 .topM = 0.05F,
                                 .bottomM = 0.001F,
                                 .fades = true,
                                 .from = 0.4F,
                                 .to = 0.6F};
        const auto at = [](const GradedLengths& grade, float down) {
            return grade.lengthM({0.05F, glm::mix(grade.topHd.y, grade.bottomHd.y, down), 0.0F});
        };
        QCOMPARE(at(fade, 0.3F), 0.05F);
        QCOMPARE(at(fade, 0.7F), 0.001F);
        constexpr float kStep = 0.025F;
        for (int step = 0; step < 7; ++step) {
            const float down = fade.from + kStep * static_cast<float>(step);
            const float factor = at(fade, down + kStep) / at(fade, down);
            QVERIFY2(factor > 0.5F && factor < 0.7F, qPrintable(QString::number(factor)));
        }
        GradedLengths toNothing = fade;
        toNothing.bottomM = 0.0F;
        QCOMPARE(at(toNothing, 0.7F), 0.0F);
        QVERIFY(at(toNothing, 0.59F) > 0.0F);
        QVERIFY(at(toNothing, 0.5F) < 0.25F * fade.topM);
    }

    /// Hair lies down over what is shorter: lengths that differ evenly would all end in one line.
    void aFadeHasNoEdge()
    {
        Salon salon(QStringLiteral("Side part"));
        const sim::HeadLandmarks& marks = *salon.document.project().head->landmarks;
        ToolContext context = salon.context();
        GroupCut cut(context, salon.before, QStringLiteral("Fade"));
        cut.grade({.topHd = marks[sim::HeadLandmark::Crown],
                   .bottomHd = marks[sim::HeadLandmark::Nape],
                   .topM = 0.05F,
                   .bottomM = 0.001F,
                   .fades = true,
                   .from = 0.1F,
                   .to = 0.75F});
        cut.commit();
        const auto after = salon.live.settled(salon.document.groomInput());
        const sim::GroupFrame& hair = after->groups.front();
        // How much hair covers the back of the head, above the hairline.
        constexpr float kBandM = 0.01F;
        const float lowestM = marks[sim::HeadLandmark::Nape].y + 0.01F;
        std::array<float, 8> coveredM{};
        for (std::uint32_t slot = 0; slot < hair.groom->roots->count(); ++slot) {
            if (!hair.isPositioned(slot) || hair.groom->roots->positionHd[slot].z > marks[sim::HeadLandmark::EarLeft].z)
                continue;
            const std::vector<glm::vec3> points = drawnPoints(hair, slot);
            for (std::size_t i = 1; i < points.size(); ++i)
                if (const float band = (points[i].y - lowestM) / kBandM; band >= 0.0F && band < coveredM.size())
                    coveredM.at(static_cast<std::size_t>(band)) += glm::distance(points[i - 1], points[i]);
        }
        for (std::size_t i = 1; i < coveredM.size(); ++i)
            QVERIFY2(coveredM.at(i) < 2.0F * coveredM.at(i - 1),
                     qPrintable(QStringLiteral("%1: %2 after %3").arg(i).arg(coveredM.at(i)).arg(coveredM.at(i - 1))));
        QVERIFY(coveredM.back() > 4.0F * coveredM.front());
    }

    void onlyWhatIsSelectedIsCut()
    {
        Salon salon(QStringLiteral("Bob"));
        salon.selection.setRectangle(QRectF(0.0, 0.0, 0.5, 1.0));
        ToolContext context = salon.context();
        GroupCut cut(context, salon.before, QStringLiteral("Trim"));
        cut.trim(0.05F, 0.0F);
        cut.commit();
        const sim::RootSet& roots = *salon.was().groom->roots;
        std::size_t shorter = 0;
        salon.forEachHair([&](std::uint32_t slot, float lengthM, float isM) {
            if (roots.uv[slot].x > 0.51F)
                QCOMPARE(isM, lengthM);
            shorter += isM < lengthM ? 1 : 0;
        });
        QVERIFY(shorter > 100);
    }
};

HAIRPAINT_TEST(TestGroupCut, Gui)
#include "test_group_cut.moc"
