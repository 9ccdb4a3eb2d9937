// What the rows of tools' options say: what new settings have, what undo and the status bar call a choice.
#include "tests/model/tool_studio.h"
#include "tests/support/test_program.h"

#include <QSet>
#include <QTest>

using namespace hairpaint;
using namespace hairpaint::model;
using namespace hairpaint::test;

class TestToolRows : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void newSettingsAreWhatTheRowsSay()
    {
        const ToolSettings fresh;
        for (const ToolOption* row : toolOptions()) {
            QVERIFY2(std::abs(optionOf(fresh, *row) - standardOf(*row)) < 1e-6, row->key);
            if (const auto* number = std::get_if<ToolNumber>(&row->kind))
                QVERIFY2(number->least <= number->standard && number->standard <= number->greatest, row->key);
            ToolSettings other = fresh;
            putOption(other, *row, standardOf(*row) + 1.0);
            putOption(other, *row, standardOf(*row));
            QVERIFY2(other == fresh, row->key);
        }
        QCOMPARE(fresh.brushSizeM, 0.03F);
        QCOMPARE(fresh.partReachM, 0.1F);
        QCOMPARE(fresh.partGapM, 0.001F);
        QCOMPARE(fresh.cutFraction, 1.0F);
        QCOMPARE(fresh.shape, ShapeKind::Ellipse);
        QVERIFY(fresh.pressureSize && !fresh.pressureOpacity);
    }

    void oneToolIsFirstOneErasesAndOneSelects()
    {
        for (const auto trait : {&ToolTraits::isFirst, &ToolTraits::erases, &ToolTraits::selects})
            QCOMPARE(std::ranges::count_if(makeTools(), [trait](const auto& tool) { return tool->traits().*trait; }),
                     1);
    }

    void everyChoiceOfAToolIsToldApart_data()
    {
        QTest::addColumn<QString>("tool");
        QTest::addColumn<QStringList>("steps");
        const QString none;
        QTest::newRow("comb") << QStringLiteral("comb")
                              << QStringList{none,
                                             QStringLiteral("Lift hair"),
                                             QStringLiteral("Comb hair smooth"),
                                             QStringLiteral("Ruffle hair"),
                                             QStringLiteral("Lay a whorl"),
                                             QStringLiteral("Hold as it lies")};
        QTest::newRow("fingers") << QStringLiteral("fingers")
                                 << QStringList{QStringLiteral("Puff hair"), QStringLiteral("Pinch hair"),
                                                QStringLiteral("Spread hair"), QStringLiteral("Smooth hair")};
        QTest::newRow("grab") << QStringLiteral("grab") << QStringList{none, none};
        QTest::newRow("scissors") << QStringLiteral("scissors") << QStringList(3, QStringLiteral("Cut hair"));
    }
    /// By what undo says, and by a hint of its own; a tool's hint is that of its first choice.
    void everyChoiceOfAToolIsToldApart()
    {
        QFETCH(QString, tool);
        QFETCH(QStringList, steps);
        Studio studio;
        const Tool& one = studio.tool(tool);
        const ToolOption& row = *one.options().front();
        QSet<QString> hints;
        for (qsizetype i = 0; i < steps.size(); ++i) {
            putOption(studio.settings, row, static_cast<double>(i));
            QCOMPARE(one.stepFor(studio.settings), steps[i]);
            hints.insert(one.hintFor(studio.settings));
            if (i == 0)
                QCOMPARE(one.hintFor(studio.settings), one.hint());
        }
        QCOMPARE(hints.size(), tool == QLatin1StringView("scissors") ? 2 : steps.size());
        QCOMPARE(std::get<ToolChoice>(row.kind).entries.size(), static_cast<std::size_t>(steps.size()));
    }
};

HAIRPAINT_TEST(TestToolRows, Gui)
#include "test_tool_rows.moc"
