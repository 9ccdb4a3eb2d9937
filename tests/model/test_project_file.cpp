// Projects survive being saved and opened.
#include "model/files/project_file.h"

#include <QTemporaryDir>
#include <QTest>

namespace hairpaint::model {

class TestProjectFile : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aNewProjectComesBackAndIsWrittenWithTheSameBytes()
    {
        QTemporaryDir folder;
        const Project project = newProject();
        const QString first = folder.filePath(QStringLiteral("a.hairpaint"));
        const auto saved = saveProject(project, first, {});
        QVERIFY2(saved, qPrintable(saved ? QString() : saved.error().message));
        const auto loaded = loadProject(first);
        QVERIFY2(loaded, qPrintable(loaded ? QString() : loaded.error().message));
        const QString second = folder.filePath(QStringLiteral("b.hairpaint"));
        QVERIFY(saveProject(*loaded, second, {}));
        QFile a(first), b(second);
        QVERIFY(a.open(QIODevice::ReadOnly) && b.open(QIODevice::ReadOnly));
        const QByteArray bytes = a.readAll();
        QCOMPARE(bytes.sliced(38, 23), QByteArray("application/x-hairpaint"));
        QVERIFY(bytes == b.readAll());
    }
};

} // namespace hairpaint::model

QTEST_GUILESS_MAIN(hairpaint::model::TestProjectFile)
#include "test_project_file.moc"
