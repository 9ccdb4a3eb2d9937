// The help says what tools can be set to.
#include "view/dialogs/help_dialog.h"

#include "model/tools/tool_list.h"
#include "tests/support/test_program.h"
#include "tests/view/panel_fixture.h"

#include <QTextBlock>
#include <QTextBrowser>
#include <QtTest>

using namespace hairpaint;
using namespace hairpaint::view;

class TestHelpDialog : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void every_option_of_every_tool_is_told_with_its_range()
    {
        PanelFixture f;
        const HelpDialog help(f.state, {});
        const QString text = help.text();
        for (const auto& tool : f.state.tools().all())
            QVERIFY2(text.contains(tool->purpose()) && text.contains(tool->hint()), tool->name());
        for (const model::ToolOption* option : model::toolOptions()) {
            QVERIFY2(text.contains(option->labelText()) && text.contains(option->hintText()), option->key);
            if (const auto* choice = std::get_if<model::ToolChoice>(&option->kind))
                for (const model::ToolChoice::Item& entry : choice->entries)
                    QVERIFY2(text.contains(entry.titleText()) && text.contains(model::Tool::tr(entry.hint)),
                             entry.title);
        }
        for (const QString& range : {QStringLiteral(u"0.1\u201330.0 cm"), QStringLiteral(u"0.0\u201310.0 mm"),
                                     QStringLiteral(u"-100\u2013100 %")})
            QVERIFY2(text.contains(range), qPrintable(range));
    }

    void it_opens_at_the_tool_in_hand()
    {
        PanelFixture f;
        HelpDialog help(f.state, {});
        for (const model::ToolId id : {model::ToolId::Comb, model::ToolId::Brush}) {
            f.state.tools().choose(id);
            help.showTopic(HelpDialog::Topic::Tools);
            const auto* browser = help.findChild<QTextBrowser*>();
            QCOMPARE(browser->cursorForPosition(QPoint(4, 8)).block().text(), f.state.tools().active().title());
        }
    }
};

HAIRPAINT_TEST(TestHelpDialog, Widgets)
#include "test_help_dialog.moc"
