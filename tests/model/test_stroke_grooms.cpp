// Hair on the bust while a stroke is drawn, when it has ended, and built anew from what it left: the same bytes.
#include "sim/groom/groom.h"
#include "tests/model/head_studio.h"
#include "tests/model/worn_style.h"
#include "tests/sim/groom_bytes.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <array>

using namespace hairpaint;
using namespace hairpaint::test;

namespace {

constexpr int kHairs = 5000;

/// Over the left side of the head, from in front of the crown toward the ear.
constexpr std::array<glm::vec3, 5> kStroke{{{0.030F, 0.10F, 0.02F},
                                            {0.045F, 0.09F, 0.015F},
                                            {0.06F, 0.075F, 0.01F},
                                            {0.07F, 0.055F, 0.0F},
                                            {0.075F, 0.035F, -0.01F}}};

} // namespace

class TestStrokeGrooms : public QObject
{
    Q_OBJECT
private:
    /// Null, or what of the groom differs first between the stroke's last preview, its commit and a new build.
    static const char* differenceAfter(HeadStudio& studio, const QString& tool)
    {
        sim::GroomBuilder builder;
        const auto groomNow = [&] { return builder.update(studio.document.groomInput()).grooms.front(); };
        const auto was = groomNow();
        auto previewed = was;
        ToolContext now = studio.context();
        Tool& hand = studio.tool(tool);
        hand.press(studio.eventAt(kStroke.front()), now);
        for (std::size_t i = 1; i < kStroke.size(); ++i) {
            hand.move(studio.eventAt(kStroke.at(i)), now);
            previewed = groomNow(); // As the window shows every move.
        }
        hand.release(studio.eventAt(kStroke.back()), now);
        const auto committed = groomNow();
        if (differenceOf(*was, *committed) == nullptr)
            return "nothing has been done";
        if (const char* difference = differenceOf(*previewed, *committed))
            return difference;
        const auto anew = sim::GroomBuilder().update(studio.document.groomInput()).grooms.front();
        return differenceOf(*committed, *anew);
    }

private Q_SLOTS:
    void previewCommitAndRebuildAreTheSame_data()
    {
        QTest::addColumn<QString>("style");
        QTest::addColumn<QString>("tool");
        QTest::addColumn<MapKind>("map");
        const auto row = [](const char* style, const QString& tool, MapKind map) {
            QTest::addRow("%s, %s on map %d", style, qPrintable(tool), static_cast<int>(map))
                << QString::fromLatin1(style) << tool << map;
        };
        const QString comb = QStringLiteral("comb");
        const QString eraser = QStringLiteral("eraser");
        row("Bob", comb, MapKind::Direction);
        row("Long straight", comb, MapKind::Direction);
        row("Two plaits", comb, MapKind::Direction);
        for (const MapKind map : {MapKind::Length, MapKind::Curl, MapKind::Clump, MapKind::Gel, MapKind::Colour,
                                  MapKind::Frizz, MapKind::Width, MapKind::Gloss})
            row("Ringlets", kBrush, map);
        row("Two plaits", kBrush, MapKind::Braid);
        row("Two plaits", eraser, MapKind::Braid);
        row("Quiff", eraser, MapKind::Density);
        row("Quiff", eraser, MapKind::Length);
    }
    void previewCommitAndRebuildAreTheSame()
    {
        QFETCH(QString, style);
        QFETCH(QString, tool);
        QFETCH(MapKind, map);
        HeadStudio studio(wearing(style, kHairs));
        studio.map = map;
        studio.settings.brushSizeM = 0.03F;
        studio.settings.value(map).scalar = 0.35F;
        studio.settings.value(map).index = 2;
        const char* difference = differenceAfter(studio, tool);
        QVERIFY2(difference == nullptr, difference);
    }

    void aPartIsTheSameToo()
    {
        HeadStudio studio(wearing(QStringLiteral("Bob"), kHairs));
        Tool& part = studio.tool(QStringLiteral("part"));
        ToolContext now = studio.context();
        sim::GroomBuilder builder;
        std::shared_ptr<const sim::Groom> previewed;
        double seconds = 0.0;
        for (const glm::vec3& positionHd : {kStroke[0], kStroke[1], kStroke[2]}) {
            ToolEvent event = studio.eventAt(positionHd);
            event.seconds = seconds += 10.0;
            part.press(event, now);
            part.release(event, now);
            previewed = builder.update(studio.document.groomInput()).grooms.front();
        }
        part.commit(now);
        const auto committed = builder.update(studio.document.groomInput()).grooms.front();
        const auto anew = sim::GroomBuilder().update(studio.document.groomInput()).grooms.front();
        const char* difference = differenceOf(*previewed, *committed);
        QVERIFY2(difference == nullptr, difference);
        difference = differenceOf(*committed, *anew);
        QVERIFY2(difference == nullptr, difference);
    }
};

HAIRPAINT_TEST(TestStrokeGrooms, Gui)
#include "test_stroke_grooms.moc"
