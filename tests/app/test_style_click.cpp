// A click on a style in the real window: it is about the scalp, and what grows on the face stays.
#include "tests/app/window_fixture.h"
#include "tests/support/test_program.h"
#include "view/panels/style_question.h"
#include "view/panels/style_tile.h"

#include <algorithm>

namespace hairpaint::app {

class TestStyleClick : public QObject, private WindowFixture
{
    Q_OBJECT
private:
    /// A bald head with the hair of a face, and a beard that somebody painted.
    static model::Project bearded()
    {
        model::Project project = model::newProject();
        for (const char* name : {"Beard", "Brows", "Lashes"}) {
            project.groups.push_back(model::makeGroup(project, QString::fromLatin1(name), 256));
            sim::TiledRaster& density = project.groups.back().map(model::MapKind::Density).layers.front().raster;
            density.setUniform(5, {20000, 65535});
        }
        return project;
    }

    [[nodiscard]] std::vector<model::HairGroup> groups() { return session().document().committed().groups; }

    [[nodiscard]] view::StyleTile* bob()
    {
        for (view::StyleTile* tile : m_window->findChildren<view::StyleTile*>())
            if (tile->text() == QLatin1String("Bob"))
                return tile;
        return nullptr;
    }

    /// As from a file that is dropped on the window.
    void putOn(const model::Preset& style)
    {
        Q_EMIT m_window->findChild<StyleFiles*>()->wanted(std::make_shared<const model::Preset>(style));
    }

private Q_SLOTS:
    void initTestCase() { prepareApplication(); }
    void cleanup() { m_window.reset(); }

    void leavesBeardBrowsAndLashes()
    {
        openWindow(bearded());
        const auto before = groups();
        QTest::mouseClick(bob(), Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(stack().count(), 1, kPatienceMs);
        const auto after = groups();
        QCOMPARE(after.size(), before.size());
        QVERIFY(!(after[0] == before[0]));
        QVERIFY(std::equal(after.begin() + 1, after.end(), before.begin() + 1));
        QTest::mouseClick(bob(), Qt::LeftButton, Qt::ShiftModifier);
        QTRY_COMPARE_WITH_TIMEOUT(stack().count(), 2, kPatienceMs);
        QCOMPARE(stack().undoText(), QStringLiteral("Style \"Bob\" (colour only)"));
    }

    void asksWhereAStyleFromAFileHasABeardToo_data()
    {
        QTest::addColumn<bool>("areHidden");
        QTest::newRow("in the strip") << false;
        QTest::newRow("which is shown for it") << true;
    }
    void asksWhereAStyleFromAFileHasABeardToo()
    {
        QFETCH(bool, areHidden);
        openWindow(bearded());
        model::Project other = bearded();
        other.groups[0].map(model::MapKind::Density).layers.front().raster.setUniform(3, {50000, 65535});
        const auto before = groups();
        if (areHidden)
            key(Qt::Key_Tab);
        m_window->paintView().setFocus();
        putOn(model::presetFrom(other, QStringLiteral("Look")));
        auto* question = m_window->findChild<view::StyleQuestion*>();
        QVERIFY(question->isVisible());
        QVERIFY(question->isAncestorOf(QApplication::focusWidget()));
        QCOMPARE(stack().count(), 0);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
        QVERIFY(!question->isVisible());
        QVERIFY(m_window->paintView().hasFocus());
        QCOMPARE(stack().count(), 1);
        const auto after = groups();
        QVERIFY(!(after[0] == before[0]));
        QVERIFY(std::equal(after.begin() + 1, after.end(), before.begin() + 1));
    }
};

} // namespace hairpaint::app

HAIRPAINT_TEST(hairpaint::app::TestStyleClick, Widgets)
#include "test_style_click.moc"
