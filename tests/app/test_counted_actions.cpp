// What a hairdresser does most, from File > New on, by mouse and keys: how many actions each takes. A key pressed, a
// click and a drag are one each.
#include "tests/app/window_fixture.h"
#include "tests/model/side_view.h"
#include "tests/support/test_program.h"
#include "view/dialogs/cut_dialog.h"
#include "view/panels/style_tile.h"

#include <QMenuBar>
#include <QPushButton>

#include <algorithm>

namespace hairpaint::app {

using model::MapKind;

class TestCountedActions : public QObject, private WindowFixture
{
    Q_OBJECT
private:
    int m_actions = 0;

    [[nodiscard]] view::HeadView& head() { return m_window->headView(); }
    [[nodiscard]] const sim::GroupFrame& hair() { return session().frame()->groups.front(); }
    [[nodiscard]] const sim::HeadLandmarks& marks() { return *session().document().project().head->landmarks; }
    [[nodiscard]] std::shared_ptr<const sim::TiledRaster> map(MapKind kind)
    {
        return session().document().resolvedNow(editor().target().group(), kind);
    }

    /// What File > New shows, of fewer hairs: one action, done in another test.
    void begin()
    {
        m_actions = 1;
        openWindow(starterProject());
        editor().options().setMirror(true); // As it is at first.
        awaitNewestHair();
        awaitFinePicture();
    }
    /// The same in another style, by a click on it.
    void beginWith(const char* style)
    {
        m_actions = 2;
        openWithStyle(style);
        editor().options().setMirror(true);
        awaitFinePicture();
    }

    void press(Qt::Key which, Qt::KeyboardModifiers modifiers = {})
    {
        ++m_actions;
        key(which, modifiers);
    }
    void lookFrom(Qt::Key digit, Qt::KeyboardModifiers modifiers)
    {
        press(digit, modifiers | Qt::KeypadModifier);
        awaitFinePicture();
    }
    /// On the 3D area, over what is seen there.
    void dragOver(std::initializer_list<QPointF> way)
    {
        ++m_actions;
        const QPoint from = way.begin()->toPoint();
        QTest::mouseMove(&head(), from);
        QTest::mousePress(&head(), Qt::LeftButton, {}, from);
        constexpr int kSteps = 6;
        for (const QPointF* corner = way.begin() + 1; corner != way.end(); ++corner)
            for (int i = 1; i <= kSteps; ++i)
                QTest::mouseMove(&head(), (corner[-1] + (corner[0] - corner[-1]) * i / kSteps).toPoint());
        QTest::mouseRelease(&head(), Qt::LeftButton, {}, (way.end() - 1)->toPoint());
    }
    [[nodiscard]] QPointF seen(glm::vec3 positionHd) { return head().positionOf(positionHd).value_or(QPointF()); }

    static QAction* entryOf(const QList<QAction*>& entries, const QString& title)
    {
        const auto found = std::ranges::find_if(
            entries, [&](const QAction* one) { return one->text().remove(QLatin1Char('&')) == title; });
        return found != entries.end() ? *found : nullptr;
    }
    /// A click on each.
    void choose(const QStringList& titles)
    {
        QAction* entry = entryOf(m_window->menuBar()->actions(), titles.front());
        QVERIFY2(entry != nullptr, qPrintable(titles.front()));
        ++m_actions;
        QTest::mouseClick(m_window->menuBar(), Qt::LeftButton, {}, m_window->menuBar()->actionGeometry(entry).center());
        for (const QString& title : titles.mid(1)) {
            QMenu* menu = entry->menu();
            QTRY_VERIFY_WITH_TIMEOUT(menu->isVisible(), kPatienceMs);
            entry = entryOf(menu->actions(), title);
            QVERIFY2(entry != nullptr, qPrintable(title));
            ++m_actions;
            QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(entry).center());
        }
    }
    void click(const QString& button)
    {
        const auto dialog = [this] { return m_window->findChild<view::CutDialog*>(); };
        QTRY_VERIFY_WITH_TIMEOUT(dialog() != nullptr, kPatienceMs);
        for (QPushButton* one : dialog()->findChildren<QPushButton*>())
            if (one->text() == button) {
                ++m_actions;
                return QTest::mouseClick(one, Qt::LeftButton);
            }
        QFAIL(qPrintable(button));
    }

    /// Heights of drawn hair's ends, of hairs whose root is as asked.
    template<class Wanted>
    [[nodiscard]] std::vector<float> endsOf(const sim::GroupFrame& frame, const Wanted& wanted)
    {
        std::vector<float> ends;
        for (std::uint32_t slot = 0; slot < frame.groom->roots->count(); ++slot)
            if (frame.isPositioned(slot) && frame.groom->isDrawn(slot) && wanted(frame.groom->roots->positionHd[slot]))
                ends.push_back(test::drawnPoints(frame, slot).back().y);
        std::ranges::sort(ends);
        return ends;
    }
    [[nodiscard]] static float at(const std::vector<float>& sorted, double part)
    {
        return sorted.empty() ? 0.0F : sorted[static_cast<std::size_t>(part * static_cast<double>(sorted.size() - 1))];
    }

private Q_SLOTS:
    void initTestCase() { prepareApplication(); }
    void cleanup() { m_window.reset(); }

