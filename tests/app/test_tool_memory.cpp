// What the tools were set to, from start to start.
#include "tests/app/window_fixture.h"

#include "tests/support/test_program.h"

namespace hairpaint::app {

class TestToolMemory : public QObject, WindowFixture
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { prepareApplication(); }
    void cleanup() { m_window.reset(); }

    void toolsAreSetAsTheyWereWhenTheProgramEnded()
    {
        openWindow(model::newProject());
        key(Qt::Key_B);
        key(Qt::Key_BracketRight);
        model::ToolSettings settings = editor().tools().settings();
        const float sizeM = settings.brushSizeM;
        QVERIFY(sizeM > model::ToolSettings{}.brushSizeM);
        settings.comb = model::CombKind::Whorl;
        settings.pressureOpacity = true;
        settings.partGapM = 0.004F;
        settings.value(model::MapKind::Gel).scalar = 0.33F; // What is painted with is the project's affair.
        editor().tools().setSettings(settings);
        QVERIFY(m_window->close());
        m_window.reset();
        openWindow(model::newProject());
        const model::ToolSettings again = editor().tools().settings();
        QCOMPARE(again.brushSizeM, sizeM);
        QCOMPARE(again.comb, model::CombKind::Whorl);
        QVERIFY(again.pressureOpacity);
        QCOMPARE(again.partGapM, 0.004F);
        QVERIFY(again.value(model::MapKind::Gel).scalar != 0.33F);
        // What the file holds that can't be is put right.
        SettingsStore().setValue(QStringLiteral("tools/size"), 1e9);
        SettingsStore().setValue(QStringLiteral("tools/comb"), QStringLiteral("nonsense"));
        m_window.reset();
        openWindow(model::newProject());
        QCOMPARE(editor().tools().settings().brushSizeM, 0.3F);
        QCOMPARE(editor().tools().settings().comb, model::CombKind::Lay);
        SettingsStore().clear();
    }
};

} // namespace hairpaint::app

HAIRPAINT_TEST(hairpaint::app::TestToolMemory, Widgets)
#include "test_tool_memory.moc"
