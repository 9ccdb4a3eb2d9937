// What the tools were set to, from start to start.
#include "tests/app/window_fixture.h"

#include "tests/support/test_program.h"

#include <QByteArray>

#include <cmath>
#include <map>
#include <variant>

namespace hairpaint::app {

class TestToolMemory : public QObject, WindowFixture
{
    Q_OBJECT
private:
    /// Half the greatest, or as much less where that is what it is; the other, or the last, of switches and choices.
    [[nodiscard]] static double otherThan(const model::ToolOption& option, double value)
    {
        if (const auto* number = std::get_if<model::ToolNumber>(&option.kind)) {
            const double half = 0.5 * number->greatest / number->shownPerSi();
            return std::abs(value - half) > 1e-6 ? half : 0.5 * half;
        }
        if (const auto* choice = std::get_if<model::ToolChoice>(&option.kind)) {
            const auto last = static_cast<double>(choice->entries.size()) - 1.0;
            return value != last ? last : 0.0;
        }
        return 1.0 - value;
    }

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

    /// Whatever tools there are.
    void everyOptionOfEveryToolIsKept()
    {
        openWindow(model::newProject());
        model::ToolSettings settings = editor().tools().settings();
        std::map<QByteArray, double> wanted;
        for (const auto& tool : editor().tools().all())
            for (const model::ToolOption* option : tool->options()) {
                if (std::holds_alternative<model::ToolValue>(option->kind) || wanted.contains(option->key))
                    continue;
                const double before = optionOf(settings, *option);
                putOption(settings, *option, otherThan(*option, before));
                wanted[option->key] = optionOf(settings, *option);
                QVERIFY2(wanted[option->key] != before, option->key);
            }
        for (const char* newest :
             {"fingers", "finger_strength", "grab", "cut", "cut_through", "comb", "touch", "shape"})
            QVERIFY2(wanted.contains(newest), newest);
        editor().tools().setSettings(settings);
        QVERIFY(m_window->close());
        m_window.reset();
        openWindow(model::newProject());
        for (const auto& tool : editor().tools().all())
            for (const model::ToolOption* option : tool->options())
                if (const auto row = wanted.find(option->key); row != wanted.end())
                    QVERIFY2(std::abs(optionOf(editor().tools().settings(), *option) - row->second) < 1e-6,
                             option->key);
        SettingsStore().clear();
    }
};

} // namespace hairpaint::app

HAIRPAINT_TEST(hairpaint::app::TestToolMemory, Widgets)
#include "test_tool_memory.moc"
