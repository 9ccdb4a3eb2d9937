// What people type is found in names, whatever its case, accents and order; styles lie in the folders of their tags.
#include "model/files/preset_file.h"
#include "model/styles/style_folder.h"
#include "model/values/search_text.h"
#include "tests/support/test_program.h"

#include <QtTest>

using namespace hairpaint;
using Kind = model::StyleFolder::Kind;

class TestSearchText : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void words_are_found_data()
    {
        QTest::addColumn<QString>("words");
        QTest::addColumn<bool>("found");
        QTest::newRow("nothing is everywhere") << QString() << true;
        QTest::newRow("only spaces are nothing") << QStringLiteral("  ") << true;
        QTest::newRow("the name") << QStringLiteral("Dos trenzas") << true;
        QTest::newRow("a part of a word") << QStringLiteral("tren") << true;
        QTest::newRow("any order") << QStringLiteral("trenzas dos") << true;
        QTest::newRow("another case") << QStringLiteral("TRENZAS") << true;
        QTest::newRow("without accents") << QStringLiteral("corton") << true;
        QTest::newRow("with accents that are not there") << QStringLiteral("dós") << true;
        QTest::newRow("name and tag") << QStringLiteral("dos cortón") << true;
        QTest::newRow("composed otherwise") << QStringLiteral("corto\u0301n") << true;
        QTest::newRow("another word") << QStringLiteral("dos rizos") << false;
    }
    void words_are_found()
    {
        QFETCH(QString, words);
        QFETCH(bool, found);
        QCOMPARE(model::isFound(words, {QStringLiteral("Dos trenzas"), QStringLiteral("cortón")}), found);
    }

    void a_style_lies_in_the_folder_of_each_tag()
    {
        const auto kinds = [](const QStringList& tags, bool own) {
            QStringList titles;
            for (const model::StyleFolder& folder : model::styleFolders())
                if (model::liesIn(folder, tags, own))
                    titles.append(QLatin1StringView(folder.title));
            return titles.join(QLatin1Char(' '));
        };
        QCOMPARE(model::styleFolders().front().kind, Kind::All);
        QCOMPARE(kinds({QStringLiteral("short"), QStringLiteral("coily")}, false),
                 QStringLiteral("All Short Curly and coily"));
        QCOMPARE(kinds({QStringLiteral("braided"), QStringLiteral("long")}, true),
                 QStringLiteral("All Long Tied Mine"));
        QCOMPARE(kinds({}, true), QStringLiteral("All Mine"));
    }

    void every_built_in_style_lies_in_a_tagged_folder()
    {
        for (const model::PresetEntry& entry : model::listPresets({}))
            QVERIFY2(std::ranges::any_of(model::styleFolders(),
                                         [&](const model::StyleFolder& folder) {
                                             return folder.kind == Kind::Tagged &&
                                                    model::liesIn(folder, entry.tags, false);
                                         }),
                     qPrintable(entry.name));
    }
};

HAIRPAINT_TEST(TestSearchText, Core)
#include "test_search_text.moc"