    void aNewProjectAndAClickOnAStyleAreTwoActions()
    {
        openWindow(model::newProject());
        key(Qt::Key_N, Qt::ControlModifier);
        const auto style = [this] { return session().document().committed().groups.front(); };
        const model::HairGroup starter = starterProject().groups.front();
        QTRY_VERIFY_WITH_TIMEOUT(style().settings == starter.settings, kPatienceMs);
        for (view::StyleTile* tile : m_window->findChildren<view::StyleTile*>())
            if (tile->text() == QLatin1String("Side part"))
                QTest::mouseClick(tile, Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(stack().count(), 1, kPatienceMs);
        QVERIFY(style().settings != starter.settings);
    }

    void aStraightCutAtTheChinTakesFewerThanTen()
    {
        begin();
        const auto before = session().frame();
        const auto all = [](glm::vec3) { return true; };
        const float chinM = marks()[sim::HeadLandmark::Chin].y;
        QVERIFY(at(endsOf(before->groups.front(), all), 0.5) < chinM - 0.1F);
        choose({QStringLiteral("Hair"), QStringLiteral("Cut"), QStringLiteral("To a level…")});
        click(QStringLiteral("Chin"));
        click(QStringLiteral("Cut"));
        QVERIFY2(m_actions < 10, qPrintable(QString::number(m_actions)));
        awaitNewestHair();
        const std::vector<float> ends = endsOf(hair(), all);
        QVERIFY2(std::abs(at(ends, 0.5) - chinM) < 0.005F && at(ends, 0.05) > chinM - 0.01F,
                 qPrintable(QStringLiteral("%1 %2 %3").arg(at(ends, 0.05)).arg(at(ends, 0.5)).arg(chinM)));
    }

    void aFringeTakesFewerThanSix()
    {
        begin();
        const float hairlineM = marks()[sim::HeadLandmark::Hairline].y;
        const float browsM = glm::mix(hairlineM, marks()[sim::HeadLandmark::NoseTip].y, 0.6F);
        const auto isAtTheSides = [](glm::vec3 rootHd) { return std::abs(rootHd.x) > 0.06F; };
        const std::vector<float> sides = endsOf(hair(), isAtTheSides);
        // One zigzag of the comb, mirrored, brings the hair over the forehead.
        press(Qt::Key_C);
        const auto onTop = [&](float x, float aboveM) {
            const glm::vec3 hairlineHd = marks()[sim::HeadLandmark::Hairline];
            return seen(session()
                            .document()
                            .project()
                            .head->skin->nearest(hairlineHd + glm::vec3(x, aboveM, -0.3F * aboveM))
                            .positionHd);
        };
        dragOver({onTop(0.012F, 0.035F), onTop(0.012F, -0.005F), onTop(0.03F, 0.03F), onTop(0.03F, -0.005F)});
        awaitNewestHair();
        awaitFinePicture();
        press(Qt::Key_K);
        const glm::vec3 browsHd(0.0F, browsM, marks()[sim::HeadLandmark::NoseTip].z);
        dragOver({seen(browsHd + glm::vec3(-0.05F, 0.0F, 0.0F)), seen(browsHd + glm::vec3(0.05F, 0.0F, 0.0F))});
        QVERIFY2(m_actions < 6, qPrintable(QString::number(m_actions)));
        QCOMPARE(stack().count(), 2);
        awaitNewestHair();
        const glm::vec3 hairlineHd = marks()[sim::HeadLandmark::Hairline];
        const std::vector<float> fringe = endsOf(hair(), [&](glm::vec3 rootHd) {
            return std::abs(rootHd.x) < 0.02F && std::abs(rootHd.z - hairlineHd.z) < 0.015F &&
                   rootHd.y > hairlineHd.y - 0.01F;
        });
        QVERIFY(fringe.size() > 10);
        QVERIFY2(std::abs(at(fringe, 0.5) - browsM) < 0.02F,
                 qPrintable(QStringLiteral("%1 %2").arg(at(fringe, 0.5)).arg(browsM)));
        const std::vector<float> sidesAfter = endsOf(hair(), isAtTheSides);
        QVERIFY2(std::abs(at(sidesAfter, 0.3) - at(sides, 0.3)) < 0.02F,
                 qPrintable(QStringLiteral("%1 %2").arg(at(sidesAfter, 0.3)).arg(at(sides, 0.3))));
    }

    void balayageTakesFewerThanTwelve()
    {
        begin();
        press(Qt::Key_7);
        QCOMPARE(editor().target().map(), MapKind::TipColour);
        press(Qt::Key_B);
        const auto colours = map(MapKind::Colour);
        // Level strokes over the lengths, from the front and from behind, mirrored.
        const auto over = [&](float x, float heightM) { return seen({x, heightM, 0.0F}); };
        const float chinM = marks()[sim::HeadLandmark::Chin].y;
        dragOver({over(0.04F, chinM), over(0.11F, chinM - 0.01F)});
        lookFrom(Qt::Key_1, Qt::ControlModifier);
        dragOver({over(0.0F, chinM - 0.02F), over(0.11F, chinM - 0.02F)});
        lookFrom(Qt::Key_3, Qt::ControlModifier);
        const auto across = [&](float z) { return seen({0.0F, chinM - 0.02F, z}); };
        dragOver({across(-0.08F), across(0.06F)});
        QVERIFY2(m_actions < 12, qPrintable(QString::number(m_actions)));
        QCOMPARE(stack().count(), 3);
        QVERIFY(*map(MapKind::Colour) == *colours);
        awaitNewestHair();
        // Dyed hair is of its own colour at the root, and begins to change where it was touched.
        std::vector<float> starts;
        std::size_t drawn = 0;
        for (std::uint32_t slot = 0; slot < hair().groom->roots->count(); ++slot) {
            if (!hair().isPositioned(slot) || !hair().groom->isDrawn(slot))
                continue;
            ++drawn;
            const sim::StrandStyle& style = hair().groom->style(slot);
            if (style.tipColour != style.rootColour)
                starts.push_back(style.tipStart);
        }
        std::ranges::sort(starts);
        QVERIFY2(starts.size() > drawn / 6, qPrintable(QStringLiteral("%1 of %2").arg(starts.size()).arg(drawn)));
        QVERIFY2(at(starts, 0.1) > 0.2F && at(starts, 0.9) < 0.95F,
                 qPrintable(QStringLiteral("%1 %2").arg(at(starts, 0.1)).arg(at(starts, 0.9))));
    }

    void layersTakeFewerThanEight()
    {
        begin();
        const glm::vec3 crownHd = marks()[sim::HeadLandmark::Crown];
        const auto longest = [&](float nearM, float farM) {
            float lengthM = 0.0F;
            for (std::uint32_t slot = 0; slot < hair().groom->roots->count(); ++slot) {
                const float awayM = glm::distance(hair().groom->roots->positionHd[slot], crownHd);
                if (hair().isPositioned(slot) && awayM > nearM && awayM < farM)
                    lengthM = std::max(lengthM, hair().groom->style(slot).lengthM);
            }
            return lengthM;
        };
        const float crownM = longest(0.0F, 0.03F);
        const float napeM = longest(0.1F, 0.3F);
        choose({QStringLiteral("Hair"), QStringLiteral("Cut"), QStringLiteral("Layers…")});
        click(QStringLiteral("Cut"));
        QVERIFY2(m_actions < 8, qPrintable(QString::number(m_actions)));
        awaitNewestHair();
        QVERIFY2(longest(0.0F, 0.03F) < 0.75F * crownM, qPrintable(QString::number(longest(0.0F, 0.03F) / crownM)));
        QVERIFY(longest(0.1F, 0.3F) > 0.9F * napeM);
    }

    void aFadeTakesFewerThanTwelve()
    {
        beginWith("side-part");
        choose({QStringLiteral("Hair"), QStringLiteral("Cut"), QStringLiteral("Fade…")});
        click(QStringLiteral("Cut"));
        QVERIFY2(m_actions < 12, qPrintable(QString::number(m_actions)));
        awaitNewestHair();
        const auto meanLengthM = [this](float lowM, float highM) {
            float sumM = 0.0F;
            float count = 0.0F;
            for (std::uint32_t slot = 0; slot < hair().groom->roots->count(); ++slot) {
                const float heightM = hair().groom->roots->positionHd[slot].y;
                if (hair().isPositioned(slot) && heightM > lowM && heightM < highM) {
                    sumM += hair().groom->style(slot).lengthM;
                    count += 1.0F;
                }
            }
            return sumM / std::max(count, 1.0F);
        };
        const float earsM = marks()[sim::HeadLandmark::EarLeft].y;
        const float crownM = marks()[sim::HeadLandmark::Crown].y;
        const float low = meanLengthM(earsM - 0.05F, earsM + 0.01F);
        const float middle = meanLengthM(glm::mix(earsM, crownM, 0.5F), glm::mix(earsM, crownM, 0.7F));
        const float top = meanLengthM(glm::mix(earsM, crownM, 0.9F), 1.0F);
        QVERIFY2(low < 0.006F && middle > low && top > 0.03F,
                 qPrintable(QStringLiteral("%1 %2 %3").arg(low).arg(middle).arg(top)));
    }
};

} // namespace hairpaint::app

HAIRPAINT_TEST(hairpaint::app::TestCountedActions, Widgets)
#include "test_counted_actions.moc"
