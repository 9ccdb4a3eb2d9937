// Every brush of the real window with "hair" and with "skin", mirrored and not: what each changes, and where.
#include "tests/app/long_hair_fixture.h"
#include "tests/support/test_program.h"

namespace hairpaint::app {

using model::ToolId;

class TestWindowTouch : public QObject, private LongHairFixture
{
    Q_OBJECT
private:
    using Maps = std::vector<std::shared_ptr<const sim::TiledRaster>>;
    [[nodiscard]] Maps all()
    {
        Maps maps;
        for (const model::MapSpec& spec : model::mapSpecs())
            maps.push_back(map(spec.kind));
        return maps;
    }
    [[nodiscard]] static bool same(const Maps& a, const Maps& b)
    {
        return std::ranges::equal(a, b, [](const auto& one, const auto& other) { return *one == *other; });
    }
    [[nodiscard]] std::vector<model::SeenStrand> mostlyUnder(QPoint at) { return seenHair()->under(at, 3.0); }

private Q_SLOTS:
    void initTestCase() { prepareApplication(); }
    void cleanup() { m_window.reset(); }

    void aStrokeChangesHairOrSkin_data()
    {
        QTest::addColumn<ToolId>("tool");
        QTest::addColumn<MapKind>("active");
        QTest::addColumn<TouchKind>("touch");
        QTest::addColumn<bool>("mirrored");
        const auto row = [](const char* name, ToolId tool, MapKind active) {
            for (const TouchKind touch : {TouchKind::Hair, TouchKind::Skin})
                for (const bool mirrored : {false, true})
                    QTest::addRow("%s, %s%s", name, touch == TouchKind::Hair ? "hair" : "skin",
                                  mirrored ? ", mirrored" : "")
                        << tool << active << touch << mirrored;
        };
        row("eraser", ToolId::Eraser, MapKind::Length);
        row("comb", ToolId::Comb, MapKind::Direction);
        row("tip colour", ToolId::Brush, MapKind::TipColour);
    }

    void aStrokeChangesHairOrSkin()
    {
        QFETCH(ToolId, tool);
        QFETCH(MapKind, active);
        QFETCH(TouchKind, touch);
        QFETCH(bool, mirrored);
        openWithLongHair();
        if (touch == TouchKind::Skin)
            m_at = hairyPoint();
        editor().target().setMap(active);
        editor().options().setMirror(mirrored);
        setTools(tool, touch);
        const glm::vec2 below = m_window->headView().skinAt(m_at)->uv;
        const std::vector<model::SeenStrand> strands = mostlyUnder(m_at);
        const Maps before = all();
        const int steps = stack().count();
        const QPoint to = m_at + QPoint(tool == ToolId::Comb ? 14 : 0, 16);
        strokeTo(to, false);
        const Maps preview = all();
        QVERIFY(!same(before, preview));
        QTest::mouseRelease(m_head, Qt::LeftButton, {}, to);
        QVERIFY(same(preview, all()));
        QCOMPARE(stack().count(), steps + 1);

        const sim::TiledRaster& was = *before[sim::indexOf(active)];
        const sim::TiledRaster& is = *preview[sim::indexOf(active)];
        const auto differs = [&](glm::vec2 uv) { return is.sampleNearest(uv) != was.sampleNearest(uv); };
        QCOMPARE(differs(below), touch == TouchKind::Skin);
        if (touch == TouchKind::Skin) {
            QCOMPARE(differs(otherSide(below)), mirrored);
        } else {
            QVERIFY(!strands.empty());
            const auto changed =
                std::ranges::count_if(strands, [&](const model::SeenStrand& one) { return differs(one.rootUv); });
            // Where a hair at the parting is mirrored to, the stroke is too.
            std::vector<model::SeenStrand> aside = strands;
            std::erase_if(aside, [](const model::SeenStrand& one) { return std::abs(one.rootHd.x) < 0.005F; });
            QVERIFY(!aside.empty());
            const auto mirroredToo = static_cast<std::size_t>(std::ranges::count_if(
                aside, [&](const model::SeenStrand& one) { return differs(otherSide(one.rootUv)); }));
            const auto most = static_cast<std::ptrdiff_t>(strands.size() / 2);
            QVERIFY2(changed > most, qPrintable(QStringLiteral("%1 of %2").arg(changed).arg(strands.size())));
            QVERIFY(mirrored ? 2 * mirroredToo > aside.size() : 2 * mirroredToo < aside.size());
        }
        session().document().undo();
        QVERIFY(same(before, all()));
    }

    /// Balayage: the colour begins where the strand was touched, in its own map.
    void tipColourBeginsWhereHairIsTouched()
    {
        openWithLongHair();
        editor().target().setMap(MapKind::TipColour);
        setTools(ToolId::Brush, TouchKind::Hair);
        const std::vector<model::SeenStrand> strands = mostlyUnder(m_at);
        QVERIFY(!strands.empty());
        const auto colours = map(MapKind::Colour);
        strokeTo(m_at + QPoint(0, 16));
        QVERIFY(*map(MapKind::Colour) == *colours);
        std::size_t begin = 0;
        for (const model::SeenStrand& one : strands)
            begin +=
                std::abs(map(MapKind::TipStart)->sampleNearest(one.rootUv)[0] / 65535.0F - one.firstFraction) < 0.05F
                    ? 1
                    : 0;
        QVERIFY2(10 * begin > 8 * strands.size(),
                 qPrintable(QStringLiteral("%1 of %2").arg(begin).arg(strands.size())));
        awaitNewestHair();
        // The strand itself is dyed, and only below.
        const sim::GroupFrame& hair = session().frame()->groups.front();
        const sim::StrandStyle& style = hair.groom->style(strands.front().slot);
        QVERIFY(style.tipColour != style.rootColour && style.tipStart > 0.1F);
    }
};

} // namespace hairpaint::app

HAIRPAINT_TEST(hairpaint::app::TestWindowTouch, Widgets)
#include "test_window_touch.moc"
