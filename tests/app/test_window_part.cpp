// Parting hair in the real window, in both areas.
#include "sim/groom/direction_texel.h"
#include "sim/skin/skin_frame.h"
#include "tests/app/window_fixture.h"
#include "tests/support/test_program.h"
#include "view/widgets/bar_slider.h"

#include <QLabel>

#include <algorithm>

namespace hairpaint::app {

class TestWindowPart : public QObject, private WindowFixture
{
    Q_OBJECT
private:
    QWidget* m_area = nullptr;
    std::vector<QPoint> m_points; ///< Where the curve is clicked.

    /// A project with hair; the Part tool, and three points up the picture.
    void open(bool onTheHead)
    {
        model::Project project = model::newProject();
        sim::TiledRaster& density = project.groups.front().map(model::MapKind::Density).layers.front().raster;
        for (int index = 0; index < density.tileCount(); ++index)
            density.setUniform(index, {65535, 65535, 0, 0});
        openWindow(std::move(project));
        key(Qt::Key_P);
        QCOMPARE(editor().tools().active().id(), model::ToolId::Part);
        QCOMPARE(editor().target().map(), model::MapKind::Direction);
        m_points.clear();
        for (const float v : {0.3F, 0.4F, 0.5F}) {
            const auto [area, at] = onTheHead ? onHead(0.5F, v) : std::pair(paper(), paintPoint(0.5F, v));
            m_area = area;
            m_points.push_back(at);
        }
    }
    [[nodiscard]] QWidget* paper() { return &m_window->paintView(); }
    void click(QPoint at)
    {
        QTest::mouseMove(m_area, at);
        QTest::mouseClick(m_area, Qt::LeftButton, {}, at);
    }
    void clickAll()
    {
        for (const QPoint at : m_points)
            click(at);
    }
    [[nodiscard]] qsizetype handles()
    {
        qsizetype count = 0;
        for (const model::OverlayShape& shape : editor().tools().overlay())
            count += shape.uvHandles.size();
        return count;
    }
    /// To which side hair beside the middle falls, and how much is left there.
    [[nodiscard]] float sidewaysAt(float u, float v)
    {
        const model::HairGroup& group = session().document().project().groups.front();
        const sim::TiledRaster& layer = group.map(model::MapKind::Direction).layers.front().raster;
        const auto point = session().document().project().head->skin->atUv({u, v});
        return sim::SkinFrame::at(*point).toHd(sim::directionOf(layer.sampleNearest({u, v}))).x;
    }
    [[nodiscard]] int densityAt(float u, float v)
    {
        const model::Id group = session().document().project().groups.front().id;
        return session().document().resolvedNow(group, model::MapKind::Density)->sampleNearest({u, v})[0];
    }
    void inBothAreas()
    {
        QTest::addColumn<bool>("onTheHead");
        QTest::newRow("on the paper") << false;
        QTest::newRow("on the head") << true;
    }

private Q_SLOTS:
    void initTestCase() { prepareApplication(); }
    void cleanup() { m_window.reset(); }

