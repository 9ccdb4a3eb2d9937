// `hairpaint new`: what its options change in the project, and what `info` tells of it.
#include "model/files/project_file.h"
#include "tests/app/program.h"

#include <QJsonArray>
#include <QTemporaryDir>
#include <QtTest>

using namespace hairpaint;
using namespace hairpaint::test;

class TestNewCommand : public QObject
{
    Q_OBJECT
private:
    QTemporaryDir m_folder;

    [[nodiscard]] QString path(const char* name) const { return m_folder.filePath(QString::fromLatin1(name)); }

private Q_SLOTS:
    void aLimitThatBitesIsTold_data()
    {
        QTest::addColumn<int>("maxHairs");
        QTest::addColumn<int>("nodes");
        QTest::addColumn<QJsonValue>("limitedBy");
        QTest::addColumn<QString>("words");
        QTest::newRow("none") << 1'000'000 << 8 << QJsonValue() << QString();
        QTest::newRow("the project's") << 1'000 << 8 << QJsonValue(QLatin1String("max_hairs"))
                                       << QStringLiteral("Fewer hairs than painted: the limit of 1,000 ");
        QTest::newRow("memory") << 4'000'000 << 32 << QJsonValue(QLatin1String("memory"))
                                << QStringLiteral("Fewer hairs than painted: memory ");
    }

    void aLimitThatBitesIsTold()
    {
        QFETCH(int, maxHairs);
        QFETCH(int, nodes);
        QFETCH(QJsonValue, limitedBy);
        QFETCH(QString, words);
        model::Project project = model::newProject();
        project.maxHairs = maxHairs;
        sim::GroupSettings& settings = project.groups.front().settings;
        settings.nodesPerHair = nodes;
        settings.greatestDensityPerM2 = nodes == 32 ? 4e6F : 1.5e6F;
        QVERIFY(model::saveProject(project, path("told.hairpaint"), {}));

        const QJsonObject info = infoOf(path("told.hairpaint"));
        QCOMPARE(info.value(QLatin1String("max_hairs")).toInt(), maxHairs);
        const QJsonObject group = info.value(QLatin1String("groups")).toArray().first().toObject();
        QVERIFY(group.contains(QLatin1String("limited_by")));
        QCOMPARE(group.value(QLatin1String("limited_by")), limitedBy);
        const Outcome text = runProgram({QStringLiteral("info"), path("told.hairpaint")}, {}, "en_GB");
        QCOMPARE(text.output.contains(QStringLiteral("Fewer hairs")), !words.isEmpty());
        QVERIFY2(text.output.contains(words), qPrintable(text.output));
    }
};

QTEST_GUILESS_MAIN(TestNewCommand)
#include "test_new_command.moc"