    void aPartIsClickedAndKeptWithEnter_data() { inBothAreas(); }
    void aPartIsClickedAndKeptWithEnter()
    {
        QFETCH(bool, onTheHead);
        open(onTheHead);
        const QByteArray before = savedBytes("part-before.hairpaint");
        clickAll();
        QCOMPARE(handles(), qsizetype{3});
        QVERIFY(editor().tools().stroking());
        QVERIFY(savedBytes("part-shown.hairpaint") == before);
        const auto check = [this] {
            QVERIFY(sidewaysAt(0.53F, 0.4F) > 0.6F);
            QVERIFY(sidewaysAt(0.47F, 0.4F) < -0.6F);
            int least = 65535; // A pixel may be mm on skin that is seen from the side.
            for (int i = -10; i <= 10; ++i)
                least = std::min(least, densityAt(0.5F + 0.001F * static_cast<float>(i), 0.4F));
            QVERIFY(least < 20000);
            QCOMPARE(densityAt(0.53F, 0.4F), 65535);
        };
        check();
        QTest::keyClick(m_area, Qt::Key_Return);
        QVERIFY(!editor().tools().stroking());
        QCOMPARE(stack().count(), 1);
        QCOMPARE(stack().text(0), QStringLiteral("Part"));
        QCOMPARE(editor().target().map(), model::MapKind::Direction);
        check();
        key(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(savedBytes("part-undone.hairpaint") == before);
    }

    void aHandleIsDragged_data() { inBothAreas(); }
    void aHandleIsDragged()
    {
        QFETCH(bool, onTheHead);
        open(onTheHead);
        clickAll();
        QVERIFY(sidewaysAt(0.53F, 0.4F) > 0.6F);
        const QPoint to = onTheHead ? onHead(0.57F, 0.4F).second : paintPoint(0.57F, 0.4F);
        drag(*m_area, m_points[1] + QPoint(2, 1), to);
        QCOMPARE(handles(), qsizetype{3});
        QVERIFY(sidewaysAt(0.53F, 0.4F) < -0.6F);
        QCOMPARE(densityAt(0.5F, 0.4F), 65535);
        key(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(editor().tools().stroking());
        QVERIFY(sidewaysAt(0.53F, 0.4F) > 0.6F);
    }

    void keysTakePointsBackAndEscAllOfIt_data() { inBothAreas(); }
    void keysTakePointsBackAndEscAllOfIt()
    {
        QFETCH(bool, onTheHead);
        open(onTheHead);
        const QByteArray before = savedBytes("part-before.hairpaint");
        clickAll();
        QTest::mouseMove(m_area, m_points[1] + QPoint(60, 0));
        QTest::keyClick(m_area, Qt::Key_Delete); // It would clear the layer.
        QCOMPARE(handles(), qsizetype{2});
        QTest::keyClick(m_area, Qt::Key_Backspace);
        QCOMPARE(handles(), qsizetype{1});
        key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(handles(), qsizetype{2});
        QTest::keyClick(m_area, Qt::Key_Escape);
        QVERIFY(!editor().tools().stroking());
        QCOMPARE(stack().count(), 0);
        QVERIFY(savedBytes("part-after.hairpaint") == before);
        QCOMPARE(sidewaysAt(0.53F, 0.4F), 0.0F);
    }

    void undoShowsAtOnceWhatIsLeft()
    {
        open(true);
        click(m_points[0]);
        click(m_points[1]);
        const auto says = [this](const QString& hint) {
            const auto labels = m_window->findChildren<QLabel*>();
            return std::ranges::any_of(labels, [&](const QLabel* label) { return label->text() == hint; });
        };
        QTest::mouseMove(m_area, m_points[1] + QPoint(0, 40));
        const QString before = editor().tools().active().hint();
        QVERIFY(says(before));
        key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(handles(), qsizetype{1});
        const QString after = editor().tools().active().hint();
        QVERIFY(after != before);
        QVERIFY(says(after));
        QTest::keyClick(m_area, Qt::Key_Escape);
    }

    void aDoubleClickOrAnotherToolKeepsIt()
    {
        open(true);
        clickAll();
        QTest::mouseDClick(m_area, Qt::LeftButton, {}, m_points.back());
        QVERIFY(!editor().tools().stroking());
        QCOMPARE(stack().count(), 1);
        clickAll();
        key(Qt::Key_B);
        QVERIFY(!editor().tools().stroking());
        QCOMPARE(stack().text(1), QStringLiteral("Part"));
        QVERIFY(editor().target().map() != model::MapKind::Direction); // The brush goes on where it was.
    }

    void itsOptionsShowAtOnce()
    {
        open(false);
        clickAll();
        QVERIFY(densityAt(0.5F, 0.4F) < 20000);
        const auto slider = [this](const QString& label) {
            const auto all = m_window->findChildren<view::BarSlider*>();
            return *std::ranges::find(all, label, [](const view::BarSlider* one) { return one->label(); });
        };
        view::BarSlider* gap = slider(QStringLiteral("Gap"));
        QVERIFY(gap->isVisible());
        QTest::mouseClick(gap, Qt::LeftButton, {}, QPoint(0, gap->height() / 2));
        QCOMPARE(densityAt(0.5F, 0.4F), 65535);
        QVERIFY(editor().tools().stroking());
        QVERIFY(slider(QStringLiteral("Zigzag"))->isVisible());
        QVERIFY(slider(QStringLiteral("Reach"))->isVisible());
    }
};

} // namespace hairpaint::app

HAIRPAINT_TEST(hairpaint::app::TestWindowPart, Widgets)
#include "test_window_part.moc"
